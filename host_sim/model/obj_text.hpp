// ObjText: an OBJ file's lines, checked before tinyobjloader sees them. It reads `nan` as 0, drops faces with a bad
// index and knows no line numbers afterwards; a user wants to hear of all three.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace shade16::host {

struct ObjText {
    std::string lines{};                   // the v, vn, vt, s, usemtl and f lines, the names in joined_name form
    std::vector<std::string> libraries{};  // what follows each mtllib
    std::vector<std::string> materials{};  // the names that usemtl uses, each once
    bool has_smoothing = false;  // some s line
    std::size_t faces = 0;
    std::size_t short_faces = 0;  // of fewer than three corners, left out
    std::size_t not_faces = 0;    // lines, points and curves, left out
};

/// Throws input_error for a number that is none, a coordinate beyond 16384 and an index out of range, with the line.
ObjText check_obj_text(const std::string& path, std::string text);

/// A name with its blanks replaced, because tinyobjloader ends a usemtl at the first one; and back again.
std::string joined_name(std::string_view name);
std::string spaced_name(std::string_view name);

}  // namespace shade16::host
