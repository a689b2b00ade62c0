#include "bench/plain_march.h"

#include "support/paths.h"

namespace skydrop::bench {
namespace {

constexpr int kSteps = 128, kSunSamples = 6;
constexpr GLuint kTile = 8;  // pixels, as in the shader

GLuint tilesOf(int pixels) { return (static_cast<GLuint>(pixels) + kTile - 1) / kTile; }

}  // namespace

std::optional<std::string> PlainMarch::skipReason(const render::FrameInput&) const {
  if (!asked) return "not asked for";
  return std::nullopt;
}

void PlainMarch::draw(render::FrameContext& context) {
  const render::View& view = context.frame.view;
  if (!light_ || light_.width() != view.width || light_.height() != view.height)
    light_ = render::gl::Texture::make2D(context.gl, GL_RGBA16F, view.width, view.height, "plain march");
  std::vector<std::string> defines(context.defines.begin(), context.defines.end());
  defines.emplace_back("DETAIL");
  render::gl::ComputeShader& shader =
      context.shaders.computeShader(test::sourceDir() + "/tests/bench/shaders/plain_march.comp", defines);
  shader.use();
  shader.setInt("steps", kSteps);
  shader.setInt("sunSamples", kSunSamples);
  light_.bindImage(0, GL_WRITE_ONLY);
  shader.dispatch(tilesOf(view.width), tilesOf(view.height));
  context.gl.api().MemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
}

}  // namespace skydrop::bench
