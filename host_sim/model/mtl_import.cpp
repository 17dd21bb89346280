#include "host_sim/model/mtl_import.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "host_sim/error.hpp"
#include "host_sim/model/obj_text.hpp"
#include "host_sim/model/text_lines.hpp"

namespace shade16::host {

namespace {

namespace fs = std::filesystem;

/// tinyobjloader cannot tell an absent line from a black colour or illum 0. Impossible values after each newmtl can: a
/// real line overrides them.
std::string with_impossible_defaults(const std::string& text) {
    std::string marked;
    for (const TextLine& line : lines_of(text)) {
        const auto words = words_of(line.text);
        if (words.empty()) continue;
        if (words[0] == "newmtl") {
            marked += fmt::format("newmtl {}\nKa -1 -1 -1\nKd -1 -1 -1\nNs -1\nillum -1\n",
                                  joined_name(after_first_word(line.text)));
        } else {
            marked.append(line.text).append("\n");
        }
    }
    return marked;
}

bool is_absent(const tinyobj::real_t (&color)[3]) { return color[0] == -1 && color[1] == -1 && color[2] == -1; }
bool is_one(const tinyobj::real_t (&color)[3]) { return color[0] == 1 && color[1] == 1 && color[2] == 1; }

class Conversion {
public:
    Conversion(const tinyobj::material_t& mtl, const std::string& directory, Remarks& remarks, Pictures& pictures,
               std::vector<std::string>& warnings)
        : mtl_(mtl), directory_(directory), remarks_(remarks), pictures_(pictures), warnings_(warnings) {}

    ModelPart run() {
        const std::string name = spaced_name(mtl_.name);
        part_.name = name == " " ? "unnamed" : name;
        convert_colors();
        part_.material.unlit = mtl_.illum == 0;
        if (mtl_.shininess != -1) part_.material.shininess = exponent();
        part_.material.alpha = channel(mtl_.dissolve);
        read_maps();
        note_what_is_not_drawn();
        return std::move(part_);
    }

private:
    void convert_colors() {
        Material& material = part_.material;
        if (!is_absent(mtl_.diffuse)) material.diffuse = color(mtl_.diffuse);
        if (is_one(mtl_.ambient)) {
            part_.notes.emplace_back("Ka 1 1 1, read as the diffuse colour");
        } else if (!is_absent(mtl_.ambient)) {
            material.ambient = color(mtl_.ambient);
        }
        if (mtl_.illum != 1) material.specular = color(mtl_.specular);
        material.emissive = color(mtl_.emission);
        if (clamped_) remarks_.add("A colour outside of 0 to 1 was clamped", part_.name);
    }

    Unorm16 channel(double value) {
        const double inside = value > 0 ? std::min(value, 1.0) : 0;  // a NaN becomes 0
        clamped_ |= inside != value;
        return Unorm16::from_raw(static_cast<uint32_t>(std::lround(inside * Unorm16::one)));
    }
    Rgb color(const tinyobj::real_t (&c)[3]) { return {channel(c[0]), channel(c[1]), channel(c[2])}; }

    Q16 exponent() {
        const double given = mtl_.shininess, inside = given > 1 ? std::min(given, 1000.0) : 1;
        if (inside != given && part_.material.specular != black && !part_.material.unlit)
            remarks_.add(fmt::format("Ns {:g} is drawn as Ns {:g}, as exponents go from 1 to 1000", given, inside),
                         part_.name);
        return Q16::from_raw(static_cast<int32_t>(std::lround(inside * 65536)));
    }

    void read_maps() {
        const bool has_diffuse = !mtl_.diffuse_texname.empty();
        read_picture(has_diffuse ? "map_Kd" : "map_Ka", has_diffuse ? mtl_.diffuse_texname : mtl_.ambient_texname,
                     has_diffuse ? mtl_.diffuse_texopt : mtl_.ambient_texopt, [&](const std::string& path, double) {
                         part_.maps.texture = pictures_.texture(path);
                         part_.material.texture = &part_.maps.texture->texture;
                     });
        const bool has_normals = mtl_.bump_texname.empty();
        read_picture(has_normals ? "norm" : "map_Bump", has_normals ? mtl_.normal_texname : mtl_.bump_texname,
                     has_normals ? mtl_.normal_texopt : mtl_.bump_texopt, [&](const std::string& path, double strength) {
                         part_.maps.bump = pictures_.relief(path, strength, has_normals ? ReliefKind::normals : ReliefKind::automatic);
                         part_.material.bump = &part_.maps.bump->map;
                     });
        if (part_.maps.texture == nullptr && part_.maps.bump == nullptr) return;
        part_.material.filter = Filter::bilinear, part_.material.mapping = Mapping::perspective;
    }

