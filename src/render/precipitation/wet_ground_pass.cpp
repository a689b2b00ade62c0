#include "skydrop/render/precipitation/wet_ground_pass.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numbers>
#include <string>

#include "render/precipitation/falling.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::render {
namespace {

constexpr double kLeastSeen = 0.004;    // share of the ground: a step of the picture
constexpr double kOvercastShare = 0.5;  // of the sky's light that rain lets through to puddles, about

}  // namespace

FallenWater fallenWater(const weather::State& state, const weather::LyingWater& lying) {
  FallenWater fallen;
  fallen.snowLineM = weather::snowLineM(state);
  fallen.wet = lying.wet;
  fallen.snow = lying.snow;
  return fallen;
}

const weather::LyingWater& WetGroundPass::lying(const FrameInput& frame) const {
  const weather::Moment& moment = frame.game->weather;
  const glm::dvec2 place(frame.view.position.x, frame.view.position.z);
  if (moment == moment_ && place == place_) return lying_;
  moment_ = moment;
  place_ = place;
  return lying_ = weather::lyingWater(moment, place);
}

std::optional<std::string> WetGroundPass::skipReason(const FrameInput& frame) const {
  if (!settings_.wetGround) return "switched off";
  if (frame.warmsUp && weatherOf(frame)) return std::nullopt;
  if (!frame.game || !frame.game->weather) return "no weather";
  if (!weather::everFalls(frame.game->weather)) return "it never rains";
  const weather::LyingWater& here = lying(frame);
  if (std::max(here.wet, here.snow) < kLeastSeen) return "the land is dry";
  return std::nullopt;
}

void WetGroundPass::draw(FrameContext& context) {
  const FrameInput& frame = context.frame;
  fallen_ = fallenWater(*weatherOf(frame), frame.warmsUp ? weather::LyingWater{1, 1} : lying(frame));
  fallen_.sky = context.uniforms.skyLight * static_cast<float>(kOvercastShare / std::numbers::pi);
  context.resources.publish(fallen_);
}

}  // namespace skydrop::render
