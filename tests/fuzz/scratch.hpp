// Scratch: a directory of this process, for readers that take a file's name.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace shade16::fuzz {

class Scratch {
public:
    Scratch() {
        std::string pattern = (std::filesystem::temp_directory_path() / "shade16-fuzz-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) std::abort();
        directory_ = pattern;
    }
    ~Scratch() { std::filesystem::remove_all(directory_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    std::string path(const char* name) const { return (directory_ / name).string(); }
    std::string write(const char* name, const uint8_t* data, std::size_t size) const {
        std::ofstream(path(name), std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
        return path(name);
    }
    void copy(const char* from, const char* name) const { std::filesystem::copy_file(from, path(name)); }

private:
    std::filesystem::path directory_{};
};

}  // namespace shade16::fuzz
