// The C++ face of shaders/shared/spray.glsl, in float and double, as core/shared.h is of the others: apart
// from them because only those who draw spray need it.
#pragma once

#include <glm/trigonometric.hpp>

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
using glm::sin;
#include "shared/spray.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
using glm::sin;
#include "shared/spray.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
