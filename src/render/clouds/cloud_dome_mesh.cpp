#include "skydrop/render/clouds/cloud_dome_mesh.h"

#include <cmath>
#include <numbers>

namespace skydrop::render {

CloudDomeMesh makeCloudDomeMesh() {
  constexpr double kRadPerDeg = std::numbers::pi / 180;
  CloudDomeMesh mesh;
  for (std::size_t level = 0; level < kDomeElevationsDeg.size(); ++level) {
    const double elevation = kDomeElevationsDeg[level] * kRadPerDeg;
    const double height = std::sin(elevation), radius = level + 1 < kDomeLevels ? std::cos(elevation) : 0.0;
    for (int segment = 0; segment < kDomeSegments; ++segment) {
      const double azimuth = 2 * std::numbers::pi * segment / kDomeSegments;
      mesh.vertices.push_back(
          {glm::vec3(radius * std::cos(azimuth), height, radius * std::sin(azimuth)), kDomeAlphas[level]});
    }
  }
  for (int level = 0; level + 1 < kDomeLevels; ++level) {
    for (int segment = 0; segment < kDomeSegments; ++segment) {
      const int next = (segment + 1) % kDomeSegments, below = level * kDomeSegments,
                above = below + kDomeSegments;
      for (const int i :
           {below + segment, below + next, above + next, below + segment, above + next, above + segment})
        mesh.indices.push_back(static_cast<std::uint16_t>(i));
    }
  }
  return mesh;
}

}  // namespace skydrop::render
