#include "skydrop/render/shadows/shadow_pass.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace skydrop::render {
namespace {

CastShadow shadowOf(const ShadowCaster& caster, const View& view, const glm::dvec3& toSun) {
  return castShadow(view, caster.middle, caster.radiusM, caster.areaM2, toSun);
}

}  // namespace

std::vector<ShadowCaster> ShadowPass::castersIn(const FrameInput& frame) const {
  std::vector<ShadowCaster> casters;
  for (const OwnedSource& owned : sources_) owned.source(frame, casters);
  return casters;
}

void ShadowPass::remove(std::string_view owner) {
  const auto isTheirs = [&](const OwnedSource& owned) { return owned.owner == owner; };
  if (std::erase_if(sources_, isTheirs) > 0) shadows_ = {};  // those that are left need fewer maps
}

std::optional<std::string> ShadowPass::skipReason(const FrameInput& frame) const {
  const std::vector<ShadowCaster> casters = castersIn(frame);
  if (casters.empty()) return "nothing that casts a shadow";
  if (frame.toSun.y <= 0) return "the sun is below the horizon";
  const auto falls = [&](const ShadowCaster& c) {
    return isVolumePotentiallyVisible(frame.view, shadowOf(c, frame.view, frame.toSun));
  };
  if (std::none_of(casters.begin(), casters.end(), falls)) return "no shadow falls into view";
  return std::nullopt;
}

void ShadowPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  std::vector<ShadowCaster> casters = castersIn(context.frame);
  std::erase_if(casters, [&](const ShadowCaster& c) {
    return !isVolumePotentiallyVisible(view, shadowOf(c, view, context.frame.toSun));
  });
  const auto distance = [&](const ShadowCaster& c) { return glm::length(c.middle - view.position); };
  std::stable_sort(casters.begin(), casters.end(),
                   [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (casters.size() > CastShadows::kMost) casters.resize(CastShadows::kMost);

  shadows_.clear();
  const gl::Functions& api = context.gl.api();
  api.Disable(GL_DEPTH_TEST);
  api.Enable(GL_CULL_FACE);  // of closed meshes one side is enough for the outline
  for (const ShadowCaster& caster : casters) {
    const CastShadow shadow = shadowOf(caster, view, context.frame.toSun);
    const glm::mat4 toMap = toShadowMap(shadow);
    gl::FrameBuffer& map = shadows_.add(context.gl, shadow);
    map.bind();
    gl::Shader& shader = context.shaders.shader("shadow/caster.vert", "shadow/caster.frag");
    caster.parts(view, [&](const Model& model, const glm::mat4& toEye, const ModelPose& pose) {
      model.drawOutline(shader, toMap * toEye, pose);
    });
    map.unBind();
  }
  shadows_.finish();
  context.resources.publish(shadows_);
}

}  // namespace skydrop::render
