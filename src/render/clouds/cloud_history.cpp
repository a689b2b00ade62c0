#include "render/clouds/cloud_history.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace skydrop::render {
namespace {

constexpr GLuint kLightUnit = 9, kDistancesUnit = 10, kDepthUnit = 11,
                 kDoubtsUnit = 12;  // as in shaders/clouds/past.glsl

// A frame that comes later than this shows another picture, s.
constexpr double kLongestFrame = 0.25;
// An eye that moves by more is another camera, or was put there: m, and m in a second of simulated time.
constexpr double kLongestMoveM = 2, kFastestMps = 400;
constexpr double kWidestTurnRad = 0.5;
// The sun of 16 frames ago shines on clouds of this one: 1.2 degrees a second at 60 frames.
constexpr double kFastestSunRad = 3.5e-4;

CloudFrame frameOf(const FrameContext& context, const glm::dvec3& eyeInField,
                   const clouds::CloudSettings& settings) {
  return {.view = context.frame.view,
          .eyeInField = eyeInField,
          .seconds = context.frame.simulatedSeconds,
          .exposure = context.light.exposure,
          .toSun = context.light.direct.toSun,
          .atmosphere = context.settings.atmosphere,
          .settings = settings,
          .defines = {context.defines.begin(), context.defines.end()}};
}

}  // namespace

bool continues(const CloudFrame& past, const CloudFrame& now) {
  if (past.view.width != now.view.width || past.view.height != now.view.height) return false;
  if (past.settings != now.settings || past.atmosphere != now.atmosphere || past.defines != now.defines)
    return false;
  const double seconds = now.seconds - past.seconds;
  if (!(seconds >= 0 && seconds <= kLongestFrame)) return false;
  const double farthest = kLongestMoveM + kFastestMps * seconds;
  if (!(glm::distance(past.view.position, now.view.position) <= farthest)) return false;
  if (!(glm::distance(past.eyeInField, now.eyeInField) <= farthest)) return false;
  const double leastCosine = std::cos(kWidestTurnRad);
  if (glm::dot(past.view.forward(), now.view.forward()) < leastCosine ||
      glm::dot(past.view.up(), now.view.up()) < leastCosine)
    return false;
  return glm::distance(past.toSun, now.toSun) <= kFastestSunRad;
}

void CloudHistory::resize(gl::Context& context, const View& view, const clouds::CloudSettings& settings) {
  const int widest = widestSpacing(settings), side = tileSideOf(settings);
  const auto whole = [&](int pixels) {
    return static_cast<std::size_t>((raysAcross(pixels, widest, widest) * widest + 2 * side) / side * side);
  };
  const std::size_t pixels = whole(view.width) * whole(view.height);
  const std::size_t widestBytes =
      sizeof(ListGroups) + pixels / static_cast<std::size_t>(widest * widest) * sizeof(GLuint);
  const bool fits = depth_ && depth_.width() == view.width && depth_.height() == view.height &&
                    widestRays_.size() == widestBytes;
  if (fits) return;
  rays_ = {gl::Texture::make2D(context, GL_RGBA16F, view.width, view.height, "past cloud light"),
           gl::Texture::make2D(context, GL_R16F, view.width, view.height, "past cloud distances")};
  depth_ = gl::Texture::make2D(context, GL_DEPTH_COMPONENT32F, view.width, view.height, "past depth");
  for (gl::Texture* doubts : {&pastDoubts_, &doubts_})
    *doubts = gl::Texture::make2D(context, GL_R16F, view.width, view.height, "cloud doubts");
  widestRays_ = gl::Buffer(context, widestBytes, gl::Buffer::Use::write, "widest cloud rays");
  candidates_ = {};
  if (widest > 1) {
    candidates_ = gl::Buffer(context, sizeof(ListGroups) + pixels * sizeof(GLuint), gl::Buffer::Use::write,
                             "candidate cloud rays");
  }
}

