#include "skydrop/render/shadows/cast_shadows.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <numbers>

#include "render/frame/visibility.h"
#include "skydrop/render/frame/sky_light.h"

namespace skydrop::render {
namespace {

constexpr double kFaintest = 0.01;     // share of the sun below which a shadow is not looked for
constexpr double kDeepestFloorM = 20;  // of the sea's floor that can be seen
constexpr double kLongestM = 10000;    // where a sun at the horizon would make a volume without end
constexpr double kMapMargin = 1.02;    // of the map over the caster: its border must stay empty

constexpr int kBoxStrip = 14;  // vertices around a box

glm::vec4 toVec4(const glm::dvec3& v, double w) { return {glm::vec3(v), static_cast<float>(w)}; }

}  // namespace

double CastShadow::mapHalfWidthM() const { return radiusM * kMapMargin; }

double CastShadow::halfWidthM(double behindM) const {
  const double pixelM = pixelAngleRad * glm::length(middle + down * behindM);
  return mapHalfWidthM() + std::max(behindM, 0.0) * std::tan(kSunRadiusRad) + pixelM;
}

CastShadow castShadow(const View& view, const glm::dvec3& middle, double radiusM, double areaM2,
                      const glm::dvec3& toSun) {
  CastShadow shadow;
  shadow.middle = middle - view.position;
  shadow.pixelAngleRad = view.pixelAngleRad();
  shadow.down = -toSun;
  // Any axis across the sun's way will do; this one never vanishes.
  const glm::dvec3 across = std::abs(toSun.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  shadow.right = glm::normalize(glm::cross(across, toSun));
  shadow.up = glm::cross(toSun, shadow.right);
  shadow.radiusM = radiusM;
  // Where the sun's disc hides behind the outline by so little.
  shadow.reachM = std::sqrt(areaM2 / (std::numbers::pi * kFaintest)) / std::tan(kSunRadiusRad);
  const double toFloor = (middle.y + kDeepestFloorM) / std::max(toSun.y, 1e-6);
  shadow.lengthM = std::clamp(toFloor, 2 * radiusM, std::min(shadow.reachM, kLongestM));
  return shadow;
}

bool isVolumePotentiallyVisible(const View& view, const CastShadow& shadow) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i) {
    const double behind = i & 1 ? shadow.lengthM : -shadow.radiusM;
    const double half = shadow.halfWidthM(behind);
    corners[i] = shadow.middle + shadow.down * behind + shadow.right * (i & 2 ? half : -half) +
                 shadow.up * (i & 4 ? half : -half);
  }
  return isPotentiallyVisible(view, corners);
}

glm::mat4 toShadowMap(const CastShadow& shadow) {
  const double scale = 1 / shadow.mapHalfWidthM();
  const glm::dmat3 axes =
      glm::transpose(glm::dmat3(shadow.right * scale, shadow.up * scale, shadow.down * (0.5 * scale)));
  glm::dmat4 result(axes);
  result[3] = glm::dvec4(glm::dvec3(0, 0, 0.5) - axes * shadow.middle, 1);
  return glm::mat4(result);
}

gl::FrameBuffer& CastShadows::add(gl::Context& context, const CastShadow& shadow) {
  assert(shadows_.size() < kMost);
  if (!empty_) empty_ = gl::VertexArray(context, "shadow volume");
  shadows_.push_back(shadow);
  if (maps_.size() < shadows_.size()) {
    Map map;
    map.texture = gl::Texture::make2D(context, GL_R8, kMapTexels, kMapTexels, "shadow map",
                                      gl::mipLevels(kMapTexels, kMapTexels));
    map.texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    map.texture.setWrap(GL_CLAMP_TO_BORDER);  // nothing is hidden beside the caster
    map.target = gl::FrameBuffer(context, &map.texture, nullptr, "shadow map");
    maps_.push_back(std::move(map));
  }
  return maps_[shadows_.size() - 1].target;
}

void CastShadows::finish() {
  for (std::size_t i = 0; i < shadows_.size(); ++i) maps_[i].texture.generateMipmaps();
}

void CastShadows::drawVolumes(gl::Shader& shader) const {
  for (std::size_t i = 0; i < shadows_.size(); ++i) {
    const CastShadow& shadow = shadows_[i];
    const auto end = [&](double behindM) {
      return toVec4(shadow.middle + shadow.down * behindM, shadow.halfWidthM(behindM));
    };
    shader.setVec4("casterMiddle", toVec4(shadow.middle, 1 / shadow.mapHalfWidthM()));
    shader.setVec4("casterRight", toVec4(shadow.right, shadow.radiusM));
    shader.setVec4("casterUp", toVec4(shadow.up, shadow.reachM));
    shader.setVec4("volumeBegin", end(-shadow.radiusM));
    shader.setVec4("volumeEnd", end(shadow.lengthM));
    maps_[i].texture.bind(kMapUnit);
    empty_.bind();
    empty_.context().drawArrays(GL_TRIANGLE_STRIP, 0, kBoxStrip);
  }
}

}  // namespace skydrop::render
