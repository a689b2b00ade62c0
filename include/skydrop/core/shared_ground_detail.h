// The C++ face of shaders/shared/ground_detail.glsl, in float and double, as core/shared.h is of the others:
// apart from them because few need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/ground_detail.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/ground_detail.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
