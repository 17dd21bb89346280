#include "host_sim/model/obj_import.hpp"

#include <set>

#include <gmock/gmock.h>

#include "host_sim/model/polygon.hpp"
#include "tests/system/imported.hpp"

namespace shade16::host {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The sentence after the scratch directory's name.
std::string refused(std::string_view obj) {
    const ScratchDirectory scratch;
    const std::string path = scratch.write("a.obj", obj);
    const std::string said = complaint([&] { import_obj(path); });
    EXPECT_THAT(said, HasSubstr("2: " + path)) << "exit code 2 and the file's name come first";
    return said.substr(said.find("a.obj"));
}

double area(const Model& model) {
    double sum = 0;
    for (const ModelPart& part : model.parts)
        for (const auto& t : part.triangles) {
            const std::array<Double3, 3> corners{model.positions[t[0]], model.positions[t[1]], model.positions[t[2]]};
            sum += length(area_vector(corners)) / 2;
        }
    return sum;
}

TEST(ObjImport, the_teapot_is_welded) {
    const Model model = import_obj((source_directory() / "assets/teapot.obj").string());
    EXPECT_EQ(model.positions.size(), 529u);
    EXPECT_EQ(std::set<Double3>(model.positions.begin(), model.positions.end()).size(), 529u);
    ASSERT_EQ(model.parts.size(), 1u);
    EXPECT_EQ(model.parts[0].name, "brass");
    EXPECT_EQ(model.parts[0].triangles.size(), 992u);
    EXPECT_EQ(model.parts[0].material.shininess.raw, std::lround(27.8974 * 65536));
    EXPECT_THAT(model.warnings, IsEmpty());
}

TEST(ObjImport, a_missing_normal_is_the_sum_of_unit_face_normals_whatever_their_areas) {
    // At the origin meet a face of area 0.5 facing +z and one of area 50 facing +x, both with vertices of their own.
    const Model model = imported("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 0 10 0\nv 0 0 10\nf 1 2 3\nf 4 5 6\n");
    EXPECT_EQ(model.positions.size(), 5u) << "the origin is one vertex";
    const auto origin =
        std::find(model.positions.begin(), model.positions.end(), Double3{0, 0, 0}) - model.positions.begin();
    const Double3 normal = model.normals[static_cast<std::size_t>(origin)];
    EXPECT_NEAR(normal[0], std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(normal[1], 0, 1e-15);
    EXPECT_NEAR(normal[2], std::sqrt(0.5), 1e-15);
}

TEST(ObjImport, a_quad_counts_once_in_a_normal) {
    const Model model = imported(
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
    ASSERT_EQ(model.positions.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(dot(model.normals[i], model.positions[i]), std::sqrt(3.0), 1e-14);
}

// A roof: two faces that meet at a right angle along the y axis.
const std::string roof = "v 0 0 0\nv 0 1 0\nv 1 0 -1\nv -1 0 -1\n";

TEST(ObjImport, without_groups_everything_is_smooth) {
    EXPECT_EQ(imported(roof + "f 1 3 2\nf 1 2 4\n").positions.size(), 4u);
}
TEST(ObjImport, smoothing_groups_keep_the_edges_between_them) {
    EXPECT_EQ(imported(roof + "s 1\nf 1 3 2\nf 1 2 4\n").positions.size(), 4u);
    EXPECT_EQ(imported(roof + "s 1\nf 1 3 2\ns 2\nf 1 2 4\n").positions.size(), 6u);
    EXPECT_EQ(imported(roof + "s off\nf 1 3 2\nf 1 2 4\n").positions.size(), 6u);
    const Model flat = imported(roof + "s off\nf 1 3 2\nf 1 2 4\n");
    EXPECT_NEAR(flat.normals[0][0], std::sqrt(0.5), 1e-9);  // a face's own normal
}
TEST(ObjImport, a_crease_keeps_sharper_edges_whatever_the_file_says) {
    const auto vertices = [](const std::string& obj, double crease) {
        const ScratchDirectory scratch;
        return import_obj(scratch.write("a.obj", obj), crease).positions.size();
    };
    EXPECT_EQ(vertices(roof + "f 1 3 2\nf 1 2 4\n", 89), 6u);
    EXPECT_EQ(vertices(roof + "f 1 3 2\nf 1 2 4\n", 90), 4u);
    EXPECT_EQ(vertices(roof + "vn 0 0 1\nf 1//1 3//1 2//1\nf 1//1 2//1 4//1\n", 30), 6u);
    EXPECT_EQ(vertices(roof + "f 1 3 2\nf 1 2 4\n", 180), 4u);
}

TEST(ObjImport, given_normals_are_kept_and_made_unit) {
    const Model model = imported(triangle + "vn 0 0 9\nvn 0 1e-200 0\nf 1//1 2//2 3//-2\n");
    EXPECT_EQ(model.normals, (std::vector<Double3>{{0, 0, 1}, {0, 1, 0}, {0, 0, 1}}));
}

TEST(ObjImport, normals_without_direction_are_replaced_and_counted) {
    const Model model = imported(triangle + "vn 0 0 0\nvn nan 0 0\nvn 0 1 0\nf 1//1 2//2 3//3\n");
    EXPECT_EQ(model.replaced_normals, 2u);
    EXPECT_EQ(model.normals, (std::vector<Double3>{{0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
    EXPECT_THAT(model.warnings, ElementsAre("2 normals without a direction were replaced by the mean of their faces."));
}

TEST(ObjImport, a_normal_or_place_without_a_number_counts_as_zero) {
    const Model model = imported(triangle + "vn\nvt\nvn 0 1 0\nvt 1 0\nf 1/2/2 2/1/1 3//2\n");
    EXPECT_EQ(model.replaced_normals, 1u);
    EXPECT_EQ(model.normals, (std::vector<Double3>{{0, 1, 0}, {0, 0, 1}, {0, 1, 0}}));
}

TEST(ObjImport, a_sheet_with_two_sides_has_two_normals) {
    const Model model = imported(triangle + "f 1 2 3\nf 1 3 2\n");
    EXPECT_EQ(model.positions.size(), 6u);
}

TEST(ObjImport, degenerate_triangles_are_skipped_and_counted) {
    const Model model = imported(triangle + "v 0.5 0 0\nv 0 0 0\nf 1 2 3\nf 1 1 2\nf 1 4 2\nf 1 5 3\nf 1 2\n");
    EXPECT_EQ(model.degenerate_triangles, 4u);
    EXPECT_EQ(model.parts[0].triangles.size(), 1u);
    EXPECT_THAT(model.warnings, ElementsAre("4 triangles without area were skipped."));
}

TEST(ObjImport, a_concave_quad_is_split_inside) {
    // The shorter diagonal, 1-3, runs outside.
    const Model model = imported("v -1 0 0\nv 0 1 0\nv 1 0 0\nv 0 10 0\nf 1 2 3 4\n");
    EXPECT_EQ(model.parts[0].triangles.size(), 2u);
    EXPECT_NEAR(area(model), 9, 1e-12);
    for (const Double3& normal : model.normals) EXPECT_EQ(normal, (Double3{0, 0, 1}));
}

TEST(ObjImport, concave_polygons_keep_their_area_and_direction) {
    // A comb with three teeth in the plane x = 7, clockwise and anticlockwise, with a vertex in the middle of an edge.
    const std::string comb =
        "v 7 0 0\nv 7 5 0\nv 7 5 4\nv 7 4 4\nv 7 4 1\nv 7 3 1\nv 7 3 4\nv 7 2 4\nv 7 2 1\nv 7 1 1\nv 7 1 4\nv 7 0 4\nv "
        "7 0 2\n";
    for (const char* face : {"f 1 2 3 4 5 6 7 8 9 10 11 12 13\n", "f 13 12 11 10 9 8 7 6 5 4 3 2 1\n"}) {
        const Model model = imported(comb + face);
        EXPECT_EQ(model.parts[0].triangles.size(), 11u);
        EXPECT_EQ(model.degenerate_triangles, 0u);
        EXPECT_NEAR(area(model), 14, 1e-12);
        for (const Double3& normal : model.normals) EXPECT_EQ(std::fabs(normal[0]), 1);
    }
}

TEST(ObjImport, reads_what_exporters_write) {
    const Model model = imported(
        "\xEF\xBB\xBF# BOM\r\nv +0 .0 -0.\r\n\tv 1e0 0 0 1.0\r\nv 0 \\\r\n 1 0\r\no x\r\ng y\r\ns 1\r\nvt 0 0\r\nf "
        "-3/1 2/1/ 3// \r\nl 1 2\r\np 1\r\n");
    EXPECT_EQ(model.positions, (std::vector<Double3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_THAT(model.warnings, ElementsAre("2 lines, points and curves are not drawn."));
    EXPECT_EQ(imported("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3").positions.size(), 3u) << "old Macintosh line ends";
    EXPECT_EQ(imported("f 1 2 3\n" + triangle).positions.size(), 3u) << "faces before vertices";
}

TEST(ObjImport, colours_are_kept_unless_all_white) {
    EXPECT_THAT(imported("v 0 0 0 1 1 1\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nf 1 2 3\n").colors, IsEmpty());
    const Model model = imported("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\nv 0 0 0 0 1 0\nv 0 0 1\nf 1 2 3\nf 4 5 3\n");
    EXPECT_THAT(model.colors, Contains(Double3{1, 0.5, 0}));
    EXPECT_THAT(model.colors, Contains(Double3{0, 1, 0})) << "one position, two colours: two vertices";
    EXPECT_THAT(model.colors, Contains(Double3{1, 1, 1}));
}

TEST(ObjImport, missing_and_unreadable_files_are_refused) {
    const ScratchDirectory scratch;
    EXPECT_EQ(complaint([&] { import_obj(scratch.path("no.obj")); }),
              "2: " + scratch.path("no.obj") + ": cannot be opened: No such file or directory.");
    EXPECT_THAT(complaint([&] { import_obj(scratch.path(".")); }), HasSubstr("is a directory; expected a text file."));
    EXPECT_THAT(refused(std::string_view("\xFE\xFF\0v\0 ", 6)),
                HasSubstr("is not a text file in ASCII or UTF-8; expected one"));
}

TEST(ObjImport, a_model_without_faces_is_refused) {
    EXPECT_EQ(refused(""), "a.obj: has no faces; expected at least one line such as 'f 1 2 3'.");
    EXPECT_EQ(refused(triangle + "l 1 2 3\n"), "a.obj: has no faces; expected at least one line such as 'f 1 2 3'.");
    EXPECT_EQ(refused(triangle + "f 1 1 1\n"),
              "a.obj: has 1 faces, but none has an area; expected at least one that does.");
}

TEST(ObjImport, indices_out_of_range_are_refused_with_their_line) {
    EXPECT_EQ(refused(triangle + "f 1 2 4\n"),
              "a.obj, line 4: a face refers to vertex 4; expected 1 to 3, as the file has 3.");
    EXPECT_EQ(refused(triangle + "f 1 2 0\n"),
              "a.obj, line 4: a face refers to vertex 0; expected 1 to 3, as the file has 3.");
    EXPECT_EQ(refused(triangle + "f -4 2 3\n"),
              "a.obj, line 4: a face refers to vertex -4; expected -1 to -3, as 3 precede it.");
    EXPECT_EQ(refused(triangle + "f 99999999999999999999 2 3\n"),
              "a.obj, line 4: a face refers to vertex 99999999999999999999; expected 1 to 3, as the file has 3.");
    EXPECT_THAT(refused(triangle + "f 1//1 2//1 3//1\n"),
                HasSubstr("line 4: a face refers to normal 1; expected 1 to 0"));
    EXPECT_THAT(refused(triangle + "f 1/2 2/1 3/1\n"), HasSubstr("texture coordinate 2"));
    EXPECT_EQ(refused(triangle + "f 1 2 three\n"),
              "a.obj, line 4: 'three' is no corner of a face; expected a form such as 7, 7/2, 7//3 or 7/2/3.");
    EXPECT_THAT(refused(triangle + "f 1//1/1 2 3\n"), HasSubstr("is no corner of a face"));
}

TEST(ObjImport, coordinates_that_are_no_or_huge_numbers_are_refused_with_their_line) {
    const std::string rest = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(refused("v 0 nan 0\n" + rest),
              "a.obj, line 1: the coordinate 'nan' is not a number; expected one such as -1.5.");
    EXPECT_EQ(refused("v 0 0,5 0\n" + rest),
              "a.obj, line 1: the coordinate '0,5' is not a number; expected one such as -1.5.");
    for (const char* huge : {"inf", "-inf", "1e999", "16384.1", "-1e30"})
        EXPECT_EQ(refused(std::string("v 0 0 ") + huge + "\n" + rest),
                  std::string("a.obj, line 1: the coordinate '") + huge +
                      "' is out of range; expected -16384 to 16384. Scale the model down.");
    EXPECT_EQ(refused("v 0 0\n" + rest), "a.obj, line 1: a vertex has 2 coordinates; expected three.");
}

TEST(ObjImport, a_face_of_too_many_corners_is_refused) {
    std::string face = "f";
    for (int i = 0; i < 256; ++i) face += " 1";
    EXPECT_EQ(refused(triangle + face),
              "a.obj, line 4: a face has 256 corners; expected at most 255. Triangulate the model.");
}

}  // namespace
}  // namespace shade16::host
