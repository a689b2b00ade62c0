// The waves of the sea as a set that never changes, and how high the wind raises each at a moment. So a sea
// is a function of place, moment and wind: nothing is remembered, and phases are exact far out and late.
#pragma once

#include <glm/vec2.hpp>

#include "skydrop/render/frame/sea_waves.h"
#include "skydrop/render/water/water_detail_settings.h"

namespace skydrop::render {

// The waves at an eye (x, z of the world, m) and a simulated moment (s, finite), in a wind 10 m above the sea
// (m/s, x and z). A pure function; any thread. The eye's place is exact in double up to 1e9 m: phases within
// 1e-6 turns of a wave of 0.16 m.
SeaWaves seaWaves(const WaterDetailSettings& settings, const glm::dvec2& eye, double seconds,
                  const glm::dvec2& wind);

}  // namespace skydrop::render
