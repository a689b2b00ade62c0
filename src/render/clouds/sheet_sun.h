// The sun on a sheet of clouds.
#pragma once

#include <glm/vec3.hpp>

#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {

// Illuminance by the sun at a height (m), multiplied by exposure, on a surface that faces it. The horizon
// dips by sqrt(2 h / R) for it, so clouds keep their light for some minutes after the land has lost it.
glm::dvec3 sunOnSheet(const SkyLight& light, double heightM);

}  // namespace skydrop::render
