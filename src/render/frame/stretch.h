// A picture of linear light in another size, as shaders/tone_map/stretched.glsl reads it: bilinear between
// the centres of its pixels, edges continued. Pure; any thread.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace skydrop::render {

struct LightPicture {
  int width, height;                // > 0
  const std::vector<float>& light;  // three values a pixel, row by row
};

std::vector<float> stretched(const LightPicture& picture, const glm::ivec2& size);

}  // namespace skydrop::render
