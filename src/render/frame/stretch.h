// A picture of linear light in another size, as shaders/tone_map/stretched.glsl reads it: bilinear between
// the centres of its pixels, edges continued. Of a larger picture each pixel is the light that is shown
// (shaders/shared/tone_map.glsl) as the mean of what its samples show. Pure; any thread.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace skydrop::render {

struct LightPicture {
  int width, height;                // > 0
  const std::vector<float>& light;  // three values a pixel, row by row
};

// Samples of a picture's pixel, a side: 1 where the scene has no more pixels than the picture.
int samplesAcross(const glm::ivec2& scene, const glm::ivec2& picture);

std::vector<float> stretched(const LightPicture& picture, const glm::ivec2& size);

}  // namespace skydrop::render
