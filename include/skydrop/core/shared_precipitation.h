// The C++ face of shaders/shared/precipitation.glsl, in float and double, as core/shared.h is of the others:
// apart from them because only those who draw what falls need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/precipitation.glsl"
}

namespace skydrop::core::shared::f64 {
#include "shared/precipitation.glsl"
}

#undef FN
#undef CONST
