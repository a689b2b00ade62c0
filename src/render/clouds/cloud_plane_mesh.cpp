#include "skydrop/render/clouds/cloud_plane_mesh.h"

#include <array>
#include <cmath>

namespace skydrop::render {

CloudPlaneMesh makeCloudPlaneMesh() {
  constexpr int kLines = kPlaneSegments + 1;
  const auto lineAt = [](int i) {
    const float even = 2.0f * static_cast<float>(i) / kPlaneSegments - 1.0f;
    return even * std::abs(even);
  };
  const auto isRim = [](int i) { return i == 0 || i == kLines - 1; };
  CloudPlaneMesh mesh;
  for (int z = 0; z < kLines; ++z) {
    for (int x = 0; x < kLines; ++x)
      mesh.vertices.push_back({{lineAt(x), lineAt(z)}, isRim(x) || isRim(z) ? 0.0f : 1.0f});
  }
  for (int z = 0; z < kPlaneSegments; ++z) {
    for (int x = 0; x < kPlaneSegments; ++x) {
      const int corner = z * kLines + x;
      // The diagonal runs towards the middle, so that the rim's corners fade as its sides do.
      const bool rising = (2 * x < kPlaneSegments) == (2 * z < kPlaneSegments);
      const int a = corner, b = corner + 1, c = corner + kLines, d = corner + kLines + 1;
      for (const int i : rising ? std::array{a, b, d, a, d, c} : std::array{a, b, c, b, d, c})
        mesh.indices.push_back(static_cast<std::uint16_t>(i));
    }
  }
  return mesh;
}

}  // namespace skydrop::render
