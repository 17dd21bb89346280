// Pictures as the core has them in flash: RGB565 texels, and reliefs as slopes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "shade16/scene/texture.hpp"

namespace shade16::host {

/// A texture with its texels. It does not move, since the Texture looks at them.
struct TextureFile {
    std::string path{};
    std::string name{};  // the file's, without directory and ending
    std::vector<uint16_t> texels{};
    Texture texture{};

    TextureFile() = default;
    TextureFile(const TextureFile&) = delete;
    TextureFile& operator=(const TextureFile&) = delete;
};

enum class ReliefKind { automatic, heights, normals };

struct ReliefFile {
    std::string path{}, name{};
    double strength = 1;
    ReliefKind kind = ReliefKind::automatic;
    std::vector<Slope8> texels{};
    SlopeMap map{};

    ReliefFile() = default;
    ReliefFile(const ReliefFile&) = delete;
    ReliefFile& operator=(const ReliefFile&) = delete;
};

/// The pictures of one material.
struct MaterialMaps {
    std::shared_ptr<const TextureFile> texture{};
    std::shared_ptr<const ReliefFile> bump{};
};

/// Reads a PNG. A size that is no power of two is resampled to the nearest one, of at most 1024, with a warning: each texel
/// is the mean of what it covers. The picture's lowest row is t = 0, as OBJ files have it.
std::shared_ptr<const TextureFile> read_texture(const std::string& path, std::vector<std::string>& warnings);

/// Reads a relief. A grey picture holds heights, of which white is strength / 16 of the picture's width above black; a coloured
/// one holds tangent-space normals with green towards t (OpenGL's habit), whose slopes are multiplied by `strength`.
/// Slopes steeper than 8 become 8, with a warning.
std::shared_ptr<const ReliefFile> read_relief(const std::string& path, double strength, ReliefKind kind, std::vector<std::string>& warnings);

}  // namespace shade16::host
