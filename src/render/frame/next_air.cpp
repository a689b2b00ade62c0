#include "skydrop/render/frame/next_air.h"

#include <utility>

#include "render/frame/moon_view.h"
#include "skydrop/core/thread_priority.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {

NextAir::NextAir() : job_([](const Key& key, const std::stop_token&) { return make(key); }) {}

NextAir::Made NextAir::make(const Key& key) {
  core::lowerThreadPriority();
  auto views = sky::SkyViews::of(atmosphereOf(key.air));
  for (const double sine : key.sines) views->view(key.eyeM, sine);
  return {key.air, key.number, std::move(views)};
}

void NextAir::take() {
  auto made = job_.take();
  if (!made || made->number <= outdated_) return;
  drawn_ = made->air;
  views_ = std::move(made->views);
}

const AtmosphereSettings& NextAir::of(const RenderSettings& settings, const FrameInput& frame) {
  if (!frame.followsLast || !drawn_ || settings.sky.model != sky::SkyModel::shell) {
    wanted_ = drawn_ = settings.atmosphere;
    outdated_ = requests_;
    return *drawn_;
  }
  take();
  if (settings.atmosphere == wanted_) return *drawn_;
  wanted_ = settings.atmosphere;
  if (wanted_ == drawn_) {
    outdated_ = requests_;
    return *drawn_;
  }
  const double seconds = frame.simulatedSeconds, sun = directionToSun(settings.sun, seconds).y;
  const bool hasMoon = settings.sun.source == SunSource::clock && sun < 0;
  const double moon = hasMoon ? moonOf(frame.moon, settings.sun, seconds).direction.y : sun;
  job_.request({settings.atmosphere, frame.view.position.y, {sun, moon}, ++requests_});
  return *drawn_;
}

}  // namespace skydrop::render
