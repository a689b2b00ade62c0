// A level plain with bumps of the tests' choice, for passes that need something solid beneath them.
#pragma once

#include <memory>
#include <utility>

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/models/model.h"

namespace skydrop::test {

class GroundPass final : public render::Pass {
 public:
  // `mesh` in metres around `middle`; grey.
  GroundPass(render::gl::Context& context, const render::MeshData& mesh, const glm::dvec3& middle)
      : model_(context, modelOf(mesh), "test ground"), middle_(middle) {}

  std::string_view name() const override { return "ground"; }
  render::RenderStage stage() const override { return render::RenderStage::terrain; }
  void draw(render::FrameContext& context) override {
    model_.draw(context.shaders, "models/model.vert", "models/model.frag", context.defines,
                render::bodyMatrix(context.frame.view, middle_, glm::dquat(1, 0, 0, 0)),
                render::ModelPose(model_), {});
  }

 private:
  static render::ModelData modelOf(const render::MeshData& mesh) {
    render::ModelData data;
    data.nodes = {{"ground", -1, glm::mat4(1), {0}}};
    data.meshes = {{"ground", mesh, 0}};
    data.images.emplace_back(1, 1);
    data.images[0].rgba = {90, 95, 90, 255};
    data.materials = {{"grey", {0}, {}}};
    return data;
  }

  render::Model model_;
  glm::dvec3 middle_;
};

}  // namespace skydrop::test
