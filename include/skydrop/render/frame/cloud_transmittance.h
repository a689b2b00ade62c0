#pragma once

#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// The clouds of a frame as they were seen: for whatever is drawn after them and may lie behind. A resource of
// the frame (FrameResources), published by the pass that draws clouds, valid until the frame has been drawn.
// It belongs to no effect, so that those who are veiled need not know who veils them.
struct CloudTransmittance {
  // Neither is null once this is published.
  const gl::Texture* light = nullptr;      // a: the share of light behind that comes through
  const gl::Texture* distances = nullptr;  // x: where the clouds are, metres from the eye
};

}  // namespace skydrop::render
