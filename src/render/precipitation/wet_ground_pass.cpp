#include "skydrop/render/precipitation/wet_ground_pass.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "render/precipitation/falling.h"
#include "skydrop/weather/fall.h"

namespace skydrop::render {
namespace {

constexpr double kWetRate = 1, kSnowedRate = 0.3;  // mm/h, from which all is wet or white
constexpr double kSnowUpToC = 0.5, kLapsePerM = 0.0065;
constexpr double kOvercastShare = 0.5;  // of the sky's light that rain lets through to puddles, about

}  // namespace

FallenWater fallenWater(const weather::State& state) {
  FallenWater fallen;
  const std::optional<weather::FallField> field = weather::fallField(state);
  if (!field) return fallen;
  fallen.snowLineM = (state.temperatureC - kSnowUpToC) / kLapsePerM;
  const weather::Precipitation ground = weather::fallAt(state, 0);
  const weather::Precipitation high = weather::fallAt(state, std::max(fallen.snowLineM, 0.0) + 300);
  fallen.wet = std::clamp((ground.rain + ground.sleet + ground.hail) / kWetRate, 0.0, 1.0);
  fallen.snow = std::clamp(high.snow / kSnowedRate, 0.0, 1.0);
  return fallen;
}

std::optional<std::string> WetGroundPass::skipReason(const FrameInput& frame) const {
  if (!settings_.wetGround) return "switched off";
  if (frame.warmsUp && weatherOf(frame)) return std::nullopt;
  return whyDry(weatherOf(frame));
}

void WetGroundPass::draw(FrameContext& context) {
  fallen_ = fallenWater(*weatherOf(context.frame));
  fallen_.sky = context.uniforms.skyLight * static_cast<float>(kOvercastShare / std::numbers::pi);
  context.resources.publish(fallen_);
}

}  // namespace skydrop::render
