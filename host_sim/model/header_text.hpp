// C++ text for what lies in flash: literals, arrays and aggregates of the core's own types. Every number is the raw
// integer, so that the compiler sees the bits that were measured here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host_sim/model/quantize.hpp"
#include "shade16/shade16.hpp"

namespace shade16::host {

inline constexpr std::size_t header_columns = 120;
inline constexpr int field_columns = 4;  // the indentation of an aggregate's fields

std::string literal(Q16 x);  // a whole number as it is: the same bits
std::string literal(Vec3 v);
std::string literal(Rgb c);  // a name or six hexadecimal digits where they are the same bits

/// The arrays of a part, `STEM_positions`, `STEM_normals`, `STEM_colors`, `STEM_texcoords` and `STEM_triangles`, in rows that fit the
/// line.
std::string arrays_text(const BakedPart& part, const std::string& stem);

/// The fields of an aggregate, `.key = value,` a line.
class Fields {
public:
    explicit Fields(int indentation) : margin_(static_cast<std::size_t>(indentation), ' ') {}

    /// `remark` says in a comment what the raw integers mean: at the end of the line, or above where that is too long.
    void add(const char* key, const std::string& value, const std::string& remark = {});
    const std::string& text() const { return text_; }
    /// `{}` without fields; otherwise on lines of their own between braces.
    std::string braced() const;

private:
    std::string margin_, text_{};
};

/// Initialisers, without what is at its default. A mesh's arrays are `ARRAYS_positions` and so on.
std::string mesh_text(const BakedModel& model, const BakedPart& part, const std::string& arrays, bool convex);
/// The names that a header gives to a material's pictures.
struct MapNames {
    std::string texture{}, bump{};
};
std::string material_text(const Material& material, const MapNames& maps = {});

/// A picture's array and the Texture or SlopeMap `name` that looks at it.
std::string texture_text(const TextureFile& file, const std::string& name);
std::string relief_text(const ReliefFile& file, const std::string& name);

/// A file's name inside a comment: nothing that could end or continue it.
std::string harmless(std::string text);

}  // namespace shade16::host
