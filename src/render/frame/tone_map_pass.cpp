#include "skydrop/render/frame/tone_map_pass.h"

#include <array>
#include <string>

namespace skydrop::render {

// The program of a stretched scene is asked for only by frames that show one: most flights never do.
void ToneMapPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const bool stretches =
      context.sceneColor.width() != view.width || context.sceneColor.height() != view.height;
  context.gl.api().Disable(GL_DEPTH_TEST);
  context.sceneColor.bind(0);
  if (stretches) {
    const std::array<std::string, 1> defines = {"STRETCHED"};
    gl::Shader& shader = context.shaders.shader("fullscreen.vert", "tone_map/tone_map.frag", defines);
    shader.use();
    shader.setVec2("pictureSize", {static_cast<float>(view.width), static_cast<float>(view.height)});
  } else {
    context.shaders.shader("fullscreen.vert", "tone_map/tone_map.frag").use();
  }
  triangle_.draw();
}

}  // namespace skydrop::render
