// What a test needs of the machine: absent, the test is skipped with that reason, unless SHADE16_REQUIRE_ALL asks for every one.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace shade16::host {

/// Whether what a test needs is here; if not and SHADE16_REQUIRE_ALL is 1, the test fails.
inline bool is_here(bool found, const std::string& name) {
    const char* all = std::getenv("SHADE16_REQUIRE_ALL");
    EXPECT_TRUE(found || all == nullptr || std::string_view(all) != "1") << name << " is not here, and SHADE16_REQUIRE_ALL is set.";
    return found;
}
inline bool has_file(const std::string& path) { return is_here(std::filesystem::exists(path), path); }
inline bool has_program(const std::string& name) {
    return is_here(std::system(("command -v " + name + " >/dev/null 2>&1").c_str()) == 0, name);
}

}  // namespace shade16::host
