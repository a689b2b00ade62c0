// The linear light of a frame as it is seen and measured. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/accuracy/observation.h"
#include "skydrop/core/image.h"

namespace skydrop::app {

// Tone-mapped and sRGB-encoded, each channel in [0, 1]: what the frame's tone map writes, before it dithers
// and rounds.
glm::dvec3 seenColor(const glm::dvec3& light);

// The same, rounded to 8 bits, into three bytes.
void writeSeen(const glm::dvec3& light, std::uint8_t* rgb);

// Values and `seen` of an observation. Three values a pixel, the top row first
// (render::Renderer::readRadiance).
accuracy::Observation observedPicture(const std::vector<float>& radiance, int width, int height);

// Of all pixels.
core::Image seenPicture(const std::vector<float>& radiance, int width, int height);

}  // namespace skydrop::app
