#include "app/session/observed_picture.h"

#include <cmath>
#include <glm/common.hpp>

#include "skydrop/core/shared.h"

namespace skydrop::app {

glm::dvec3 seenColor(const glm::dvec3& light) {
  namespace f64 = core::shared::f64;
  return f64::srgbEncode(f64::toneMap(glm::max(light, 0.0)));
}

void writeSeen(const glm::dvec3& light, std::uint8_t* rgb) {
  const glm::dvec3 seen = seenColor(light);
  for (int k = 0; k < 3; ++k) rgb[k] = static_cast<std::uint8_t>(std::lround(255 * seen[k]));
}

accuracy::Observation observedPicture(const std::vector<float>& radiance, int width, int height) {
  accuracy::Observation observation;
  observation.width = width, observation.height = height;
  observation.values.assign(radiance.begin(), radiance.end());
  observation.seen.reserve(radiance.size());
  for (std::size_t i = 0; i + 2 < radiance.size(); i += 3) {
    const glm::dvec3 seen = seenColor({radiance[i], radiance[i + 1], radiance[i + 2]});
    observation.seen.insert(observation.seen.end(), {seen.x, seen.y, seen.z});
  }
  return observation;
}

core::Image seenPicture(const std::vector<float>& radiance, int width, int height) {
  core::Image picture(width, height);
  for (std::size_t i = 0; 3 * i + 2 < radiance.size(); ++i) {
    writeSeen({radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2]}, &picture.rgba[4 * i]);
    picture.rgba[4 * i + 3] = 255;
  }
  return picture;
}

}  // namespace skydrop::app