void CloudHistory::begin(const FrameContext& context, const glm::dvec3& eyeInField,
                         const clouds::CloudSettings& settings, CloudRays& picture) {
  frame_ = frameOf(context, eyeInField, settings);
  const CloudFrame& now = frame_;
  isKnown_ = lastFrame_ && continues(*lastFrame_, now);
  resize(context.gl, now.view, settings);
  if (isKnown_) std::swap(rays_, picture);
  std::swap(pastDoubts_, doubts_);
  const float none = 0;
  context.gl.api().ClearTexImage(doubts_.id(), 0, GL_RED, GL_FLOAT, &none);
  round_ = settings.march.history == clouds::MarchHistory::quarter ? 4 : 16;
  turn_ = isKnown_ ? turn_ + 1 : 0;
  past_ = glm::vec4(0);
  eyeMoved_ = glm::vec3(0);
  if (!isKnown_) return;
  const View& view = lastFrame_->view;
  eyeMoved_ = glm::vec3(now.eyeInField - lastFrame_->eyeInField);
  toPast_ = viewProjection(view) * glm::translate(glm::mat4(1), eyeMoved_);
  past_ = glm::vec4(view.width, view.height, view.nearM, now.exposure / lastFrame_->exposure);
}

gl::ComputeShader& CloudHistory::prepare(FrameContext& context, const std::string& file,
                                         std::span<const std::string> defines, int round,
                                         const CloudRays& rays, const glm::ivec2& tileCount,
                                         gl::Buffer& list) {
  std::vector<std::string> all(defines.begin(), defines.end());
  all.push_back("ROUND " + std::to_string(round));
  list.writeValue(0, ListGroups{});
  list.bindBase(GL_SHADER_STORAGE_BUFFER, kRaysBinding);
  rays_.light.bind(kLightUnit);
  rays_.distances.bind(kDistancesUnit);
  depth_.bind(kDepthUnit);
  pastDoubts_.bind(kDoubtsUnit);
  doubts_.bindImage(2, GL_WRITE_ONLY);
  rays.light.bindImage(0, GL_WRITE_ONLY);
  rays.distances.bindImage(1, GL_READ_WRITE);
  gl::ComputeShader& shader = context.shaders.computeShader(file, all);
  shader.use();
  shader.setIvec2("tileCount", tileCount);
  shader.setMatrix("toPast", toPast_);
  shader.setVec3("eyeMoved", eyeMoved_);
  shader.setVec4("past", past_);
  shader.setUint("turn", turn_);
  return shader;
}

const gl::Buffer& CloudHistory::recallTiles(FrameContext& context, std::span<const std::string> defines,
                                            int spacing, const CloudRays& rays, const gl::Buffer& tiles,
                                            const glm::ivec2& tileCount) {
  prepare(context, "clouds/recall_tiles.comp", withGroups(defines, spacing), round_, rays, tileCount,
          widestRays_);
  tiles.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context.gl.dispatchIndirect(spacing == 4 ? kFourBytes : 0);
  context.gl.api().MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                                 GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  return widestRays_;
}

void CloudHistory::recallCandidates(FrameContext& context, std::span<const std::string> defines,
                                    const CloudRays& rays, const glm::ivec2& tileCount, gl::Buffer& list) {
  prepare(context, "clouds/recall_rays.comp", defines, round_, rays, tileCount, list);
  candidates_.bindBase(GL_SHADER_STORAGE_BUFFER, kCandidatesBinding);
  candidates_.bind(GL_DISPATCH_INDIRECT_BUFFER);
  context.gl.dispatchIndirect(0);
  context.gl.api().MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                                 GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void CloudHistory::keep(const FrameContext& context) {
  lastFrame_ = std::move(frame_);
  context.gl.api().CopyImageSubData(context.sceneDepth.id(), GL_TEXTURE_2D, 0, 0, 0, 0, depth_.id(),
                                    GL_TEXTURE_2D, 0, 0, 0, 0, depth_.width(), depth_.height(), 1);
}

}  // namespace skydrop::render
