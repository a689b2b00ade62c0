#include "skydrop/render/sky/rainbow_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "render/sky/optics_table.h"
#include "skydrop/core/shared_precipitation.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/frame/light_shares.h"
#include "skydrop/weather/fall.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0, kTableUnit = 1;  // as in shaders/sky/rainbow.glsl
constexpr double kReachDegrees = 90;
constexpr double kLapsePerM = 0.0065;  // snow makes no rainbow

// What clouds and land leave of the sun where the rain of the primary bow is seen from, in the mean: at eight
// places around it, in the middle of what can be seen of the rain.
double lightOnBow(const FrameContext& context, const RainbowSettings& rain) {
  if (!context.resources.find<LightAtPlaces>()) return 1;
  constexpr int kPlaces = 8;
  const double radius = glm::radians(42.0);
  const double distance = rain.nearM + 0.5 * std::min(rain.farM - rain.nearM, 1 / rain.extinction);
  const glm::dvec3 axis = -context.frame.toSun;
  const glm::dvec3 u =
      glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
  const glm::dvec3 v = glm::cross(axis, u);
  double sum = 0;
  int count = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = glm::radians(360.0 / kPlaces) * i;
    const glm::dvec3 ray =
        axis * std::cos(radius) + (u * std::cos(angle) + v * std::sin(angle)) * std::sin(radius);
    const glm::dvec3 place = context.frame.view.position + ray * distance;
    if (place.y < 0 || place.y > rain.topM) continue;
    sum += lightAt(context.resources, place).sun;
    ++count;
  }
  return count > 0 ? sum / count : 1;
}

}  // namespace

RainbowSettings RainbowPass::rainOf(const FrameInput& frame) const {
  RainbowSettings rain = settings_;
  if (!frame.game || !frame.game->weather) return rain;
  const glm::dvec2 away = -glm::dvec2(frame.toSun.x, frame.toSun.z) * (0.5 * (rain.nearM + rain.farM));
  const weather::State there =
      frame.game->weather.at(glm::dvec2(frame.view.position.x, frame.view.position.z) + away);
  const weather::Layer* cloud = weather::feedingLayer(there);
  rain.extinction = cloud ? core::shared::f64::rainExtinction(weather::fallAt(there, 0).rain) : 0;
  if (cloud) rain.topM = std::min(cloud->baseM, std::max(there.temperatureC / kLapsePerM, 0.0));
  return rain;
}

RainbowPass::RainbowPass(gl::Context& context, const RainbowSettings& settings)
    : settings_(settings), triangle_(context), table_(opticsTable(context, "rainbow.dds", false)) {}

std::optional<std::string> RainbowPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  const RainbowSettings rain = rainOf(frame);
  if (rain.extinction <= 0 || rain.farM <= rain.nearM) return "no rain";
  if (isLightBelowHorizon(frame)) return "the light is below the horizon";
  if (isFartherThan(frame.view, -frame.toSun, kReachDegrees)) return "the rainbow is out of view";
  if (frame.view.position.y >= rain.topM && leastRise(frame.view) >= 0) return "the view is above the rain";
  return std::nullopt;
}

void RainbowPass::draw(FrameContext& context) {
  const std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  gl::Shader& shader = context.shaders.shader("fullscreen.vert", "sky/rainbow.frag", defines);
  const RainbowSettings rain = rainOf(context.frame);
  shader.setVec4("rain", glm::vec4(rain.extinction, rain.nearM, rain.farM, rain.topM));
  shader.setFloat("dropRadiusMm", static_cast<float>(settings_.dropRadiusMm));
  shader.setFloat("lightShare", context.frame.warmsUp ? 1 : static_cast<float>(lightOnBow(context, rain)));
  context.sceneDepth.bind(kDepthUnit);
  table_.bind(kTableUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  shader.use();
  triangle_.draw();
}

}  // namespace skydrop::render
