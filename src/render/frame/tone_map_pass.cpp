#include "skydrop/render/frame/tone_map_pass.h"

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "render/frame/stretch.h"

namespace skydrop::render {

// The programs of a stretched scene and of guards are asked for only by frames that show them: most flights
// never do.
void ToneMapPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const glm::ivec2 scene(context.sceneColor.width(), context.sceneColor.height());
  const glm::ivec2 picture(view.width, view.height);
  const int across = samplesAcross(scene, picture);
  const bool stretches = across == 1 && scene != picture;
  context.gl.api().Disable(GL_DEPTH_TEST);
  context.sceneColor.bind(0);
  std::vector<std::string> defines;
  if (stretches) defines.emplace_back("STRETCHED");
  if (across > 1) defines.emplace_back("SUPERSAMPLED");
  if (context.settings.guardMarks) defines.emplace_back("GUARD_MARKS");
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "tone_map/tone_map.frag", defines);
  shader.use();
  if (scene != picture) shader.setVec2("pictureSize", glm::vec2(picture));
  if (across > 1) shader.setInt("samplesAcross", across);
  triangle_.draw();
}

}  // namespace skydrop::render
