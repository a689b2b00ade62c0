// What mountains leave of the sun on clouds without thickness (shaders/clouds/land_shade.glsl).
#pragma once

#include <span>
#include <string>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/shadows/land_shade_volume.h"

namespace skydrop::render {

// Main thread, on the context's thread. Holds a texture from the first frame on in which land may shade a
// sheet, as long as the effect landShadows is there.
class SheetShade {
 public:
  // Whether land may take light from the sun at a height (m) in this frame: the shade of mountains ends below
  // their summits. Uploads the shade where it may.
  bool take(FrameContext& context, double heightM);
  // A program of a sheet for a frame in which it may or not. Where later frames may need the other variant,
  // that is asked for too.
  gl::Shader& shader(FrameContext& context, const std::string& vertex, const std::string& fragment,
                     std::span<const std::string> defines, bool shaded);

 private:
  LandShadeVolume volume_;
};

}  // namespace skydrop::render
