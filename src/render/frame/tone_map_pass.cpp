#include "skydrop/render/frame/tone_map_pass.h"

namespace skydrop::render {

void ToneMapPass::draw(FrameContext& context) {
  context.gl.api().Disable(GL_DEPTH_TEST);
  context.sceneColor.bind(0);
  context.shaders.shader("fullscreen.vert", "tone_map/tone_map.frag").use();
  triangle_.draw();
}

}  // namespace skydrop::render
