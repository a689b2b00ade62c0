#include "render/clouds/sheet_shade.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/shadows/land_shadow_map.h"

namespace skydrop::render {
namespace {

// While the sun goes down through these elevations (rad) the shade on sheets fades: on the flat earth of the
// shade everything below the summits would be dark at sunset, and a high sheet sees the sun for longer.
const double kWhole = 0.0175, kNone = -std::sin(kSunRadiusRad);

double shadeOf(const glm::dvec3& toSun) {
  const double t = std::clamp((toSun.y - kNone) / (kWhole - kNone), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

bool SheetShade::take(FrameContext& context, double heightM) {
  if (!context.frame.features.landShadows) {
    volume_ = {};
    return false;
  }
  const auto* map = context.resources.find<LandShadowMap>();
  if (!map || (map->shade() && map->shade()->topM() <= heightM)) return false;
  volume_.take(context.gl, *map);
  return true;
}

gl::Shader& SheetShade::shader(FrameContext& context, const std::string& vertex, const std::string& fragment,
                               std::span<const std::string> defines, bool shaded) {
  std::vector<std::string> withShade(defines.begin(), defines.end());
  withShade.emplace_back(LandShadowMap::kDefine);
  const auto variant = [&](bool isShaded) -> gl::Shader& {
    return context.shaders.shader(vertex, fragment,
                                  isShaded ? std::span<const std::string>(withShade) : defines);
  };
  if (context.frame.features.landShadows && context.frame.looksAhead()) variant(!shaded);
  gl::Shader& shader = variant(shaded);
  if (!shaded) return shader;
  const glm::dvec3& eye = context.frame.view.position;
  volume_.bind(shader, {eye.x, eye.z});
  shader.setFloat("landShade", static_cast<float>(shadeOf(context.light.direct.toSun)));
  return shader;
}

}  // namespace skydrop::render
