#pragma once

#include "skydrop/render/frame/fallen_water.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/precipitation/precipitation_settings.h"
#include "skydrop/weather/lying_water.h"

namespace skydrop::render {

// What lies on the land as it is drawn: snow from the height on where it is no warmer than half a degree.
FallenWater fallenWater(const weather::State& state, const weather::LyingWater& lying);

// Publishes it for those who draw land. Draws nothing.
class WetGroundPass final : public Pass {
 public:
  explicit WetGroundPass(const PrecipitationSettings& settings) : settings_(settings) {}

  // For the next frame. Costs nothing.
  void apply(const PrecipitationSettings& settings) { settings_ = settings; }

  std::string_view name() const override { return "wetGround"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Switched off, and where nothing lies: it never falls, or the land has dried.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  // Looks back in time once a frame.
  const weather::LyingWater& lying(const FrameInput& frame) const;

  PrecipitationSettings settings_;
  mutable weather::Moment moment_;  // that lying_ is of
  mutable glm::dvec2 place_{0};
  mutable weather::LyingWater lying_;
  FallenWater fallen_;  // published
};

}  // namespace skydrop::render
