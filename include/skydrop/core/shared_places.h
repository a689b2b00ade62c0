// The C++ face of shaders/shared/places.glsl, in float and double, as core/shared.h is of the others: apart
// from them because only those who build and meet villages need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/places.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/places.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
