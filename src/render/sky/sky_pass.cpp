#include "skydrop/render/sky/sky_pass.h"

#include <span>
#include <string>
#include <vector>

#include "render/frame/visibility.h"

namespace skydrop::render {

// Where no ray of the picture goes down, the plain below the horizon and the look-up of what lies before it
// are left out. Both are asked for, so that none is compiled when the view turns up.
void SkyPass::draw(FrameContext& context) {
  context.gl.api().DepthMask(GL_FALSE);
  std::vector<std::string> above(context.defines.begin(), context.defines.end());
  above.emplace_back("SKY_ALONE");
  const bool isAlone = leastRise(context.frame.view) > 0;
  for (const bool alone : {!isAlone, isAlone}) {
    if (alone != isAlone && !context.frame.looksAhead()) continue;
    gl::Shader& shader = context.shaders.shader(
        "fullscreen.vert", "sky/sky.frag", alone ? std::span<const std::string>(above) : context.defines);
    if (alone != isAlone && !context.frame.warmsUp) continue;
    shader.use();
    triangle_.draw();
  }
}

}  // namespace skydrop::render
