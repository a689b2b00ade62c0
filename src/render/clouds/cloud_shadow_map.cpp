#include "skydrop/render/clouds/cloud_shadow_map.h"

#include <span>

namespace skydrop::render {

std::vector<std::string> CloudShadowMap::defines(bool hasSun) const {
  std::vector<std::string> defines;
  if (hasSun) defines.emplace_back("SUN_SHADOW");
  if (layers_.count > 0) defines.push_back("CLOUD_LAYERS " + std::to_string(layers_.count));
  return defines;
}

void CloudShadowMap::bind(gl::ShaderProgram& shader, double eyeRiseM) const {
  const auto rise = static_cast<float>(eyeRiseM);
  const auto raised = [rise](std::array<glm::vec4, 2> rows) {
    for (glm::vec4& row : rows) row.w += row.y * rise;
    return rows;
  };
  sky_.shares->bind(kSkyUnit);
  if (layers_.count > 0) {
    shader.setVec4s("skySharePlaces",
                    std::span(layers_.skyPlaces).first(static_cast<std::size_t>(layers_.count)));
    shader.setVec4("shadowMapBases", layers_.bases - rise);
    shader.setVec2("overcastSky", layers_.overcast);
    shader.setVec4("shadowMapThicknesses", layers_.inverseThicknesses);
  } else {
    shader.setVec2("shadowMapLayer", layer_ - glm::vec2(rise, 0));
    shader.setVec4("skySharePlace", sky_.place);
  }
  if (!hasSun()) return;
  fine_.depths->bind(kFineUnit);
  coarse_.depths->bind(kCoarseUnit);
  shader.setVec4s("inFineShadowMap", raised(fine_.rows));
  shader.setVec2("shadowRadii", glm::vec2(fine_.radiusM, coarse_.radiusM));
  shader.setVec4s("inCoarseShadowMap", raised(coarse_.rows));
}

}  // namespace skydrop::render
