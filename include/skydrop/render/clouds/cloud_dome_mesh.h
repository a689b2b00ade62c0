// The mesh of the cloud dome: a unit hemisphere of strips around the eye. A value; any thread.
// Source: Tarantilis, "Simulating clouds with procedural texturing techniques using the GPU", 2004, chapter
// III: denser strips where alpha changes make the change smooth.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace skydrop::render {

inline constexpr int kDomeLevels = 7, kDomeSegments = 20;

// Of the levels from the horizon to the zenith; the rest after 14 degrees evenly.
inline constexpr std::array<double, kDomeLevels> kDomeElevationsDeg = {
    0, 4, 9, 14, 14 + 76.0 / 3, 14 + 2 * 76.0 / 3, 90};
inline constexpr std::array<float, kDomeLevels> kDomeAlphas = {0, 0.3f, 0.7f, 1, 1, 1, 1};

struct CloudDomeVertex {
  glm::vec3 direction;  // unit, y up
  float alpha;
};

struct CloudDomeMesh {
  std::vector<CloudDomeVertex> vertices;  // levels of kDomeSegments, the zenith once for each segment
  std::vector<std::uint16_t> indices;     // triangles
};

CloudDomeMesh makeCloudDomeMesh();

}  // namespace skydrop::render
