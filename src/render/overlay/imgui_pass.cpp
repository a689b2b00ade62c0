#include "skydrop/render/overlay/imgui_pass.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>

namespace skydrop::render {
namespace {

// ImTextureID is a pointer in some versions of Dear ImGui and an integer in others.
template <class Id>
Id textureId(GLuint name) {
  if constexpr (std::is_pointer_v<Id>) {
    return reinterpret_cast<Id>(static_cast<std::uintptr_t>(name));
  } else {
    return static_cast<Id>(name);
  }
}

template <class Id>
GLuint textureName(Id id) {
  if constexpr (std::is_pointer_v<Id>) {
    return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id));
  } else {
    return static_cast<GLuint>(id);
  }
}

constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;

// Room for a half more than is needed now, so that a growing menu does not reallocate each frame.
void makeRoom(gl::Context& context, gl::Buffer& buffer, std::size_t bytes, std::string_view label) {
  if (!buffer || buffer.size() < bytes)
    buffer = gl::Buffer(context, bytes + bytes / 2, gl::Buffer::Use::write, label);
}

}  // namespace

ImGuiPass::ImGuiPass(gl::Context& context) : context_(context), vertexArray_(context, "imgui") {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  vertexArray_.setAttribute(0, 0, 2, GL_FLOAT, offsetof(ImDrawVert, pos));
  vertexArray_.setAttribute(1, 0, 2, GL_FLOAT, offsetof(ImDrawVert, uv));
  vertexArray_.setAttribute(2, 0, 4, GL_UNSIGNED_BYTE, offsetof(ImDrawVert, col), true);
  uploadFonts();
}

ImGuiPass::~ImGuiPass() {
  if (ImGui::GetCurrentContext()) ImGui::GetIO().Fonts->SetTexID(textureId<ImTextureID>(0));
}

void ImGuiPass::uploadFonts() {
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  unsigned char* texels = nullptr;
  int width = 0, height = 0;
  fonts.GetTexDataAsRGBA32(&texels, &width, &height);
  font_ = gl::Texture::make2D(context_, GL_RGBA8, width, height, "imgui fonts");
  const std::size_t bytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4;
  font_.upload(GL_RGBA, GL_UNSIGNED_BYTE, std::as_bytes(std::span<const unsigned char>(texels, bytes)));
  fonts.SetTexID(textureId<ImTextureID>(font_.id()));
}

std::optional<std::string> ImGuiPass::skipReason(const FrameInput&) const {
  const ImDrawData* data = ImGui::GetCurrentContext() ? ImGui::GetDrawData() : nullptr;
  if (!data || data->TotalVtxCount == 0) return "nothing shown";
  return std::nullopt;
}

void ImGuiPass::upload(int vertexCount, int indexCount) {
  makeRoom(context_, vertices_, static_cast<std::size_t>(vertexCount) * sizeof(ImDrawVert), "imgui vertices");
  makeRoom(context_, indices_, static_cast<std::size_t>(indexCount) * sizeof(ImDrawIdx), "imgui indices");
  vertexArray_.setVertexBuffer(0, vertices_, 0, sizeof(ImDrawVert));
  vertexArray_.setIndexBuffer(indices_);
  const ImDrawData& data = *ImGui::GetDrawData();
  std::size_t vertexAt = 0, indexAt = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    const std::span vertices(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size));
    const std::span indices(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size));
    vertices_.write(vertexAt, std::as_bytes(vertices));
    indices_.write(indexAt, std::as_bytes(indices));
    vertexAt += vertices.size_bytes();
    indexAt += indices.size_bytes();
  }
}

double interfaceBrightness(double adaptation, double atNight) {
  constexpr double kDay = 0.08, kDuskSteps = 1.5, kNightSteps = 4.5;  // of the exposure's decimal logarithm
  if (!(adaptation > 0) || !std::isfinite(adaptation)) return 1;
  const double steps = std::log10(adaptation / kDay);
  const double night = std::clamp((steps - kDuskSteps) / (kNightSteps - kDuskSteps), 0.0, 1.0);
  return 1 + (atNight - 1) * night * night * (3 - 2 * night);
}

void ImGuiPass::draw(FrameContext& context) {
  const ImDrawData& data = *ImGui::GetDrawData();
  if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
  upload(data.TotalVtxCount, data.TotalIdxCount);

  const gl::Functions& gl = context_.api();
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl::Shader& shader = context.shaders.shader("imgui/imgui.vert", "imgui/imgui.frag");
  // ImGui counts from the top left corner, the target from the bottom left.
  const float scaleX = 2 / data.DisplaySize.x, scaleY = -2 / data.DisplaySize.y;
  shader.setVec4("pixelsToNdc",
                 {scaleX, scaleY, -1 - data.DisplayPos.x * scaleX, 1 - data.DisplayPos.y * scaleY});
  shader.setFloat("brightness", static_cast<float>(interfaceBrightness(context.light.adaptation,
                                                                       context.settings.interfaceAtNight)));
  shader.use();
  vertexArray_.bind();

  const float width = static_cast<float>(context.frame.view.width);
  const float height = static_cast<float>(context.frame.view.height);
  const float toPixelsX = width / data.DisplaySize.x, toPixelsY = height / data.DisplaySize.y;
  std::size_t vertexBase = 0, indexBase = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback) continue;  // nothing of ours uses callbacks
      const float left = std::max((command.ClipRect.x - data.DisplayPos.x) * toPixelsX, 0.0f);
      const float right = std::min((command.ClipRect.z - data.DisplayPos.x) * toPixelsX, width);
      const float top = std::max((command.ClipRect.y - data.DisplayPos.y) * toPixelsY, 0.0f);
      const float bottom = std::min((command.ClipRect.w - data.DisplayPos.y) * toPixelsY, height);
      if (right <= left || bottom <= top) continue;
      gl.Scissor(static_cast<GLint>(left), static_cast<GLint>(height - bottom),
                 static_cast<GLsizei>(right - left), static_cast<GLsizei>(bottom - top));
      gl.BindTextureUnit(0, textureName(command.GetTexID()));
      context_.drawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                            indexBase + command.IdxOffset,
                            static_cast<GLint>(vertexBase + command.VtxOffset));
    }
    vertexBase += static_cast<std::size_t>(list.VtxBuffer.Size);
    indexBase += static_cast<std::size_t>(list.IdxBuffer.Size);
  }
}

}  // namespace skydrop::render
