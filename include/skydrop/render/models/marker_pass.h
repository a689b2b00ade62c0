// Shows where the drop target is: a ring of its radius on the ground, and a beam of light above its middle
// that is seen from 6 km. shaders/shared/marker.glsl has the shapes.
#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// Radiance of the mark before exposure, kcd/m^2: signal orange, by day a share of what a white sheet on the
// ground and the horizon send out, so that it reads on grass, rock, snow and sea; at night a lamp's own.
glm::dvec3 signalRadiance(const SkyLight& light);

// Both parts are drawn as boxes whose pixels look at the scene's depth: one of the ring computes how far from
// the target its piece of ground is, one of the beam how far its ray runs through the light before it meets
// the ground. Clouds in front of either hide it (CloudTransmittance). The ring also lies on a model that
// flies where it is.
class MarkerPass final : public Pass {
 public:
  explicit MarkerPass(gl::Context& context) : empty_(context, "marker") {}

  std::string_view name() const override { return "marker"; }
  RenderStage stage() const override { return RenderStage::weatherEffects; }
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  gl::VertexArray empty_;
};

}  // namespace skydrop::render
