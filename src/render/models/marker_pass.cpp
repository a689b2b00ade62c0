#include "skydrop/render/models/marker_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "skydrop/core/shared.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/cloud_transmittance.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

// Linear sRGB. Little blue: the sea, the sky, snow and shadow have plenty.
constexpr glm::dvec3 kSignalOrange(1.0, 0.30, 0.01);
// Of a white sheet's radiance: brighter, and the tone map would bleach the orange on its way to white.
constexpr double kDaylightShare = 0.35;
// A lantern, kcd/m^2, which is turned down for eyes that have adapted to a darker night: it is shown at no
// more than this share of white.
constexpr double kLampRadiance = 1.5e-3, kMostLampShown = 0.5;
// A lamp shines through haze that hides paint: the beam is veiled by this share of the way to it.
constexpr double kBeamHazeShare = 0.5;

// Relative to the eye, metres.
struct Box {
  glm::dvec3 low, high;
};

struct Mark {
  glm::dvec3 foot{0};     // of the target, relative to the eye
  double beamRadius = 0;  // m
  bool tooFar = false;    // lower than a pixel
  Box ring, beam;
};

Mark markOf(const View& view, const game::TargetSnapshot& target) {
  Mark mark;
  mark.foot = target.position - view.position;
  // One radius for the whole beam: that of its nearest point.
  const glm::dvec3 nearest(mark.foot.x, std::clamp(0.0, mark.foot.y, mark.foot.y + shared::kBeamHeight),
                           mark.foot.z);
  const double distance = glm::length(nearest), pixelAngle = view.pixelAngleRad();
  mark.beamRadius = shared::beamRadius(distance, pixelAngle);
  mark.tooFar = shared::kBeamHeight < pixelAngle * distance;
  const glm::dvec3 aside(mark.beamRadius, 0, mark.beamRadius);
  mark.beam = {mark.foot - aside, mark.foot + aside + glm::dvec3(0, shared::kBeamHeight, 0)};
  const double side = target.radius + shared::kRingWidth / 2;
  const glm::dvec3 half(side, shared::kRingReach * target.radius, side);
  mark.ring = {mark.foot - half, mark.foot + half};
  return mark;
}

bool isPotentiallyVisible(const View& view, const Box& box) {
  std::array<glm::dvec3, 8> corners;
  for (unsigned i = 0; i < corners.size(); ++i) {
    corners[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                  i & 4 ? box.high.z : box.low.z};
  }
  return render::isPotentiallyVisible(view, corners);
}

// Once for a whole part, because haze hardly changes over 600 m.
glm::dvec3 throughAir(const FrameContext& context, const glm::dvec3& radiance, const glm::dvec3& relative) {
  if (!context.frame.features.haze) return radiance;
  return sky::applyAerialPerspective(context.light, radiance, context.frame.view.position.y, relative);
}

}  // namespace

glm::dvec3 signalRadiance(const SkyLight& light) {
  // A low sun leaves the land dark before the horizon, against which a beam is seen.
  const glm::dvec3 sheet =
      (light.direct.sun * std::max(light.direct.toSun.y, 0.0) + light.sky) / std::numbers::pi +
      sky::meanHorizonRadiance(light);
  const double white = glm::dot(sheet, glm::dvec3(0.2126, 0.7152, 0.0722));
  return kSignalOrange *
         (kDaylightShare * white + std::min(kLampRadiance, kMostLampShown / light.adaptation));
}

std::optional<std::string> MarkerPass::skipReason(const FrameInput& frame) const {
  if (!frame.game || !frame.game->target.present) return "no target";
  const Mark mark = markOf(frame.view, frame.game->target);
  if (mark.tooFar) return "target too far away";
  if (!isPotentiallyVisible(frame.view, mark.ring) && !isPotentiallyVisible(frame.view, mark.beam))
    return "target out of view";
  return std::nullopt;
}

void MarkerPass::draw(FrameContext& context) {
  const gl::Functions& gl = context.gl.api();
  const game::TargetSnapshot& target = context.frame.game->target;
  const Mark mark = markOf(context.frame.view, target);
  // The inner faces of a box cover each pixel that sees into it exactly once, also from inside.
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  context.sceneDepth.bind(0);
  empty_.bind();
  const glm::dvec3 signal = signalRadiance(context.light);
  const glm::dvec3 densest = mark.foot + glm::dvec3(0, shared::kBeamHeight / 3, 0);
  const std::vector<std::string> defines = withCloudTransmittance({}, context.resources);
  const auto drawPart = [&](const char* fragment, const Box& box, const glm::dvec3& radiance) {
    if (!isPotentiallyVisible(context.frame.view, box)) return;
    gl::Shader& shader = context.shaders.shader("models/box.vert", fragment, defines);
    shader.setVec3("boxLow", glm::vec3(box.low));
    shader.setVec3("boxHigh", glm::vec3(box.high));
    shader.setVec3("foot", glm::vec3(mark.foot));
    shader.setFloat("ringRadius", static_cast<float>(target.radius));
    shader.setFloat("beamRadiusNow", static_cast<float>(mark.beamRadius));
    shader.setVec3("light", glm::vec3(radiance * context.light.exposure));
    shader.use();
    context.gl.drawArrays(GL_TRIANGLE_STRIP, 0, 14);
  };
  drawPart("marker/ring.frag", mark.ring, throughAir(context, signal, mark.foot));
  drawPart("marker/beam.frag", mark.beam, throughAir(context, signal, densest * kBeamHazeShare));
}

}  // namespace skydrop::render
