#pragma once

#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// How bright the interface is, 1 by day: dimmed to `atNight` for eyes that have adapted to a night
// (SkyLight::adaptation), from dusk on, with the sun 5 degrees below the horizon, to moonlight.
double interfaceBrightness(double adaptation, double atNight);

// Draws what Dear ImGui has built: the draw data of the current ImGui context, after ImGui::Render(). Dear
// ImGui's own OpenGL back-end does not work on OSMesa; this one draws the same bits on every back-end.
//
// Textures: an ImTextureID is the id of a GL texture. The font atlas is uploaded at construction, so fonts
// are added to the ImGui context before; call uploadFonts() after changing them.
class ImGuiPass final : public Pass {
 public:
  explicit ImGuiPass(gl::Context& context);
  ~ImGuiPass() override;

  std::string_view name() const override { return "imgui"; }
  RenderStage stage() const override { return RenderStage::menu; }
  std::optional<std::string> skipReason(const FrameInput& input) const override;
  void draw(FrameContext& context) override;

  void uploadFonts();

 private:
  void upload(int vertexCount, int indexCount);

  gl::Context& context_;
  gl::Texture font_;
  gl::Buffer vertices_, indices_;
  gl::VertexArray vertexArray_;
};

}  // namespace skydrop::render
