// The C++ face of shaders/shared/edge_steps.glsl, in float and in double, beside that of the other shared
// files (core/shared.h): few need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/edge_steps.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/edge_steps.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
