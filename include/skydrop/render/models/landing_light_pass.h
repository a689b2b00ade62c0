#pragma once

#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/spot_light.h"
#include "skydrop/render/models/aircraft_lights_settings.h"
#include "skydrop/render/models/lamp_glow.h"

namespace skydrop::render {

// Of the lamp in the nose, pointing ahead and down; before exposure.
SpotLight landingSpot(const game::AircraftSnapshot& aircraft, const LandingLightSettings& settings);

// What is left of the lamp in a picture, so that the spot on level land, at most 300 m ahead, saturates at
// kMostShown: what an eye makes of it that gets used to the spot. By day 1 within 1e-3.
double shownShareOf(const SpotLight& spot, double heightAboveGroundM, double exposure);

// The landing light: published as SpotLight for those who draw land. Draws nothing.
class LandingLightPass final : public Pass {
 public:
  // Of white land in the middle of the spot, after exposure.
  static constexpr double kMostShown = 4;
  // Of the sun's elevation: above it the spot adds less than a hundredth to the light on land.
  static constexpr double kOutshinedSine = 0.1;

  explicit LandingLightPass(const LandingLightSettings& settings) : settings_(settings) {}

  // For the next frame. Costs nothing.
  void apply(const LandingLightSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "landingLight"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Off, without an aircraft or of a wreck, and while the sun outshines it.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  LandingLightSettings settings_;
  SpotLight spot_;  // published
};

// The lamp as it is looked at, from ahead.
class LandingLightGlowPass final : public Pass {
 public:
  // The context must outlive it.
  LandingLightGlowPass(gl::Context& context, const LandingLightSettings& settings)
      : settings_(settings), glow_(context) {}

  void apply(const LandingLightSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "landingLightGlow"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // As the other's, but by day too; and from behind.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  LandingLightSettings settings_;
  LampGlow glow_;
};

}  // namespace skydrop::render
