// Level plains of one colour each, 400 km wide, that go along with the eye.
#pragma once

#include <string>
#include <vector>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/mesh.h"
#include "skydrop/render/models/mesh_data.h"
#include "support/temporary_folder.h"

namespace skydrop::test {

struct Plain {
  double heightM;
  glm::vec3 light;  // as the scene holds it: linear
};

class PlainsPass final : public render::Pass {
 public:
  // Draws what `plains` holds at each frame, in its order; the folder takes the shaders.
  PlainsPass(render::gl::Context& context, const TemporaryFolder& folder, const std::vector<Plain>& plains)
      : plane_(context, render::planeMesh(4e5, 4e5, 1, 1), "plain"),
        vertex_(folder.write("plain.vert",
                             "#include \"frame.glsl\"\nlayout(location = 0) in vec3 position;\n"
                             "uniform vec3 place;\nvoid main() { gl_Position = frame.viewProjection * "
                             "vec4(position + place, 1.0); }\n")),
        fragment_(folder.write(
            "plain.frag",
            "uniform vec3 light;\nout vec4 color;\nvoid main() { color = vec4(light, 1.0); }\n")),
        plains_(plains) {}

  std::string_view name() const override { return "plains"; }
  render::RenderStage stage() const override { return render::RenderStage::terrain; }
  void draw(render::FrameContext& context) override {
    const render::View& view = context.frame.view;
    render::gl::Shader& shader = context.shaders.shader(vertex_, fragment_);
    shader.use();
    for (const Plain& plain : plains_) {
      shader.setVec3("place", render::relativeToEye(view, {view.position.x, plain.heightM, view.position.z}));
      shader.setVec3("light", plain.light);
      plane_.draw();
    }
  }

 private:
  render::Mesh plane_;
  std::string vertex_, fragment_;
  const std::vector<Plain>& plains_;
};

}  // namespace skydrop::test
