// The C++ face of shaders/shared/ice_clouds.glsl, in float and in double, beside that of the other shared
// files (core/shared.h): few need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/ice_clouds.glsl"
}

namespace skydrop::core::shared::f64 {
#include "shared/ice_clouds.glsl"
}

#undef FN
#undef CONST
