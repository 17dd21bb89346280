// MTL files: materials in Blinn-Phong words, and what this engine makes of them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <tiny_obj_loader.h>

#include "host_sim/model/model.hpp"
#include "host_sim/model/pictures.hpp"
#include "host_sim/model/remarks.hpp"

namespace shade16::host {

/// Reads all libraries of an OBJ file at once. A missing one is a warning: the model is drawn in grey then.
class MtlReader final : public tinyobj::MaterialReader {
public:
    MtlReader(std::string directory, std::vector<std::string> libraries, std::vector<std::string>& warnings)
        : directory_(std::move(directory)), libraries_(std::move(libraries)), warnings_(warnings) {}

    bool operator()(const std::string&, std::vector<tinyobj::material_t>* materials, std::map<std::string, int>* names,
                    std::string* warning, std::string* error) override;

private:
    bool read(const std::string& file, std::vector<tinyobj::material_t>* materials, std::map<std::string, int>* names);

    std::string directory_;
    std::vector<std::string> libraries_;
    std::vector<std::string>& warnings_;
};

/// A part without triangles yet.
/// illum  0: the diffuse colour, unlit. 1: no specular. Anything else, or none: all terms, with the half-vector
///        exponent of illum 2, which is the core's.
/// Ka     the diffuse colour when absent, and also when 1 1 1: that is what Blender writes for "no idea", and taken by
///        the letter it would drown every other term.
/// Ns     1 to 1000, clamped with a warning where a specular colour makes it matter; 32 when absent.
/// map_Kd is the texture, a factor of ambient and diffuse light; map_Ka is only where it is alone. map_Bump, bump and norm are
///        reliefs; -bm is their strength. PNG files, relative to the library. They are shown bilinear and in perspective.
/// Other maps and transparency are not drawn, and pictures that cannot be read neither, with a warning.
ModelPart to_part(const tinyobj::material_t& mtl, const std::string& directory, Remarks& remarks, Pictures& pictures,
                  std::vector<std::string>& warnings);

}  // namespace shade16::host
