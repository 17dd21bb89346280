// The normal-to-colour table against the reference's light, at its own bound, which is no tier's.
#include <cstdio>
#include <memory>

#include <gtest/gtest.h>

#include "host_sim/bounds/random_surface.hpp"

namespace shade16::host {
namespace {

// A sphere's worth of normals under random lights at infinity, whose table is looked up normal by normal.
class TableOnLights {
public:
    TableOnLights(Random& random, double exponent, LightTable kind) {
        light_.position = vec3(random.direction());
        light_.space = static_cast<Space>(random.integer(0, 2));
        object_.material = {.diffuse = white, .specular = white, .shininess = q16(exponent)};
        object_.material.shading = Shading::phong, object_.material.light_table = kind;
        if (random.coin()) object_.material.specular = black;
        else object_.material.diffuse = random.coin() ? black : white;
        const auto angle = [&] { return Angle{static_cast<uint32_t>(random.uniform(0, 4294967295.0))}; };
        object_.pose.rotation = rotate_x(angle()) * rotate_y(angle());
        camera_.eye = vec3(random.direction() * 4.0);
        view_ = look_rotation(camera_);
        kernel_ = shininess<mediump>(object_.material.shininess);
        const bool shines = object_.material.specular != black;
        is_prepared_ = prepare_light_table<needs, mediump>(*table_, kept_, scratch_, camera_, view_, {&light_, 1}, object_.material, object_.pose, Component::all,
                                                           shines ? &kernel_ : nullptr);
    }
    bool is_prepared() const { return is_prepared_; }

    /// In levels; negative beside N.L = 0, where a highlight may begin an entry too early or too late.
    double error_at(const glm::dvec3& normal_view) {
        const glm::dmat3 to_world = glm::transpose(reference::make_view(camera_, {1, 1}).rotation);
        const glm::dvec3 n_object = glm::transpose(reference::value(object_.pose.rotation)) * (to_world * normal_view);
        const Normal14 n = normal14(n_object);
        reference::SurfacePoint point;
        point.normal = reference::normal_to_world(object_.pose, reference::value(n));
        const reference::LightParts parts = reference::light_point(camera_, {&light_, 1}, object_.material, object_.pose, point);
        if (std::abs(parts.shares[0].n_dot_l) < light_table_gate_per_1024 / 1024.0 && object_.material.specular != black) return -1;
        const TableLight<needs, Channels::rgb> light{table_->entry, object_.material.light_table == LightTable::bilinear};
        const auto shown = light.light(table_sample<mediump>(*table_, n));
        const glm::dvec3 color = glm::dvec3(shown.r, shown.g, shown.b) * 0x1p-24;
        const glm::dvec3 d = glm::abs(color - glm::clamp(parts.sum(), 0.0, 1.0)) * 255.0;
        return std::max({d.x, d.y, d.z}) - 255.0 / 62;  // less half a code of RGB565, which entries are rounded to
    }
    /// The half vector, in view coordinates: uniform normals miss sharp highlights.
    glm::dvec3 half_vector() const {
        const reference::View view = reference::make_view(camera_, {1, 1});
        glm::dvec3 l = glm::normalize(reference::value(light_.position));
        if (light_.space == Space::object) l = reference::value(object_.pose.rotation) * l;
        if (light_.space != Space::view) l = view.rotation * l;
        return glm::normalize(l + glm::dvec3(0, 0, 1));
    }
    const LightTableMemory<mediump>& table() const { return *table_; }
    Light& light() { return light_; }
    bool prepare_again() {
        return prepare_light_table<needs, mediump>(*table_, kept_, scratch_, camera_, view_, {&light_, 1}, object_.material, object_.pose, Component::all,
                                                   object_.material.specular != black ? &kernel_ : nullptr);
    }

private:
    static constexpr Needs needs = all_needs;
    Camera camera_{};
    Mat3 view_{};
    Light light_{};
    Object object_{};
    Shininess<mediump> kernel_{};
    ObjectLight<mediump> kept_[1]{}, scratch_[1]{};
    std::unique_ptr<LightTableMemory<mediump>> table_ = std::make_unique<LightTableMemory<mediump>>();
    bool is_prepared_ = false;
};

/// Up to 105 degrees from the viewer.
glm::dvec3 visible_normal(Random& random) {
    glm::dvec3 n;
    do n = random.direction();
    while (n.z < -0.26);
    return n;
}

class LightTables : public testing::TestWithParam<std::tuple<LightTable, double>> {};

TEST_P(LightTables, StayInsideTheirBound) {
    const auto [kind, exponent] = GetParam();
    Random random(21);
    double worst = 0;
    std::size_t normals = 0;
    for (int i = 0; i < 60; ++i) {
        TableOnLights table(random, exponent, kind);
        ASSERT_TRUE(table.is_prepared());
        for (int k = 0; k < 1500; ++k, ++normals) {
            glm::dvec3 n = visible_normal(random);
            if (k % 2 == 0) n = glm::normalize(table.half_vector() + random.direction() * std::sqrt(random.uniform(0, 4) / exponent));
            if (n.z > -0.26) worst = std::max(worst, table.error_at(n));
        }
    }
    const double bound = light_table_max_error(kind, q16(exponent)).micro / 1e6;
    EXPECT_LE(worst, bound);
    EXPECT_GE(worst, bound / 3) << "a bound so wide says little";
    EXPECT_GT(worst, mediump::promise.to_exponent_1000.micro / 1e6) << "it holds mediump's promise, and the documents say that it can not";
    std::printf("[ table    ] %-8s n = %4g: at most %.1f levels off, bound %.1f, %zu normals\n", kind == LightTable::nearest ? "nearest" : "bilinear", exponent,
                worst, bound, normals);
}
INSTANTIATE_TEST_SUITE_P(, LightTables, testing::Combine(testing::Values(LightTable::nearest, LightTable::bilinear), testing::Values(1.0, 8.0, 28.0, 128.0, 1000.0)));

TEST(LightTable, IsMadeAnewOnlyWhenItsLightChanges) {
    Random random(22);
    TableOnLights table(random, 20, LightTable::nearest);
    auto& entry = const_cast<uint16_t&>(table.table().entry[100]);
    const uint16_t made = entry;
    entry = static_cast<uint16_t>(made ^ 1);
    EXPECT_TRUE(table.prepare_again());
    EXPECT_EQ(entry, made ^ 1) << "nothing changed";
    table.light().intensity = 0.5_scaled;
    EXPECT_TRUE(table.prepare_again());
    EXPECT_NE(entry, made ^ 1);
    table.light().kind = LightKind::point;
    EXPECT_FALSE(table.prepare_again()) << "a lamp's light is no function of the normal";
}

TEST(LightTable, EntriesStandForTheNormalsThatAreLookedUpThere) {
    for (int32_t row = 0; row < light_table_side; ++row)
        for (int32_t column = 0; column < light_table_side; ++column) {
            const double x = (2 * column + 1 - 64) / 64.0, y = (2 * row + 1 - 64) / 64.0;
            if (x * x + y * y > 1) continue;
            const IVec3 n = detail::table_normal(column, row);
            const TablePlace place = detail::table_place(normalize30(n));
            EXPECT_NEAR(place.s, column * 1024 + 512, 1.01) << column << ' ' << row;
            EXPECT_NEAR(place.t, row * 1024 + 512, 1.01) << column << ' ' << row;
        }
}

}  // namespace
}  // namespace shade16::host
