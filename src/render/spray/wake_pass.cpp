#include "skydrop/render/spray/wake_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "render/spray/burst_clouds.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/frame/light_shares.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0;     // as in shaders/spray/seen.glsl
constexpr double kFoamCellM = 0.55;  // as in shaders/spray/wake_look.glsl

// Those that are near and in view, newest first.
std::vector<BurstWake> seenWakes(const FrameInput& frame, const DustAndSpraySettings& settings) {
  std::vector<BurstWake> wakes;
  if (!frame.game || frame.view.position.y <= 0) return wakes;
  const auto& bursts = frame.game->bursts;
  for (auto burst = bursts.rbegin(); burst != bursts.rend() && wakes.size() < WakePass::kMostWakes; ++burst) {
    const std::optional<BurstWake> wake = wakeOf(*burst, frame.simulatedSeconds, settings.amount);
    if (!wake || glm::distance(frame.view.position, wake->place) >= settings.reachM + wake->reachM) continue;
    if (isPotentiallyVisible(frame.view, wake->place, wake->reachM)) wakes.push_back(*wake);
  }
  return wakes;
}

}  // namespace

std::optional<std::string> WakePass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.amount <= 0) return "no amount";
  const bool any = frame.game && std::ranges::any_of(frame.game->bursts, &game::SurfaceBurst::onWater);
  if (!any) return "nothing has touched water";
  if (seenWakes(frame, settings_).empty()) return "no wake is near and in view";
  return std::nullopt;
}

void WakePass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  gl::Shader& shader = context.shaders.shader("spray/wake.vert", "spray/wake.frag", defines);
  std::vector<BurstWake> wakes = seenWakes(context.frame, settings_);
  if (wakes.empty() && context.frame.warmsUp) wakes = {{.place = view.position + view.forward() * 20.0}};
  if (wakes.empty()) return;
  const auto f = [](double value) { return static_cast<float>(value); };
  std::array<glm::vec4, kMostWakes> places{}, looks{};
  glm::dvec2 least(1e30), most(-1e30);
  for (std::size_t i = 0; i < wakes.size(); ++i) {
    const BurstWake& wake = wakes[i];
    const glm::dvec2 at(wake.place.x - view.position.x, wake.place.z - view.position.z);
    places[i] = {f(at.x), f(at.y), f(wake.age), f(wake.radiusM)};
    looks[i] = {f(wake.slope), f(wake.foamM), f(wake.foam), f(wake.reachM)};
    least = glm::min(least, at - wake.reachM), most = glm::max(most, at + wake.reachM);
  }
  const glm::dvec3 middle = view.position + glm::dvec3(0.5 * (least.x + most.x), 0, 0.5 * (least.y + most.y));
  const LightShares light = lightAt(context.resources, {middle.x, 0, middle.z});
  shader.setVec4s("wakePlaces", std::span(places).first(wakes.size()));
  shader.setVec4s("wakeLooks", std::span(looks).first(wakes.size()));
  shader.setInt("wakeCount", static_cast<int>(wakes.size()));
  shader.setVec4("wakeBox", {f(least.x), f(least.y), f(most.x), f(most.y)});
  shader.setVec4("wakeShares", {f(light.sun), f(light.sky), f(light.diffuseSun), 0});
  // Exact however far out: a whole number of cells, wrapped, and the rest.
  const glm::dvec2 cells = glm::dvec2(view.position.x, view.position.z) / kFoamCellM;
  const glm::dvec2 whole = glm::floor(cells);
  const auto low = [](double number) {
    return static_cast<int>(static_cast<std::int64_t>(std::fmod(number, 16777216.0)));
  };
  shader.setIvec2("wakeCell", {low(whole.x), low(whole.y)});
  shader.setVec2("wakeInside", glm::vec2(cells - whole));
  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_SRC1_COLOR);
  shader.use();
  empty_.bind();
  context.gl.drawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace skydrop::render
