// The classic OpenGL material table: 24 rows, from Mark J. Kilgard's teapots.c (1994). The exponent is 128 times the
// table's `shine`, and is no integer for most rows. The table's alphas below 1 are kept for whoever asks; nothing draws them.
#pragma once

#include "shade16/scene/material.hpp"

namespace shade16 {

struct NamedMaterial {
    const char* name;
    Material material;
};

namespace detail {
consteval Material classic(Rgb ambient, Rgb diffuse, Rgb specular, Q16 shininess, Unorm16 alpha = Unorm16{Unorm16::one}) {
    return {.ambient = ambient, .diffuse = diffuse, .specular = specular, .shininess = shininess, .alpha = alpha};
}
consteval Rgb grey(Unorm16 v) { return {v, v, v}; }
}  // namespace detail

inline constexpr NamedMaterial classic_materials[] = {
    {"emerald", detail::classic({0.0215_unorm, 0.1745_unorm, 0.0215_unorm}, {0.07568_unorm, 0.61424_unorm, 0.07568_unorm}, {0.633_unorm, 0.727811_unorm, 0.633_unorm}, 76.8_q16, 0.55_unorm)},
    {"jade", detail::classic({0.135_unorm, 0.2225_unorm, 0.1575_unorm}, {0.54_unorm, 0.89_unorm, 0.63_unorm}, detail::grey(0.316228_unorm), 12.8_q16, 0.95_unorm)},
    {"obsidian", detail::classic({0.05375_unorm, 0.05_unorm, 0.06625_unorm}, {0.18275_unorm, 0.17_unorm, 0.22525_unorm}, {0.332741_unorm, 0.328634_unorm, 0.346435_unorm}, 38.4_q16, 0.82_unorm)},
    {"pearl", detail::classic({0.25_unorm, 0.20725_unorm, 0.20725_unorm}, {1_unorm, 0.829_unorm, 0.829_unorm}, detail::grey(0.296648_unorm), 11.264_q16, 0.922_unorm)},
    {"ruby", detail::classic({0.1745_unorm, 0.01175_unorm, 0.01175_unorm}, {0.61424_unorm, 0.04136_unorm, 0.04136_unorm}, {0.727811_unorm, 0.626959_unorm, 0.626959_unorm}, 76.8_q16, 0.55_unorm)},
    {"turquoise", detail::classic({0.1_unorm, 0.18725_unorm, 0.1745_unorm}, {0.396_unorm, 0.74151_unorm, 0.69102_unorm}, {0.297254_unorm, 0.30829_unorm, 0.306678_unorm}, 12.8_q16, 0.8_unorm)},
    {"brass", detail::classic({0.329412_unorm, 0.223529_unorm, 0.027451_unorm}, {0.780392_unorm, 0.568627_unorm, 0.113725_unorm}, {0.992157_unorm, 0.941176_unorm, 0.807843_unorm}, 27.89743616_q16)},
    {"bronze", detail::classic({0.2125_unorm, 0.1275_unorm, 0.054_unorm}, {0.714_unorm, 0.4284_unorm, 0.18144_unorm}, {0.393548_unorm, 0.271906_unorm, 0.166721_unorm}, 25.6_q16)},
    {"chrome", detail::classic(detail::grey(0.25_unorm), detail::grey(0.4_unorm), detail::grey(0.774597_unorm), 76.8_q16)},
    {"copper", detail::classic({0.19125_unorm, 0.0735_unorm, 0.0225_unorm}, {0.7038_unorm, 0.27048_unorm, 0.0828_unorm}, {0.256777_unorm, 0.137622_unorm, 0.086014_unorm}, 12.8_q16)},
    {"gold", detail::classic({0.24725_unorm, 0.1995_unorm, 0.0745_unorm}, {0.75164_unorm, 0.60648_unorm, 0.22648_unorm}, {0.628281_unorm, 0.555802_unorm, 0.366065_unorm}, 51.2_q16)},
    {"silver", detail::classic(detail::grey(0.19225_unorm), detail::grey(0.50754_unorm), detail::grey(0.508273_unorm), 51.2_q16)},
    {"black_plastic", detail::classic(detail::grey(0_unorm), detail::grey(0.01_unorm), detail::grey(0.50_unorm), 32_q16)},
    {"cyan_plastic", detail::classic({0_unorm, 0.1_unorm, 0.06_unorm}, {0_unorm, 0.50980392_unorm, 0.50980392_unorm}, detail::grey(0.50196078_unorm), 32_q16)},
    {"green_plastic", detail::classic(detail::grey(0_unorm), {0.1_unorm, 0.35_unorm, 0.1_unorm}, {0.45_unorm, 0.55_unorm, 0.45_unorm}, 32_q16)},
    {"red_plastic", detail::classic(detail::grey(0_unorm), {0.5_unorm, 0_unorm, 0_unorm}, {0.7_unorm, 0.6_unorm, 0.6_unorm}, 32_q16)},
    {"white_plastic", detail::classic(detail::grey(0_unorm), detail::grey(0.55_unorm), detail::grey(0.70_unorm), 32_q16)},
    {"yellow_plastic", detail::classic(detail::grey(0_unorm), {0.5_unorm, 0.5_unorm, 0_unorm}, {0.60_unorm, 0.60_unorm, 0.50_unorm}, 32_q16)},
    {"black_rubber", detail::classic(detail::grey(0.02_unorm), detail::grey(0.01_unorm), detail::grey(0.4_unorm), 10_q16)},
    {"cyan_rubber", detail::classic({0_unorm, 0.05_unorm, 0.05_unorm}, {0.4_unorm, 0.5_unorm, 0.5_unorm}, {0.04_unorm, 0.7_unorm, 0.7_unorm}, 10_q16)},
    {"green_rubber", detail::classic({0_unorm, 0.05_unorm, 0_unorm}, {0.4_unorm, 0.5_unorm, 0.4_unorm}, {0.04_unorm, 0.7_unorm, 0.04_unorm}, 10_q16)},
    {"red_rubber", detail::classic({0.05_unorm, 0_unorm, 0_unorm}, {0.5_unorm, 0.4_unorm, 0.4_unorm}, {0.7_unorm, 0.04_unorm, 0.04_unorm}, 10_q16)},
    {"white_rubber", detail::classic(detail::grey(0.05_unorm), detail::grey(0.5_unorm), detail::grey(0.7_unorm), 10_q16)},
    {"yellow_rubber", detail::classic({0.05_unorm, 0.05_unorm, 0_unorm}, {0.5_unorm, 0.5_unorm, 0.4_unorm}, {0.7_unorm, 0.7_unorm, 0.04_unorm}, 10_q16)},
};

/// The material of that name, or nullptr.
constexpr const Material* find_material(const char* name) {
    for (const NamedMaterial& row : classic_materials) {
        const char *a = row.name, *b = name;
        while (*a != 0 && *a == *b) ++a, ++b;
        if (*a == *b) return &row.material;
    }
    return nullptr;
}

}  // namespace shade16
