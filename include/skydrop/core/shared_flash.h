// The C++ face of shaders/shared/flash.glsl, in float and double, as core/shared.h is of the others: apart
// from them because only those who draw lightning need it.
#pragma once

#include <glm/trigonometric.hpp>

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
using glm::atan;
#include "shared/flash.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
using glm::atan;
#include "shared/flash.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