    /// A picture that cannot be read is said and left out, as a missing library is.
    template <class Read>
    void read_picture(const char* keyword, const std::string& file, const tinyobj::texture_option_t& options, Read read) {
        if (file.empty()) return;
        fs::path path = fs::path(directory_) / file;
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored)) {  // written on Windows
            std::string name = file;
            std::replace(name.begin(), name.end(), '\\', '/');
            path = fs::path(directory_) / name;
        }
        try {
            read(path.string(), strength(options.bump_multiplier));
        } catch (const Error& error) {
            part_.notes.push_back(fmt::format("{} {}", keyword, file));
            warnings_.push_back(fmt::format("{} of the material '{}' is not drawn. {}", keyword, part_.name, error.what()));
        }
        const auto is_plain = [](const auto& v, double plain) { return v[0] == plain && v[1] == plain; };
        if (!is_plain(options.scale, 1) || !is_plain(options.origin_offset, 0) || options.clamp)
            remarks_.add(fmt::format("{}'s -s, -o or -clamp is not heeded", keyword), part_.name);
    }

    double strength(double given) {
        constexpr double largest = 100;
        const double inside = std::isfinite(given) ? std::clamp(given, -largest, largest) : 1;
        if (inside != given) remarks_.add(fmt::format("-bm {:g} is drawn as -bm {:g}", given, inside), part_.name);
        return inside;
    }

    void not_drawn(const std::string& what, const std::string& value) {
        part_.notes.push_back(fmt::format("{} {}", what, value));
        remarks_.add(fmt::format("{} is not drawn", what), part_.name);
    }

    void note_what_is_not_drawn() {
        const auto texture = [this](const char* keyword, const std::string& file) {
            if (!file.empty()) not_drawn(keyword, file);
        };
        if (!mtl_.diffuse_texname.empty() && mtl_.ambient_texname != mtl_.diffuse_texname) texture("map_Ka", mtl_.ambient_texname);
        texture("map_Ks", mtl_.specular_texname);
        texture("map_Ke", mtl_.emissive_texname);
        texture("map_Ns", mtl_.specular_highlight_texname);
        texture("map_d", mtl_.alpha_texname);
        if (!mtl_.bump_texname.empty()) texture("norm", mtl_.normal_texname);
        texture("disp", mtl_.displacement_texname);
        texture("refl", mtl_.reflection_texname);
        if (mtl_.dissolve != 1) not_drawn("Transparency (d)", fmt::format("{:g}", static_cast<double>(mtl_.dissolve)));
        if (mtl_.illum <= 2) return;
        part_.notes.push_back(fmt::format("illum {}", mtl_.illum));
        remarks_.add(fmt::format("illum {} is drawn as illum 2", mtl_.illum), part_.name);
    }

    const tinyobj::material_t& mtl_;
    const std::string& directory_;
    Remarks& remarks_;
    Pictures& pictures_;
    std::vector<std::string>& warnings_;
    ModelPart part_{};
    bool clamped_ = false;
};

}  // namespace

bool MtlReader::operator()(const std::string&, std::vector<tinyobj::material_t>* materials,
                           std::map<std::string, int>* names, std::string*, std::string*) {
    for (const std::string& library : libraries_) {
        // Several names on a line are allowed, and so are blanks in a name.
        if (read(library, materials, names)) continue;
        for (const std::string_view file : words_of(library))
            if (!read(std::string(file), materials, names))
                warnings_.push_back(fmt::format(
                    "The material library '{}' cannot be read; what it describes is drawn in neutral grey.", file));
    }
    return true;
}

bool MtlReader::read(const std::string& file, std::vector<tinyobj::material_t>* materials,
                     std::map<std::string, int>* names) {
    std::string path = (fs::path(directory_) / file).string();
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) std::replace(path.begin(), path.end(), '\\', '/');  // written on Windows
    if (!fs::is_regular_file(path, ignored)) return false;
    std::istringstream text(with_impossible_defaults(read_text(path)));
    std::string warning, error;
    tinyobj::LoadMtl(names, materials, &text, &warning, &error);
    names->erase("");  // what stood before the first newmtl is no material
    return true;
}

ModelPart to_part(const tinyobj::material_t& mtl, const std::string& directory, Remarks& remarks, Pictures& pictures,
                  std::vector<std::string>& warnings) {
    return Conversion(mtl, directory, remarks, pictures, warnings).run();
}

}  // namespace shade16::host
