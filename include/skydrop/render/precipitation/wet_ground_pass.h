#pragma once

#include "skydrop/render/frame/fallen_water.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/precipitation/precipitation_settings.h"
#include "skydrop/weather/state.h"

namespace skydrop::render {

// What of a fall lies on the land: wet from 1 mm/h of rain on, white where snow falls and it is no warmer
// than half a degree. It has no memory: dry land is dry.
FallenWater fallenWater(const weather::State& state);

// Publishes it for those who draw land. Draws nothing.
class WetGroundPass final : public Pass {
 public:
  explicit WetGroundPass(const PrecipitationSettings& settings) : settings_(settings) {}

  // For the next frame. Costs nothing.
  void apply(const PrecipitationSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "wetGround"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Switched off, and where it is dry.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  PrecipitationSettings settings_;
  FallenWater fallen_;  // published
};

}  // namespace skydrop::render
