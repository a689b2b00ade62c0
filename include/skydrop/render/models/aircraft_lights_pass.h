#pragma once

#include "skydrop/render/models/aircraft_lamps.h"
#include "skydrop/render/models/lamp_glow.h"

namespace skydrop::render {

// The aircraft's position and anti-collision lights (aircraft_lamps.h), published as AircraftLamps for those
// who draw the aircraft, which they light, and for the pass below. Draws nothing.
class LampsPass final : public Pass {
 public:
  // Of the sun's elevation: above it they add less than a hundredth to the light on the aircraft.
  static constexpr double kOutshinedSine = 0.1;

  explicit LampsPass(const AircraftLightsSettings& settings) : settings_(settings) {}

  // For the next frame. Costs nothing.
  void apply(const AircraftLightsSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "aircraftLamps"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  AircraftLightsSettings settings_;
  AircraftLamps lamps_;  // published
};

// These lamps as they are looked at.
class LampGlowPass final : public Pass {
 public:
  // The context must outlive it.
  explicit LampGlowPass(gl::Context& context) : glow_(context) {}

  std::string_view name() const override { return "lampGlow"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  // Without an aircraft, and farther away than a lamp is seen.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  LampGlow glow_;
};

}  // namespace skydrop::render
