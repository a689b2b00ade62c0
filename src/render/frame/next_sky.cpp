#include "skydrop/render/frame/next_sky.h"

#include <glm/geometric.hpp>

namespace skydrop::render {
namespace {

constexpr double kLeapM = 500;  // from frame to frame: a cut

int missingRows(sky::SkyViews& views, const SkyPlaces& places) {
  return views.missingRows(places.sun) + (places.moon ? views.missingRows(*places.moon) : 0);
}

void makeSome(sky::SkyViews& views, const SkyPlaces& places, int rows) {
  rows -= views.makeSome(places.sun, rows);
  if (places.moon) views.makeSome(*places.moon, rows);
}

}  // namespace

std::optional<SkyPlaces> NextSky::of(const RenderSettings& settings, const FrameInput& frame,
                                     MoonOfFrame* moon) {
  if (settings.sky.model != sky::SkyModel::shell) return std::nullopt;
  const SkyPlaces wanted = skyPlaces(settings, frame.view.position.y, frame.simulatedSeconds, moon);
  const bool leapt = glm::distance(eye_, frame.view.position) > kLeapM;
  eye_ = frame.view.position;
  if (!frame.followsLast || !drawn_ || leapt) {
    drawn_ = wanted;
    next_.reset();
    return std::nullopt;
  }
  const auto views = sky::SkyViews::of(atmosphereOf(settings.atmosphere));
  if (missingRows(*views, wanted) <= kRowsAFrame) {
    drawn_ = wanted;
    next_.reset();
    return std::nullopt;
  }
  // What has been begun is finished, so that a sun that runs does not outrun its sky.
  if (!next_) next_ = wanted;
  makeSome(*views, *next_, kRowsAFrame);
  if (missingRows(*views, *next_) == 0) {
    drawn_ = next_;
    next_.reset();
  }
  return drawn_;
}

}  // namespace skydrop::render
