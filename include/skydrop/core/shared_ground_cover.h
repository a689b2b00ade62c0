// The C++ face of shaders/shared/ground_cover.glsl, in float and double, as core/shared.h is of the others:
// apart from them because only those who draw what stands on the ground need it.
#pragma once

#include "skydrop/core/shared_woods.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/ground_cover.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/ground_cover.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
