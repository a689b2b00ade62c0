#include "skydrop/render/models/landing_light_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>

#include "skydrop/core/shared_lamps.h"

namespace skydrop::render {
namespace {

// Body axes of airplane.glb, m: below the propeller's hub, outside of the cowl.
constexpr glm::dvec3 kLampPlace{0, -0.35, -2.95};
constexpr glm::dvec3 kLampColor{1.09, 0.99, 0.79};  // 3400 K on the way to white, of luminance 1
constexpr double kFarthestSpotM = 300;              // what the eye gets used to lies nearer
constexpr double kLensM = 0.07;

std::optional<std::string> whyNot(const FrameInput& frame, const LandingLightSettings& settings) {
  if (!settings.on) return "switched off";
  if (!frame.game || !frame.game->aircraft.present) return "no aircraft";
  if (frame.game->aircraft.crashed) return "the aircraft is a wreck";
  return std::nullopt;
}

}  // namespace

SpotLight landingSpot(const game::AircraftSnapshot& aircraft, const LandingLightSettings& settings) {
  const double tilt = glm::radians(settings.tiltDegrees);
  SpotLight spot;
  spot.position = aircraft.position + aircraft.orientation * kLampPlace;
  spot.axis = aircraft.orientation * glm::dvec3(0, -std::sin(tilt), -std::cos(tilt));
  spot.halfAngleRad = glm::radians(settings.beamDegrees / 2);
  spot.intensity = kLampColor * (settings.intensity * 1e-3);
  return spot;
}

double shownShareOf(const SpotLight& spot, double heightAboveGroundM, double exposure) {
  const double height = std::max(heightAboveGroundM, 1.0);
  const double distance = std::clamp(height / std::max(-spot.axis.y, 1e-3), height, kFarthestSpotM);
  const double facing = std::clamp(height / distance, 0.0, 1.0);
  const double intensity = std::max({spot.intensity.x, spot.intensity.y, spot.intensity.z});
  const double shown = intensity * facing / (distance * distance) * exposure / std::numbers::pi;
  return 1 / (1 + shown / LandingLightPass::kMostShown);
}

std::optional<std::string> LandingLightPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp && frame.game && frame.game->aircraft.present) return std::nullopt;
  if (auto reason = whyNot(frame, settings_)) return reason;
  if (frame.sunSine > kOutshinedSine) return "the sun outshines it";
  return std::nullopt;
}

void LandingLightPass::draw(FrameContext& context) {
  const game::AircraftSnapshot& aircraft = context.frame.game->aircraft;
  spot_ = landingSpot(aircraft, settings_);
  const double exposure = context.light.exposure;
  spot_.intensity *= exposure * shownShareOf(spot_, aircraft.heightAboveGround, exposure);
  context.resources.publish(spot_);
}

std::optional<std::string> LandingLightGlowPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (auto reason = whyNot(frame, settings_)) return reason;
  const SpotLight spot = landingSpot(frame.game->aircraft, settings_);
  if (glm::dot(spot.axis, frame.view.position - spot.position) <= 0) return "it shines away from the eye";
  return std::nullopt;
}

void LandingLightGlowPass::draw(FrameContext& context) {
  if (!context.frame.game || !context.frame.game->aircraft.present) return glow_.draw(context, {});
  const SpotLight spot = landingSpot(context.frame.game->aircraft, settings_);
  const glm::dvec3 toEye = context.frame.view.position - spot.position;
  const double distance = std::max(glm::length(toEye), core::shared::f64::kLampLensM);
  const double share = core::shared::f64::spotShare(spot.axis, toEye / distance, spot.halfAngleRad);
  const Glow glow{spot.position, spot.intensity * share, kLensM};
  glow_.draw(context, {&glow, 1});
}

}  // namespace skydrop::render
