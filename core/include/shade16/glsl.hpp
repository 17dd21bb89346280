// GLSL's vectors, matrices and built-in functions in Q16: shaders' arithmetic without an FPU, at run time or compile time.
//
//     using namespace shade16::glsl;
//     vec3 n = normalize(m * vec4(position, 1)).xyz();
//
// docs/glsl.md has what every function promises and where this differs from GLSL.
#pragma once

#include "shade16/glsl/vector.hpp"
#include "shade16/glsl/operators.hpp"
#include "shade16/glsl/matrix.hpp"
#include "shade16/glsl/common.hpp"
#include "shade16/glsl/exponential.hpp"
#include "shade16/glsl/trigonometry.hpp"
#include "shade16/glsl/geometric.hpp"
