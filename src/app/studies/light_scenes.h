// What light in clouds is judged at: layers, suns and views that the path tracer (clouds/path_tracer.h) has
// traced, and what it saw, as it is kept in assets/judged_clouds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/clouds/layer_medium.h"
#include "skydrop/clouds/path_tracer.h"

namespace skydrop::app {

struct LightScene {
  std::string name;
  std::uint32_t noiseSeed = 0;
  clouds::LayerMedium medium;
  double sunElevationDegrees = 40;
  glm::dvec2 place{0};    // around which the eyes are, m east and south
  bool isFitted = false;  // constants were chosen on it

  glm::dvec3 toSun() const;
  double sunAzimuthDegrees() const;  // by the compass
  // Of all that the traced light depends on.
  std::uint64_t digest() const;
};
const std::vector<LightScene>& lightScenes();
const LightScene& lightScene(std::string_view name);  // throws core::RangeError with the names that there are

// Pictures of a scene: eyes below, in and above the layer, against the sun and with it behind. Rows from the
// top.
struct LightView {
  std::string_view name;
  std::vector<clouds::MarchRay> rays;
};
inline constexpr int kLightViewWidth = 24, kLightViewHeight = 14;
std::vector<LightView> lightViews(const LightScene& scene, int width = kLightViewWidth,
                                  int height = kLightViewHeight);

// The noise of a seed: from the cache, or made.
std::shared_ptr<const clouds::PackedCloudNoise> lightNoise(std::uint32_t seed);

// What the judge saw of a scene: pixels of each view, by its order.
struct JudgedLight {
  int paths = 0;  // a ray
  std::vector<std::vector<clouds::TracedPixel>> views;
};

JudgedLight judge(const LightScene& scene, int paths, core::JobPool* pool,
                  const std::function<void(std::string_view)>& progress);
std::string judgedText(const LightScene& scene, const JudgedLight& judged);
// Throws core::DataError where the file is damaged, or is of another scene than this.
JudgedLight readJudged(const LightScene& scene, const std::filesystem::path& file);
// Below assets/.
std::filesystem::path judgedFile(const LightScene& scene);

}  // namespace skydrop::app
