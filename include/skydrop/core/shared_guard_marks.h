// The C++ face of shaders/shared/guard_marks.glsl, in float and in double, beside that of the other shared
// files (core/shared.h): few need it.
#pragma once

#include "skydrop/core/shared.h"

#define FN inline
#define CONST inline constexpr

namespace skydrop::core::shared::f32 {
#include "shared/guard_marks.glsl"
}

namespace skydrop::core::shared::f64 {
#include "shared/guard_marks.glsl"
}

#undef FN
#undef CONST
