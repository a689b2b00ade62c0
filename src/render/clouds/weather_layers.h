// The layers of the weather that are drawn as volumes, at a place and moment. Their media change a little
// from frame to frame; what is expensive to work out of them (occupancy, clear air, sky cover) holds for a
// range of cover and heights each, is made ahead on a thread of its own, and depends on the state alone:
// frames are functions of it. Context's thread.
#pragma once

#include <array>
#include <cstdint>
#include <future>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "skydrop/clouds/clear_air.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/sky_cover.h"
#include "skydrop/render/frame/frame_input.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/weather/moment.h"

namespace skydrop::render {

// For what layers the work holds: those of less cover than `most` and more than `leastCoverage`, of bases and
// tops near its own.
struct LayerRange {
  clouds::LayerMedium most;
  double leastCoverage = 0;
  bool operator==(const LayerRange&) const = default;
};

// The range that a medium lies in.
LayerRange rangeOf(const clouds::LayerMedium& medium);
// Where a medium lies in it, [0, 1], by its cover.
double placeInRange(const LayerRange& range, const clouds::LayerMedium& medium);

// What is worked out for a range. Immutable.
struct LayerWork {
  LayerRange range;
  std::vector<std::uint8_t> distances;  // clouds::Occupancy
  bool isEmpty = true;
  clouds::ClearAir clearAir;
  clouds::SkyCover least, most;  // at the ends of the range
};

struct DrawnLayer {
  clouds::LayerMedium medium;
  bool isThere = false;  // false: has no cover now, or is another's to draw
  std::shared_ptr<const LayerWork> work;
  double cover = 0;    // of the sky, [0, 1]
  double share = 0;    // placeInRange()
  double skyMean = 1;  // of the sky's light, what it lets through in the mean

  double skyShare(const glm::dvec2& placeInField) const;
};

// How overcast layers that are there leave the sky, [0, 1]: 0 below scattered clouds, 1 below a whole deck.
double overcastOf(const std::vector<DrawnLayer>& layers);

class WeatherLayers {
 public:
  static constexpr std::size_t kMost = weather::kLayers;

  WeatherLayers(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise);

  // Whether there is a weather that has clouds, of whatever genus, and layers of it that may ever be volumes.
  static bool isWeather(const FrameInput& frame) { return frame.game != nullptr && hasWeather(frame); }
  // The media of a moment around a place, without working anything out: of as many layers at any moment.
  static std::vector<DrawnLayer> mediaOf(const weather::Moment& moment, const glm::dvec2& place);

  // Those of the frame. Waits for what is not worked out yet. Frames that follow others prepare the next.
  void update(const FrameInput& frame);

  const std::vector<DrawnLayer>& layers() const { return layers_; }
  // Of the last frame: another object is another weather.
  const std::shared_ptr<const weather::WeatherSettings>& settings() const { return moment_.settings; }
  // Whether shells may overlap in this weather, at some place or time.
  bool mayOverlap() const { return mayOverlap_; }
  const clouds::CloudField& field(std::size_t layer) const { return fields_[layer]; }
  // Those that are there, one after the other; units of shaders/clouds. R8UI, rows of all layers; RGBA32F, a
  // channel each.
  const gl::Texture& distances() const { return distances_; }
  const gl::Texture& skyShares() const { return skyShares_; }

 private:
  static bool hasWeather(const FrameInput& frame);
  using Work = std::shared_ptr<const LayerWork>;
  Work find(const LayerRange& range) const;
  Work get(const LayerRange& range);
  void prepare(const LayerRange& range);
  void keep(Work work);
  void upload(const std::vector<DrawnLayer>& before);

  gl::Context& context_;
  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  weather::Moment moment_;
  glm::dvec2 place_{0};
  bool mayOverlap_ = false;
  std::vector<DrawnLayer> layers_;
  std::vector<clouds::CloudField> fields_;
  std::vector<Work> kept_;  // the newest last
  std::optional<LayerRange> pendingRange_;
  std::future<Work> pending_;
  gl::Texture distances_, skyShares_;
};

}  // namespace skydrop::render
