#include "skydrop/render/models/aircraft_lights_pass.h"

#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render/frame/visibility.h"

namespace skydrop::render {
namespace {

constexpr double kRadiusM = 8;  // of a ball around the aircraft that holds every lamp and its glow near by
constexpr double kFarthestM = 30e3;  // 400 cd are there fainter than the faintest star of a dark night

}  // namespace

std::optional<std::string> LampsPass::skipReason(const FrameInput& frame) const {
  if (!frame.game || !frame.game->aircraft.present) return "no aircraft";
  return std::nullopt;
}

void LampsPass::draw(FrameContext& context) {
  const game::AircraftSnapshot& aircraft = context.frame.game->aircraft;
  const View& view = context.frame.view;
  lamps_.areSeenOnModel = context.frame.warmsUp || context.frame.sunSine <= kOutshinedSine;
  lamps_.outside = litLamps(aircraft, settings_, context.frame.simulatedSeconds, view.position);
  if (isInsideCabin(aircraft, view.position)) {
    const LitLamp cabin = cabinLamp(aircraft, settings_);
    lamps_.onModel = lampsOnModel(view, {&cabin, 1}, context.light.exposure);
  } else {
    lamps_.onModel = lampsOnModel(view, lamps_.outside, context.light.exposure);
  }
  context.resources.publish(lamps_);
}

std::optional<std::string> LampGlowPass::skipReason(const FrameInput& frame) const {
  if (!frame.game || !frame.game->aircraft.present) return "no aircraft";
  const glm::dvec3& place = frame.game->aircraft.position;
  if (glm::length(place - frame.view.position) > kFarthestM) return "the aircraft is too far away";
  if (!isPotentiallyVisible(frame.view, place, kRadiusM)) return "the aircraft is out of view";
  return std::nullopt;
}

void LampGlowPass::draw(FrameContext& context) {
  std::vector<Glow> glows;
  if (const auto* lamps = context.resources.find<AircraftLamps>()) {
    for (const LitLamp& lamp : lamps->outside)
      if (lamp.towardsEye > 0) glows.push_back({lamp.position, lamp.color * (lamp.towardsEye * 1e-3)});
  }
  glow_.draw(context, glows);
}

}  // namespace skydrop::render
