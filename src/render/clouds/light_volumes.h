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

// What a texture of volumes is of: layers in their order (nothing: a layer without cloud), the sun to half a
// degree of height and a degree of azimuth, and cells.
struct LightVolumesKey {
  std::vector<std::optional<clouds::LayerMedium>> layers;
  glm::ivec2 sun{0};  // height in halves of a degree, azimuth in degrees; below the horizon (0, 0)
  int side = clouds::LightVolume::kSide;

  bool operator==(const LightVolumesKey&) const = default;
};
glm::ivec2 roundedSun(const glm::dvec3& toSun);
glm::dvec3 toRoundedSun(const glm::ivec2& sun);

// Across a period.
int volumeSide(clouds::LightCells cells);

// Of the one layer of the settings.
LightVolumesKey lightVolumesKey(const clouds::LayerMedium& medium, const glm::dvec3& toSun,
                                clouds::LightCells cells);
// Of the weather's: rounded, so that they last while it changes a little.
LightVolumesKey lightVolumesKey(std::span<const DrawnLayer> layers, const glm::dvec3& toSun,
                                clouds::LightCells cells);

// Whether the light of one is so near to that of the other that it may stand for it until that is solved: the
// same layers, a little more or less of them, and a sun that has moved by a few degrees.
bool isNear(const LightVolumesKey& a, const LightVolumesKey& b);

class LightVolumes {
 public:
  // The context must outlive it.
  LightVolumes(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise);

  // The texture of a frame, seen from a place in the field (x, z). waits: of the layers' and the sun's own
  // volumes, however long it takes (1 to 2 s a layer). Else of what is there: that of the weather and sun
  // before, until their own is solved, into which it turns over the next frames. Where that before is none,
  // or far off, its surroundings are solved first, a sixteenth of the period, in less than a tenth of a
  // second; and until then, where there is none, light is even.
  void update(const LightVolumesKey& key, const glm::dvec2& eyeInField, bool waits);

  // RG16F: clouds::LightVolume's texels, rows of all layers one upon the other; after the first update().
  void bind(GLuint unit) const { texture_.bind(unit); }

 private:
  using Halves = std::vector<std::uint16_t>;
  struct Task {
    LightVolumesKey key;
    std::optional<glm::dvec2> around;  // solved first, alone; none: all of it
    bool operator==(const Task&) const = default;
  };
  struct Solved {
    Task task;
    std::shared_ptr<const Halves>
        texels;  // as in the texture; of surroundings the rest is the last solution's
  };
  class Solver;

  // Whether the texture is, or turns into, all of what a key says.
  bool isWhole(const LightVolumesKey& key) const;
  void ask(const LightVolumesKey& key, const std::optional<glm::dvec2>& around);
  void showEven(std::size_t layers);
  void show(Solved solved);      // at once
  void turnInto(Solved solved);  // over the next frames
  void blend();

  gl::Context& context_;
  gl::Texture texture_;
  std::optional<Task> asked_;
  std::optional<Solved>
      target_;  // what is shown, or will be once all parts have been blended; none: even light
  // What the texture holds while it turns into the target, by a share of what is left in each frame, part by
  // part.
  Halves now_;
  int parts_ = 1, part_ = 0, stepsLeft_ = 0;
  core::LatestJob<Task, Solved> job_;
};

}  // namespace skydrop::render
