#include "skydrop/render/sky/sky_pass.h"

namespace skydrop::render {

void SkyPass::draw(FrameContext& context) {
  context.gl.api().DepthMask(GL_FALSE);
  context.shaders.shader("fullscreen.vert", "sky/sky.frag", context.defines).use();
  triangle_.draw();
}

}  // namespace skydrop::render
