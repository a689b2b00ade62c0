// Whether a picture of the sea mirrors land where rays on the processor meet it.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "skydrop/render/frame/view.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::test {

// A ray that leaves the sea: 1 where it meets land within 6 km, 0 where not, -1 where it passes close over a
// ridge or below one.
inline int meetsLand(const terrain::HeightSource& ground, const glm::dvec3& foot,
                     const glm::dvec3& direction) {
  double clearM = 1e9;
  for (double along = 1; along < 6000; along *= 1.02) {
    const glm::dvec3 at = foot + direction * along;
    const double height = ground.height({at.x, at.z});
    if (height > 0) clearM = std::min(clearM, (at.y - height) / (1 + 0.01 * along));
  }
  return clearM < -0.5 ? 1 : clearM > 0.5 ? 0 : -1;
}

struct MirrorAgreement {
  int asked = 0, agree = 0;
  int meet = 0, found = 0;  // rays that meet land, and of these those whose pixel mirrors some
  double missed() const { return 1 - static_cast<double>(agree) / asked; }
};

// Linear light of a picture of this view with what the sea mirrors of the scene and without, red, green and
// blue of each pixel, the top row first. Asked of every fourth pixel of deep enough water, `aside` pixels
// from the picture's sides, whose level ray meets land, and of those of which no slope of a calm sea sends
// one there.
inline MirrorAgreement mirrorAgreement(const render::View& view, const terrain::HeightSource& ground,
                                       const std::vector<float>& with, const std::vector<float>& without,
                                       int aside) {
  MirrorAgreement result;
  for (int y = 1; y < view.height; ++y) {
    for (int x = aside; x < view.width - aside; x += 4) {
      const glm::dvec3 ray = render::rayDirection(view, {x + 0.5, view.height - y - 0.5});
      if (ray.y > -0.012) continue;
      const glm::dvec3 foot = view.position + ray * (view.position.y / -ray.y);
      if (ground.height({foot.x, foot.z}) > -0.4) continue;
      const glm::dvec2 level = glm::normalize(glm::dvec2(ray.x, ray.z));
      int verdict = -2;
      for (const double slope : {-0.05, 0.0, 0.05}) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(level.x * slope, 1, level.y * slope));
        glm::dvec3 mirrored = glm::reflect(ray, normal);
        mirrored.y = std::abs(mirrored.y) + 0.003;
        const int met = meetsLand(ground, foot, glm::normalize(mirrored));
        if (slope == 0 && met == 1) verdict = 1;
        if (verdict != 1) verdict = met != 0 ? -1 : verdict == -1 ? -1 : 0;
      }
      if (verdict < 0) continue;
      const std::size_t at = 3 * static_cast<std::size_t>(y * view.width + x);
      const bool isChanged = std::abs(with[at] - without[at]) + std::abs(with[at + 2] - without[at + 2]) >
                             0.01f * (without[at] + without[at + 2]);
      ++result.asked;
      result.meet += verdict;
      result.found += verdict == 1 && isChanged;
      result.agree += isChanged == (verdict == 1);
    }
  }
  return result;
}

}  // namespace skydrop::test
