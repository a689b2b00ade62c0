#include "skydrop/render/edges/edge_smoothing_pass.h"

#include <algorithm>
#include <cstddef>
#include <glm/vec2.hpp>
#include <string>

#include "render/frame/list_groups.h"
#include "skydrop/render/frame/land_ground.h"
#include "skydrop/render/frame/stage_layer.h"

namespace skydrop::render {
namespace {

// As in shaders/edges.
constexpr GLuint kListedWordsBinding = 0, kPixelsBinding = 1, kLightsBinding = 2;  // buffers
constexpr GLuint kSceneUnit = 0, kWordsUnit = 1, kLayerUnit = 2;                   // textures
constexpr GLuint kWordsImage = 0, kSceneImage = 0, kSharesImage = 1;               // images
constexpr int kTile = 32, kRowsOfBlock = 16, kWordsARow = 1024;
constexpr GLuint kBlocksOfGroup = 8;  // of mark.comp
constexpr GLuint kWordsOfGroup = 16;  // of layer.comp

glm::ivec2 tilesOf(int width, int height) {
  return {(width + kTile - 1) / kTile, (height + kTile - 1) / kTile};
}

GLuint groupsOf(int count, GLuint size) { return (static_cast<GLuint>(count) + size - 1) / size; }

}  // namespace

std::optional<std::string> EdgeSmoothingPass::skipReasonAfter(const FrameInput&,
                                                              const FrameResources& resources) const {
  if (!resources.find<LandGround>()) return "no land has been drawn";
  return std::nullopt;
}

void EdgeSmoothingPass::resize(gl::Context& context, int width, int height) {
  if (width == width_ && height == height_) return;
  words_ = {}, shares_ = {}, listedWords_ = {}, pixels_ = {}, lights_ = {};
  width_ = height_ = 0;
  const glm::ivec2 tiles = tilesOf(width, height);
  const int wordsOfPart = tiles.x * tiles.y * kTile, words = 3 * wordsOfPart;
  const std::size_t all = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  words_ = gl::Texture::make2D(context, GL_R32UI, kWordsARow, (words + kWordsARow - 1) / kWordsARow,
                               "steps of depth");
  shares_ = gl::Texture::make2D(context, GL_R32UI, width, height, "shares at edges");
  const GLuint none = 0;
  context.api().ClearTexImage(shares_.id(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
  listedWords_ =
      gl::Buffer(context, sizeof(ListGroups) + 2 * static_cast<std::size_t>(wordsOfPart) * sizeof(GLuint),
                 gl::Buffer::Use::write, "words with steps");
  pixels_ = gl::Buffer(context, sizeof(ListGroups) + all * sizeof(GLuint), gl::Buffer::Use::write,
                       "pixels at edges");
  lights_ = gl::Buffer(context, all * sizeof(GLuint), gl::Buffer::Use::fixed, "light at edges");
  width_ = width, height_ = height;
}

void EdgeSmoothingPass::draw(FrameContext& context) {
  resize(context.gl, context.frame.view.width, context.frame.view.height);
  listedWords_.writeValue(0, ListGroups{});
  pixels_.writeValue(0, ListGroups{});
  listedWords_.bindBase(GL_SHADER_STORAGE_BUFFER, kListedWordsBinding);
  pixels_.bindBase(GL_SHADER_STORAGE_BUFFER, kPixelsBinding);
  lights_.bindBase(GL_SHADER_STORAGE_BUFFER, kLightsBinding);
  words_.bind(kWordsUnit);
  mark(context);
  clearLayer(context);
  weigh(context);
  blend(context);
}

void EdgeSmoothingPass::mark(FrameContext& context) {
  const glm::ivec2 tiles = tilesOf(width_, height_);
  gl::ComputeShader& shader = context.shaders.computeShader("edges/mark.comp");
  shader.use();
  shader.setIvec2("tiles", tiles);
  shader.setFloat("leastStep", static_cast<float>(context.settings.leastEdge));
  context.sceneDepth.bind(kSceneUnit);
  words_.bindImage(kWordsImage, GL_WRITE_ONLY);
  shader.dispatch(groupsOf(tiles.y * (kTile / kRowsOfBlock), kBlocksOfGroup), static_cast<GLuint>(tiles.x));
  context.gl.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void EdgeSmoothingPass::clearLayer(FrameContext& context) {
  const auto* cover = context.resources.find<LayerCover>();
  if (!cover) return;
  gl::ComputeShader& shader = context.shaders.computeShader("edges/layer.comp");
  shader.use();
  shader.setIvec2("tiles", tilesOf(width_, height_));
  shader.setIvec2("layerLow", {cover->box.lowX, cover->box.lowY});
  shader.setIvec2("layerHigh", {cover->box.highX, cover->box.highY});
  context.sceneDepth.bind(kSceneUnit);
  cover->color->bind(kLayerUnit);
  context.gl.api().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  words_.bindImage(kWordsImage, GL_READ_WRITE);
  const int words = (cover->box.highX - 1) / kTile - std::max(cover->box.lowX - 1, 0) / kTile + 1;
  shader.dispatch(groupsOf(cover->box.height() + 1, kWordsOfGroup), static_cast<GLuint>(words));
  context.gl.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void EdgeSmoothingPass::weigh(FrameContext& context) {
  const gl::Functions& api = context.gl.api();
  const glm::ivec2 tiles = tilesOf(width_, height_);
  gl::ComputeShader& columns = context.shaders.computeShader("edges/columns.comp");
  columns.use();
  columns.setIvec2("tiles", tiles);
  words_.bindImage(kWordsImage, GL_WRITE_ONLY);
  columns.dispatch(static_cast<GLuint>(tiles.x), static_cast<GLuint>(tiles.y));
  api.MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);

  gl::ComputeShader& shader = context.shaders.computeShader("edges/weigh.comp");
  shader.use();
  shader.setIvec2("tiles", tiles);
  shares_.bindImage(kSharesImage, GL_READ_WRITE);
  listedWords_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context.gl.dispatchIndirect(0);
  api.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void EdgeSmoothingPass::blend(FrameContext& context) {
  const gl::Functions& api = context.gl.api();
  gl::ComputeShader& shader = context.shaders.computeShader("edges/blend.comp");
  shader.use();
  context.sceneColor.bind(kSceneUnit);
  shares_.bindImage(kSharesImage, GL_READ_WRITE);
  pixels_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context.gl.dispatchIndirect(0);
  api.MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);

  gl::ComputeShader& write = context.shaders.computeShader("edges/write.comp");
  write.use();
  shares_.bindImage(kSharesImage, GL_READ_WRITE);
  context.sceneColor.bindImage(kSceneImage, GL_WRITE_ONLY);
  context.gl.dispatchIndirect(0);
  api.MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace skydrop::render
