#include "skydrop/render/spray/spray_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "render/frame/visibility.h"
#include "render/spray/burst_clouds.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/cloud_transmittance.h"
#include "skydrop/render/frame/light_shares.h"

namespace skydrop::render {
namespace {

constexpr GLuint kDepthUnit = 0;  // as in shaders/spray/seen.glsl
// The number of particles that the looks of a burst were found with.
constexpr double kUsualParticles = 512;
// A cloud whose radius is so many pixels has all its particles, a smaller one as many fewer, to a tenth.
constexpr double kFullPixels = 60, kLeastShare = 0.1;

struct DrawnCloud {
  BurstCloud cloud;
  double distanceM = 0;
  int particles = 0;
};

bool isSeen(const FrameInput& frame, const BurstCloud& cloud, double reachM) {
  return glm::distance(frame.view.position, cloud.place) < reachM + cloud.reachM &&
         isPotentiallyVisible(frame.view, cloud.place, cloud.reachM);
}

// Newest bursts first.
template <class Use>
void forEachSeen(const FrameInput& frame, const DustAndSpraySettings& settings, const Use& use) {
  if (!frame.game) return;
  for (auto burst = frame.game->bursts.rbegin(); burst != frame.game->bursts.rend(); ++burst) {
    for (const BurstCloud& cloud : cloudsOf(*burst, frame.simulatedSeconds, settings.amount))
      if (isSeen(frame, cloud, settings.reachM)) use(cloud);
  }
}

int particlesOf(const BurstCloud& cloud, const DustAndSpraySettings& settings, double pixels) {
  const double share = cloud.share * std::clamp(pixels / kFullPixels, kLeastShare, 1.0);
  return std::max(static_cast<int>(std::lround(static_cast<double>(settings.particles) * share)), 1);
}

// Far first. Of the newest bursts those that there is room for.
std::vector<DrawnCloud> drawnClouds(const FrameInput& frame, const DustAndSpraySettings& settings) {
  std::vector<DrawnCloud> drawn;
  std::int64_t left = SprayPass::kMostFull * settings.particles;
  forEachSeen(frame, settings, [&](const BurstCloud& cloud) {
    const double distance = glm::distance(frame.view.position, cloud.place);
    const double pixels = cloud.reachM / std::max(distance, 0.1) / frame.view.pixelAngleRad();
    const int particles = particlesOf(cloud, settings, pixels);
    left -= particles;
    if (left >= 0) drawn.push_back({cloud, distance, particles});
  });
  std::ranges::stable_sort(drawn, std::ranges::greater(), &DrawnCloud::distanceM);
  return drawn;
}

// Drawn by nobody's eyes, so that its programs are there: of each look one.
std::vector<DrawnCloud> warmingClouds(const View& view) {
  BurstCloud dust;
  dust.place = view.position + view.forward() * 20.0;
  dust.lifeSeconds = 2, dust.age = 0.5, dust.sourceM = 1;
  BurstCloud drops = dust;
  drops.look = BurstCloud::Look::drops;
  return {{dust, 20, 4}, {drops, 20, 4}};
}

void setCloud(gl::Shader& shader, const View& view, const DrawnCloud& drawn, const LightShares& light) {
  const BurstCloud& c = drawn.cloud;
  const auto f = [](double value) { return static_cast<float>(value); };
  const auto with = [&](const glm::dvec3& v, double w) { return glm::vec4(glm::vec3(v), f(w)); };
  // As much cover in all as the usual number: tufts are larger, puffs are larger and denser, so that what
  // they fill grows with the cube root of their number alone.
  const double fewer = kUsualParticles * c.share / drawn.particles;
  const bool isDust = c.look == BurstCloud::Look::dust;
  const double larger = isDust ? std::cbrt(fewer) : std::sqrt(fewer);
  const double opacity = isDust ? 1 - std::pow(1 - std::min(c.opacity, 0.95), std::cbrt(fewer)) : c.opacity;
  shader.setVec4("burstPlace", with(c.place - view.position, c.age));
  shader.setVec4("burstTimes", {f(c.emitSeconds), f(c.lifeSeconds), f(c.drag), f(c.fall)});
  shader.setVec4("burstThrow", {f(c.outMps), f(c.upMps), f(c.randomMps), f(c.sourceM)});
  shader.setVec4("burstCarried", with(c.carried, c.sideways));
  shader.setVec4("burstWind", with(c.wind, 0));
  shader.setVec4("burstSize", {f(c.fromM * larger), f(c.toM * larger), f(opacity), f(c.stretch)});
  shader.setVec4("burstUp", with(c.up, 0));
  shader.setVec4("burstAlbedo", with(c.albedo, 0));
  shader.setVec4("burstShares", {f(light.sun), f(light.sky), f(light.diffuseSun), 0});
  shader.setIvec3("burstSeed", {static_cast<int>(c.seed), 0, c.sinks ? 1 : 0});
}

}  // namespace

std::optional<std::string> SprayPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  if (settings_.amount <= 0) return "no amount";
  if (!frame.game || frame.game->bursts.empty()) return "nothing has touched land or water";
  bool any = false;
  forEachSeen(frame, settings_, [&](const BurstCloud&) { any = true; });
  if (!any) return "nothing that flies up is near and in view";
  return std::nullopt;
}

void SprayPass::draw(FrameContext& context) {
  const View& view = context.frame.view;
  const std::vector<std::string> defines = withCloudTransmittance(context.defines, context.resources);
  gl::Shader& dust = context.shaders.shader("spray/dust.vert", "spray/dust.frag", defines);
  gl::Shader& drops = context.shaders.shader("spray/drops.vert", "spray/drops.frag", defines);
  std::vector<DrawnCloud> clouds = drawnClouds(context.frame, settings_);
  if (clouds.empty() && context.frame.warmsUp) clouds = warmingClouds(view);
  context.sceneDepth.bind(kDepthUnit);
  const gl::Functions& gl = context.gl.api();
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  empty_.bind();
  particlesDrawn_ = 0;
  for (const DrawnCloud& drawn : clouds) {
    gl::Shader& shader = drawn.cloud.look == BurstCloud::Look::dust ? dust : drops;
    setCloud(shader, view, drawn, lightAt(context.resources, drawn.cloud.place + drawn.cloud.up));
    shader.use();
    context.gl.drawArrays(GL_TRIANGLES, 0, 6 * drawn.particles);
    particlesDrawn_ += static_cast<std::size_t>(drawn.particles);
  }
}

}  // namespace skydrop::render
