// The C++ face of shaders/shared/atmospheric_optics.glsl, in float and in double, beside that of the other
// shared files (core/shared.h): few need it.
#pragma once

#include <glm/trigonometric.hpp>

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {

using glm::asin, glm::atan, glm::cos, glm::cross;
#include "shared/atmospheric_optics.glsl"

}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {

using glm::asin, glm::atan, glm::cos, glm::cross;
#include "shared/atmospheric_optics.glsl"

}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
