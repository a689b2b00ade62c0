#include "skydrop/render/frame/tone_map_pass.h"

#include <string>
#include <vector>

namespace skydrop::render {

// The programs of a stretched scene and of guards are asked for only by frames that show them: most flights
// never do.
void ToneMapPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const bool stretches =
      context.sceneColor.width() != view.width || context.sceneColor.height() != view.height;
  context.gl.api().Disable(GL_DEPTH_TEST);
  context.sceneColor.bind(0);
  std::vector<std::string> defines;
  if (stretches) defines.emplace_back("STRETCHED");
  if (context.settings.guardMarks) defines.emplace_back("GUARD_MARKS");
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "tone_map/tone_map.frag", defines);
  shader.use();
  if (stretches)
    shader.setVec2("pictureSize", {static_cast<float>(view.width), static_cast<float>(view.height)});
  triangle_.draw();
}

}  // namespace skydrop::render
