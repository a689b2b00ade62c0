// The sun on a sheet of clouds.
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {

// Illuminance by the sun at a height (m), multiplied by exposure, on a surface that faces it. The sun sets
// later for it: clouds keep their light, redder and redder, until the sun is sqrt(2 h / R) below the horizon.
glm::dvec3 sunOnSheet(const SkyLight& light, double heightM);

}  // namespace skydrop::render
