// A directory of its own for each test, gone afterwards; and the rule for tests that need a program.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "host_sim/error.hpp"

namespace shade16::host {

class ScratchDirectory {
public:
    ScratchDirectory() {
        std::string pattern = (std::filesystem::temp_directory_path() / "shade16-test-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) std::abort();
        path_ = pattern;
    }
    ~ScratchDirectory() { std::filesystem::remove_all(path_); }
    ScratchDirectory(const ScratchDirectory&) = delete;
    ScratchDirectory& operator=(const ScratchDirectory&) = delete;

    std::string path(const std::string& name) const { return (path_ / name).string(); }

    std::string write(const std::string& name, std::string_view text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

    std::string read(const std::string& name) const {
        std::ifstream file(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(path_))
            all.push_back(entry.path().filename().string());
        std::sort(all.begin(), all.end());
        return all;
    }

private:
    std::filesystem::path path_{};
};

/// What `action` complains about, and with which exit code: "2: no faces".
template <class Action>
std::string complaint(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return std::to_string(static_cast<int>(error.code)) + ": " + error.what();
    }
    return "no complaint";
}

inline std::filesystem::path source_directory() {
    return std::filesystem::path(__FILE__).parent_path().parent_path().parent_path();
}

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
