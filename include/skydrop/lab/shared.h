// The C++ face of shaders/shared/lab, in float and double, as core/shared.h is of the others: apart from them
// because only the laboratory needs it.
#pragma once

#include <glm/trigonometric.hpp>

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
using glm::fract, glm::sin, glm::cos;
// clang-format off
#include "shared/lab/distance.glsl"
#include "shared/lab/scenes.glsl"
#include "shared/lab/march.glsl"
#include "shared/lab/light.glsl"
#include "shared/lab/orbit.glsl"
#include "shared/lab/noise.glsl"
#include "shared/lab/cloud.glsl"
// clang-format on
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
using glm::fract, glm::sin, glm::cos;
// clang-format off
#include "shared/lab/distance.glsl"
#include "shared/lab/scenes.glsl"
#include "shared/lab/march.glsl"
#include "shared/lab/light.glsl"
#include "shared/lab/orbit.glsl"
#include "shared/lab/noise.glsl"
#include "shared/lab/cloud.glsl"
// clang-format on
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
