// The C++ face of shaders/shared/sea_waves.glsl and mirror_ray.glsl, in float and in double, beside that of
// the other shared files (core/shared.h): few need it.
#pragma once

#include "skydrop/core/shared_glitter.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/mirror_ray.glsl"
#include "shared/sea_waves.glsl"
}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {
#include "shared/mirror_ray.glsl"
#include "shared/sea_waves.glsl"
}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
