#pragma once

#include <memory>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/model.h"
#include "skydrop/render/models/shadow_source.h"

namespace skydrop::render {

// The aircraft's model as the snapshot has it: control surfaces follow the controls, and from a place inside
// the cabin its panel is drawn and the outside is seen from within (back faces are not drawn).
class AircraftPass final : public Pass {
 public:
  // `model`: assets/models/airplane.glb on this context, shared with the propeller's pass.
  explicit AircraftPass(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

  // For the aircraft's shadow.
  const std::shared_ptr<const Model>& model() const { return model_; }

  std::string_view name() const override { return "aircraft"; }
  RenderStage stage() const override { return RenderStage::models; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  PixelBox extent(const FrameInput& frame) const override;
  bool isMirrored() const override { return true; }
  void draw(FrameContext& context) override;

 private:
  std::shared_ptr<const Model> model_;
};

// The aircraft as it hides the sun: turning blades hide next to nothing and are left out.
ShadowSource aircraftShadow(std::shared_ptr<const Model> model);

// The veil of the turning blades. It is translucent, so it comes after the sky.
class PropellerPass final : public Pass {
 public:
  explicit PropellerPass(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

  std::string_view name() const override { return "propeller"; }
  RenderStage stage() const override { return RenderStage::translucents; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  std::shared_ptr<const Model> model_;
};

}  // namespace skydrop::render
