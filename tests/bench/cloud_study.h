// Clouds alone, drawn headless from a view with settings of one's choice: what they cost and how far they are
// from what others drew. No land, no sky.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "app/types/pose.h"
#include "app/types/size.h"
#include "bench/plain_march.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/clouds/cloud_system.h"
#include "skydrop/render/frame/renderer.h"

namespace skydrop::bench {

struct CloudView {
  const char* name;
  glm::dvec3 position;              // metres
  double yawDegrees, pitchDegrees;  // as in app::Pose
  double rollDegrees = 0;
  double seconds = 0;        // simulated
  bool followsLast = false;  // as render::FrameInput
};

// Under the layer, in it, over it, and along it to where clouds have faded.
inline constexpr std::array kCloudViews = {
    CloudView{"below", {0, 600, 0}, 40, 12}, CloudView{"inside", {600, 2300, 600}, 40, 0},
    CloudView{"above", {0, 4500, 0}, 40, -15}, CloudView{"far", {0, 900, 0}, 220, 6}};

// Of a pass, between two glFinish.
struct Cost {
  double processorMs = 1e9;  // of all threads of the process: other programs do not count
  double wallMs = 1e9;
};
// The smaller of each.
Cost best(const Cost& a, const Cost& b);

// What the eye sees, a texel a pixel.
struct CloudPicture {
  std::vector<glm::vec3> radiance;  // linear, multiplied by exposure
  std::vector<float> opacity;       // of single rays; only of drawn frames with a ray a pixel
};

// RMS of the difference over the RMS of the reference, where that has an opacity above 0.01.
double relativeError(const std::vector<glm::vec3>& radiance, const CloudPicture& reference);

// Settings of the scene fair with what a tier's file says. Throws core::DataError.
clouds::CloudSettings settingsOf(clouds::CloudTier tier);

class CloudStudy {
 public:
  explicit CloudStudy(app::Size size);
  CloudStudy(const CloudStudy&) = delete;
  CloudStudy& operator=(const CloudStudy&) = delete;

  std::string renderer() const { return context_->renderer(); }
  // What clouds hold on the GPU after the frames drawn so far; the plain march must not have been asked for.
  std::uint64_t cloudBytes() const;

  // For the next frames.
  void use(const clouds::CloudSettings& settings);

  // The clouds of the next frames are those of a weather; null: of the settings again.
  void useWeather(std::shared_ptr<const weather::WeatherSettings> weather) {
    snapshot_.weather = {std::move(weather), 1, 0};
  }
  void setWeatherSeconds(double seconds) { snapshot_.weather.seconds = seconds; }

  Cost draw(const CloudView& view);
  // Draws both and gives the time of the plain march. The frame warms up what draw() needs.
  Cost drawPlain(const CloudView& view);

  CloudPicture picture();                  // of the last draw()
  std::vector<glm::vec3> plainRadiance();  // of the last drawPlain()
  render::CloudSystem::Work lastWork() const { return clouds_->lastWork(); }

 private:
  void drawFrame(const CloudView& view, bool plain);

  app::Size size_;
  std::unique_ptr<render::gl::Context> context_;
  render::Renderer renderer_;
  std::uint64_t bytesWithoutClouds_ = 0;
  clouds::CloudSettings settings_;
  core::WindSettings wind_;
  game::Snapshot snapshot_;
  Cost cloudCost_, plainCost_;
  render::CloudSystem* clouds_ = nullptr;  // the renderer's, as the next
  PlainMarch* plain_ = nullptr;
};

}  // namespace skydrop::bench
