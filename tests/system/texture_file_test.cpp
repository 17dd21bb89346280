// Pictures on their way into flash: sizes, rows, colours, slopes, and what cannot be read.
#include "host_sim/model/texture_file.hpp"

#include <gmock/gmock.h>
#include <zlib.h>

#include <fstream>

#include "host_sim/error.hpp"
#include "host_sim/io/png_chunk.hpp"
#include "host_sim/model/bake_header.hpp"
#include "host_sim/model/obj_import.hpp"
#include "tests/system/scratch_directory.hpp"

namespace shade16::host {
namespace {

using testing::ElementsAre;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using Code = std::array<uint8_t, 3>;

std::string write_picture(const ScratchDirectory& scratch, const std::string& name, int width, const std::vector<Code>& rows_from_the_top) {
    Image image{width, static_cast<int>(rows_from_the_top.size()) / width};
    for (const Code& c : rows_from_the_top) image.rgb.insert(image.rgb.end(), c.begin(), c.end());
    const std::vector<uint8_t> png = encoded_png(image, name);
    return scratch.write(name, std::string(png.begin(), png.end()));
}

constexpr Code red{255, 0, 0}, green{0, 255, 0}, blue{0, 0, 255}, white_code{255, 255, 255}, black_code{0, 0, 0}, grey{128, 128, 128};

TEST(TextureFile, the_lowest_row_comes_first) {
    const ScratchDirectory scratch;
    std::vector<std::string> warnings;
    const auto file = read_texture(write_picture(scratch, "four.png", 2, {red, green, blue, white_code}), warnings);
    EXPECT_THAT(file->texels, ElementsAre(0x001F, 0xFFFF, 0xF800, 0x07E0));
    EXPECT_EQ(file->texture.width_log2, 1);
    EXPECT_EQ(file->texture.height_log2, 1);
    EXPECT_EQ(file->name, "four");
    EXPECT_THAT(warnings, IsEmpty());
}

TEST(TextureFile, other_sizes_are_brought_to_powers_of_two_by_their_means) {
    const ScratchDirectory scratch;
    std::vector<std::string> warnings;
    // Three pixels onto four: the second texel is half of the first and half of the second pixel, by cover 1/3 and 2/3.
    const auto file = read_texture(write_picture(scratch, "three.png", 3, {black_code, white_code, black_code}), warnings);
    ASSERT_EQ(file->texture.width_log2, 2);
    ASSERT_EQ(file->texture.height_log2, 0);
    EXPECT_THAT(file->texels, ElementsAre(0x0000, 21 << 11 | 42 << 5 | 21, 21 << 11 | 42 << 5 | 21, 0x0000));
    EXPECT_THAT(warnings, ElementsAre("The picture 'three.png' of 3x1 pixels was brought to 4x1: textures have powers of two."));
}

int largest_slope(const ReliefFile& file) {
    int largest = 0;
    for (const Slope8& texel : file.texels) largest = std::max({largest, std::abs(int{texel.s}), std::abs(int{texel.t})});
    return largest;
}

TEST(TextureFile, heights_become_slopes_downhill) {
    const ScratchDirectory scratch;
    std::vector<std::string> warnings;
    // A ridge in the second of four columns; heights of 1 are 1/16 of the width above 0.
    const auto file = read_relief(write_picture(scratch, "ridge.png", 4, {black_code, white_code, black_code, black_code}), 1, ReliefKind::automatic, warnings);
    const double step = std::ldexp(1.0, -file->map.fraction_bits);
    ASSERT_THAT(file->texels, SizeIs(4));
    EXPECT_NEAR(file->texels[0].s * step, -4.0 / 16 / 2, step);  // uphill to the right: the normal leans to the left
    EXPECT_EQ(file->texels[1].s, 0);
    EXPECT_NEAR(file->texels[2].s * step, 4.0 / 16 / 2, step);
    EXPECT_EQ(file->texels[3].s, 0);
    EXPECT_GE(largest_slope(*file), 64) << "slopes use at least half of a byte's range";
    EXPECT_THAT(warnings, IsEmpty());
}

TEST(TextureFile, coloured_reliefs_are_normals) {
    const ScratchDirectory scratch;
    std::vector<std::string> warnings;
    const auto file = read_relief(write_picture(scratch, "normals.png", 2, {Code{128, 128, 255}, Code{255, 128, 255}}), 0.5, ReliefKind::automatic, warnings);
    const double step = std::ldexp(1.0, -file->map.fraction_bits);
    EXPECT_EQ(file->texels[0], (Slope8{0, 0}));
    EXPECT_NEAR(file->texels[1].s * step, 0.5, step);  // 45 degrees, at half strength
    EXPECT_EQ(file->texels[1].t, 0);
    const auto as_heights = read_relief(scratch.path("normals.png"), 0.5, ReliefKind::heights, warnings);
    EXPECT_NE(as_heights->texels[1].s, file->texels[1].s);
}

TEST(TextureFile, slopes_beyond_eight_are_limited_and_said) {
    const ScratchDirectory scratch;
    std::vector<std::string> warnings;
    const auto file = read_relief(write_picture(scratch, "steep.png", 2, {Code{255, 128, 128}, grey}), 100, ReliefKind::normals, warnings);
    EXPECT_THAT(warnings, ElementsAre("The relief 'steep' is steeper than 8 in places, and is drawn with 8 there."));
    EXPECT_EQ(file->map.fraction_bits, 4);
    EXPECT_EQ(file->texels[0].s, 127);
}

// One row of pixels with 16 bits a channel and no gAMA chunk.
std::string write_picture_of_16_bits(const ScratchDirectory& scratch, const std::string& name, const std::vector<std::array<uint16_t, 3>>& row) {
    std::vector<uint8_t> png(png_signature.begin(), png_signature.end()), header, lines{0};  // 0: no filter
    const auto append_chunk = [&](std::string_view kind, const std::vector<uint8_t>& contents) {
        const std::vector<uint8_t> chunk = png_chunk(kind, contents);
        png.insert(png.end(), chunk.begin(), chunk.end());
    };
    append_big_endian(header, static_cast<uint32_t>(row.size()), 4), append_big_endian(header, 1, 4);
    header.insert(header.end(), {16, 2, 0, 0, 0});  // bits, colour type RGB
    for (const auto& pixel : row)
        for (const uint16_t c : pixel) append_big_endian(lines, c, 2);
    uLongf size = compressBound(lines.size());
    std::vector<uint8_t> packed(size);
    EXPECT_EQ(compress(packed.data(), &size, lines.data(), lines.size()), Z_OK);
    packed.resize(size);
    append_chunk("IHDR", header), append_chunk("IDAT", packed), append_chunk("IEND", {});
    return scratch.write(name, std::string(png.begin(), png.end()));
}

TEST(TextureFile, sixteen_bits_are_rounded_to_eight_and_not_bent) {
    const ScratchDirectory scratch;
    std::vector<std::string> warnings;
    const std::string flat = write_picture_of_16_bits(scratch, "flat.png", {{32768, 32768, 65535}, {32768, 32768, 65535}});
    EXPECT_THAT(read_relief(flat, 1, ReliefKind::automatic, warnings)->texels, Each(Slope8{0, 0}));
    const std::string half = write_picture_of_16_bits(scratch, "half.png", {{32768, 32768, 32768}});
    EXPECT_THAT(read_texture(half, warnings)->texels, ElementsAre(16 << 11 | 32 << 5 | 16));
}

std::string complaint(const std::string& path) {
    std::vector<std::string> warnings;
    try {
        read_texture(path, warnings);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(TextureFile, what_is_no_picture_is_refused_in_a_sentence) {
    const ScratchDirectory scratch;
    EXPECT_THAT(complaint(scratch.path("gone.png")), HasSubstr("gone.png: there is no such file; expected a picture in PNG format."));
    EXPECT_THAT(complaint(scratch.path("")), HasSubstr("there is no such file"));
    EXPECT_THAT(complaint(scratch.write("text.png", "not a picture")), HasSubstr("text.png: is no picture in PNG format ("));
    EXPECT_THAT(complaint(scratch.write("empty.png", "")), HasSubstr("is no picture in PNG format"));
    const std::string whole = write_picture(scratch, "whole.png", 2, {red, green, blue, white_code});
    std::ifstream stream(whole, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    for (std::size_t length = 0; length + 12 < bytes.size(); ++length)  // the last 12 bytes say only that it ends
        EXPECT_NE(complaint(scratch.write("cut.png", bytes.substr(0, length))), "none") << length << " bytes";
}

// A square of two triangles with a texture; the second part has none.
const std::string textured_obj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 3 0\nvt 3 1\nvt 0 1\nusemtl wall\nf 1/1 2/2 3/3 4/4\nusemtl plain\nf 4/4 3/3 2/2 1/1\n";

Model textured_model(const ScratchDirectory& scratch, const std::string& mtl) {
    scratch.write("a.mtl", "newmtl plain\nKd 1 0 0\nnewmtl wall\nKd 1 1 1\n" + mtl);
    return import_obj(scratch.write("a.obj", textured_obj));
}

TEST(TextureFile, mtl_textures_bring_coordinates_to_their_part_alone) {
    const ScratchDirectory scratch;
    write_picture(scratch, "wall.png", 2, {red, green, blue, white_code});
    const Model model = textured_model(scratch, "map_Kd wall.png\nmap_Ka wall.png\n");
    EXPECT_THAT(model.warnings, IsEmpty());
    const BakedModel baked = quantize(model);
    ASSERT_THAT(baked.parts, SizeIs(2));
    EXPECT_THAT(baked.parts[0].texcoords, SizeIs(4));
    EXPECT_THAT(baked.parts[1].texcoords, IsEmpty());
    EXPECT_EQ(baked.parts[0].texcoord_bits, 13) << "3.0 fits with 13 fraction bits";
    const Mesh mesh = mesh_of(baked, 0);
    int farthest = 0;
    for (const TexCoord16& place : mesh.texcoords) farthest = std::max(farthest, int{place.s});
    EXPECT_EQ(farthest, 3 << 13);
    EXPECT_EQ(baked.parts[0].material.texture, &baked.parts[0].maps.texture->texture);
    EXPECT_EQ(baked.parts[0].material.mapping, Mapping::perspective);
    const std::string header = bake_header(baked, "a");
    EXPECT_THAT(header, HasSubstr("inline constexpr uint16_t wall_texture_texels[] = {\n    0x001F, 0xFFFF, 0xF800, 0x07E0,\n};"));
    EXPECT_THAT(header, HasSubstr("inline constexpr shade16::Texture wall_texture{wall_texture_texels, 1, 1};"));
    EXPECT_THAT(header, HasSubstr(".texture = &wall_texture,"));
    EXPECT_THAT(header, HasSubstr(".texcoords = a_wall_texcoords,"));
}

TEST(TextureFile, a_picture_that_is_missing_is_said_and_left_out) {
    const ScratchDirectory scratch;
    const Model model = textured_model(scratch, "map_Kd gone.png\n");
    ASSERT_THAT(model.warnings, SizeIs(1));
    EXPECT_THAT(model.warnings[0], HasSubstr("map_Kd of the material 'wall' is not drawn. "));
    EXPECT_THAT(model.warnings[0], HasSubstr("gone.png: there is no such file; expected a picture in PNG format."));
    EXPECT_EQ(model.parts[0].material.texture, nullptr);
    EXPECT_THAT(model.texcoords, IsEmpty());
}

TEST(TextureFile, bump_and_norm_are_reliefs_with_a_strength) {
    const ScratchDirectory scratch;
    write_picture(scratch, "n.png", 2, {Code{255, 128, 255}, Code{128, 128, 255}});
    const Model one = textured_model(scratch, "map_Bump -bm 1 n.png\n"), half = textured_model(scratch, "map_Bump -bm 0.5 n.png\n");
    const auto slope = [](const Model& m) { return std::ldexp(m.parts[0].maps.bump->texels[0].s, -m.parts[0].material.bump->fraction_bits); };
    EXPECT_NEAR(slope(one), 1, 0.01);
    EXPECT_NEAR(slope(half), 0.5, 0.01);
    EXPECT_NE(textured_model(scratch, "norm n.png\n").parts[0].material.bump, nullptr);
    EXPECT_THAT(textured_model(scratch, "map_Bump -bm 1e30 n.png\n").warnings,
                ElementsAre("The relief 'n' is steeper than 8 in places, and is drawn with 8 there.", "-bm 1e+30 is drawn as -bm 100 (material wall)."));
}

TEST(TextureFile, a_picture_of_several_materials_is_read_and_warned_of_once) {
    const ScratchDirectory scratch;
    write_picture(scratch, "wide.png", 3, {red, green, blue});
    scratch.write("a.mtl", "newmtl wall\nmap_Kd wide.png\nnewmtl plain\nmap_Kd wide.png\n");
    const Model model = import_obj(scratch.write("a.obj", textured_obj));
    EXPECT_THAT(model.warnings, ElementsAre("The picture 'wide.png' of 3x1 pixels was brought to 4x1: textures have powers of two."));
    ASSERT_THAT(model.parts, SizeIs(2));
    EXPECT_EQ(model.parts[0].maps.texture, model.parts[1].maps.texture);
}

TEST(TextureFile, one_picture_as_heights_and_as_normals_is_two_reliefs) {
    const ScratchDirectory scratch;
    write_picture(scratch, "g.png", 2, {grey, white_code});
    scratch.write("a.mtl", "newmtl wall\nmap_Bump g.png\nnewmtl plain\nnorm g.png\n");
    const std::string header = bake_header(quantize(import_obj(scratch.write("a.obj", textured_obj))), "a");
    EXPECT_THAT(header, HasSubstr("SlopeMap g_relief{"));
    EXPECT_THAT(header, HasSubstr("SlopeMap g_relief_2{"));
}

TEST(TextureFile, pictures_without_coordinates_are_said) {
    const ScratchDirectory scratch;
    write_picture(scratch, "wall.png", 2, {red, green});
    scratch.write("a.mtl", "newmtl wall\nmap_Kd wall.png\n");
    EXPECT_THAT(import_obj(scratch.write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl wall\nf 1 2 3\n")).warnings,
                ElementsAre("The model has pictures, but no vt lines: each picture shows one texel everywhere."));
}

}  // namespace
}  // namespace shade16::host
