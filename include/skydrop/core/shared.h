// The C++ face of shaders/shared: the same pure functions in float (core::shared::f32) and double
// (core::shared::f64). This header lists the files in the order in which they need each other; GLSL entry
// points include the ones they use in the same order, after shared/dialect.glsl. Units and ranges are in
// those files.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define FN inline
#define CONST inline constexpr
#define OUT(T) T&

namespace skydrop::core::shared::f32 {

using Real = float;
using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Uint = std::uint32_t;
using Uvec2 = glm::u32vec2;
using Uvec3 = glm::u32vec3;
using glm::abs, glm::clamp, glm::dot, glm::exp, glm::floor, glm::length, glm::log, glm::max, glm::min,
    glm::mix, glm::pow, glm::sqrt;

// In the order of need.
// clang-format off
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/depth.glsl"
#include "shared/half_float.glsl"
#include "shared/atmosphere.glsl"
#include "shared/atmosphere_shell.glsl"
#include "shared/tone_map.glsl"
#include "shared/terrain_grid.glsl"
#include "shared/terrain_lod.glsl"
#include "shared/lattice.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/lattice_gradients.glsl"
#include "shared/gradient_noise.glsl"
#include "shared/land_material.glsl"
#include "shared/ground_picture.glsl"
#include "shared/grass_strip.glsl"
#include "shared/water.glsl"
#include "shared/marker.glsl"
#include "shared/cloud_noise.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "shared/cloud_march.glsl"
#include "shared/cloud_sheet.glsl"
#include "shared/ground_fog.glsl"
// clang-format on

}  // namespace skydrop::core::shared::f32

namespace skydrop::core::shared::f64 {

using Real = double;
using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Uint = std::uint32_t;
using Uvec2 = glm::u32vec2;
using Uvec3 = glm::u32vec3;
using glm::abs, glm::clamp, glm::dot, glm::exp, glm::floor, glm::length, glm::log, glm::max, glm::min,
    glm::mix, glm::pow, glm::sqrt;

// In the order of need.
// clang-format off
#include "shared/guards.glsl"
#include "shared/hash.glsl"
#include "shared/depth.glsl"
#include "shared/half_float.glsl"
#include "shared/atmosphere.glsl"
#include "shared/atmosphere_shell.glsl"
#include "shared/tone_map.glsl"
#include "shared/terrain_grid.glsl"
#include "shared/terrain_lod.glsl"
#include "shared/lattice.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/lattice_gradients.glsl"
#include "shared/gradient_noise.glsl"
#include "shared/land_material.glsl"
#include "shared/ground_picture.glsl"
#include "shared/grass_strip.glsl"
#include "shared/water.glsl"
#include "shared/marker.glsl"
#include "shared/cloud_noise.glsl"
#include "shared/cloud_medium.glsl"
#include "shared/cloud_light.glsl"
#include "shared/cloud_march.glsl"
#include "shared/cloud_sheet.glsl"
#include "shared/ground_fog.glsl"
// clang-format on

}  // namespace skydrop::core::shared::f64

#undef FN
#undef CONST
#undef OUT
