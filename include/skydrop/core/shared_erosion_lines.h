// The C++ face of shaders/shared/erosion_lines.glsl, in float and double, beside that of the other shared
// files (core/shared.h): few need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/erosion_lines.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/erosion_lines.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
