// Light volumes of the layers that are drawn (clouds::LightVolume), solved on a thread of their own and kept
// as one texture. Context's thread.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "render/clouds/weather_layers.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/light_volume.h"
#include "skydrop/core/latest_job.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// What a texture of volumes is of: layers in their order (nothing: a layer without cloud), and the sun to
// half a degree of height and a degree of azimuth.
struct LightVolumesKey {
  std::vector<std::optional<clouds::LayerMedium>> layers;
  glm::ivec2 sun{0};  // height in halves of a degree, azimuth in degrees; below the horizon (0, 0)

  bool operator==(const LightVolumesKey&) const = default;
};
glm::ivec2 roundedSun(const glm::dvec3& toSun);
glm::dvec3 toRoundedSun(const glm::ivec2& sun);

// Of the one layer of the settings.
LightVolumesKey lightVolumesKey(const clouds::LayerMedium& medium, const glm::dvec3& toSun);
// Of the weather's: rounded, so that they last while it changes a little.
LightVolumesKey lightVolumesKey(std::span<const DrawnLayer> layers, const glm::dvec3& toSun);

class LightVolumes {
 public:
  // The context must outlive it.
  LightVolumes(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise);

  // Whether there is a texture for a frame. waits: the layers' and the sun's own, however long it takes (1 to
  // 2 s a layer). Else what is there: that of the weather and sun before, until their own is solved.
  bool update(const LightVolumesKey& key, bool waits);

  // RG16F: clouds::LightVolume's texels, rows of all layers one upon the other. After update() said so.
  void bind(GLuint unit) const { texture_.bind(unit); }

 private:
  struct Solved {
    LightVolumesKey key;
    std::vector<std::shared_ptr<const std::vector<std::uint32_t>>> layers;  // two halves a texel
  };
  void upload(const Solved& solved);

  gl::Context& context_;
  gl::Texture texture_;
  std::optional<LightVolumesKey> shown_, asked_;
  core::LatestJob<LightVolumesKey, Solved> job_;
};

}  // namespace skydrop::render
