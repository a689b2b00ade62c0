// Draws the maps of the shadows that fall on land in view.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/model.h"

namespace skydrop::render {

// Takes one part of a thing that is made of models: the model, where it stands (to eye-relative world axes)
// and how.
using DrawPart = std::function<void(const Model& model, const glm::mat4& toEye, const ModelPose& pose)>;

// Something solid that hides the sun.
struct ShadowCaster {
  glm::dvec3 middle{0};  // of a ball that holds it, world
  double radiusM = 0;
  double areaM2 = 0;  // of its outline, roughly: how far off its shadow can be told
  std::function<void(const View&, const DrawPart&)> parts;
};

// Adds what there is at a moment. It must stay callable as long as the pass lives; what a caster refers to
// must outlive the frame.
using ShadowSource = std::function<void(const game::Snapshot&, std::vector<ShadowCaster>&)>;

// The shadows go to FrameContext::shadows. If there are more casters than CastShadows::kMost, the nearest
// have them.
class ShadowPass final : public Pass {
 public:
  void add(ShadowSource source) { sources_.push_back(std::move(source)); }

  std::string_view name() const override { return "shadows"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  std::vector<ShadowCaster> castersIn(const game::Snapshot& snapshot) const;

  std::vector<ShadowSource> sources_;
};

}  // namespace skydrop::render
