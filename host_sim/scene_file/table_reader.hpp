// TableReader: one table of a scene file, read key by key. Whatever is wrong is said in one sentence with the line.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/error.hpp"
#include "host_sim/scene_file/toml_value.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

/// A closed range for a number, and whether the ends themselves belong to it.
struct Range {
    double least = 0, largest = 0;
    bool without_least = false, without_largest = false;

    bool holds(double v) const {
        return (without_least ? v > least : v >= least) && (without_largest ? v < largest : v <= largest);
    }
    std::string text() const;
};

inline constexpr Range coordinates{-16384, 16384};  // the core's domain

class TableReader {
public:
    /// `what` is the table in messages: "material 'brass'". A key that is not among `known` is refused at once.
    TableReader(std::string file, std::string what, const TomlValue& table, std::vector<std::string> known);

    const std::string& file() const { return file_; }
    int line() const { return line_; }
    int line_of(const std::string& key) const;  // the table's own if the key is absent
    bool has(const std::string& key) const { return find(key) != nullptr; }

    // Each leaves `value` as it is, the default, when the key is absent.
    void read(const std::string& key, bool& value) const;
    void read(const std::string& key, std::string& value) const;
    void read(const std::string& key, int& value, int least, int largest) const;
    void read(const std::string& key, double& value, Range range) const;
    void read(const std::string& key, Q16& value, Range range) const;
    void read(const std::string& key, Scaled& value, Range range) const;
    void read(const std::string& key, Vec3& value, Range range) const;
    void read(const std::string& key, std::array<double, 3>& value, Range range) const;
    void read(const std::string& key, Rgb& value) const;
    void read(const std::string& key, std::vector<Rgb>& value) const;
    /// [width, height]
    void read(const std::string& key, Viewport& value) const;
    /// One of several words; returns its place among them.
    std::optional<std::size_t> word(const std::string& key, const std::vector<std::string>& words) const;

    /// One number for all axes, or three.
    void read_scale(const std::string& key, Vec3& value, Range range) const;

    /// "scene.toml:12: 'fov' in the camera: <complaint>."
    Error wrong(const std::string& key, const std::string& complaint) const;
    Error missing(const std::string& key, const std::string& expected) const;

    const TomlValue* find(const std::string& key) const;

private:
    double number(const std::string& key, const TomlValue& value, Range range, const char* expected) const;
    const TomlArray& list(const std::string& key, const TomlValue& value, std::size_t count,
                          const char* expected) const;
    Rgb color(const std::string& key, const TomlValue& value) const;
    Error wrong_kind(const std::string& key, const TomlValue& value, const std::string& expected) const;

    std::string file_, what_;
    const TomlTable* table_ = nullptr;
    int line_ = 0;
};

}  // namespace shade16::host
