// The C++ face of shaders/shared/light_shafts.glsl, beside core/shared.h: for the pass of the shafts and its
// tests.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr
#define OUT(T) T&

namespace skydrop::core::shared::f32 {
#include "shared/light_shafts.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/light_shafts.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
#undef OUT
