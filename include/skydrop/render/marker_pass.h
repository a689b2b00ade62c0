#pragma once

#include "skydrop/render/mesh.h"
#include "skydrop/render/pass.h"

namespace skydrop::render {

// Where the target is: a ring on the ground at its radius, and a beam of light above its middle that stays
// visible from 6 km and beyond, because it is never narrower than a few pixels.
class MarkerPass final : public Pass {
 public:
  explicit MarkerPass(gl::Context& context);

  std::string_view name() const override { return "marker"; }
  Slot slot() const override { return Slot::translucents; }
  std::optional<std::string> idleReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  Mesh cylinder_;  // radius 1, height -1..1: what the ring can cover
  Mesh strip_;     // x -1..1 across, y 0..1 up: the beam
};

}  // namespace skydrop::render
