#include "skydrop/render/clouds/cloud_shadow_map.h"

namespace skydrop::render {

std::vector<std::string> CloudShadowMap::defines(bool hasSun) {
  if (hasSun) return {"SUN_SHADOW"};
  return {};
}

void CloudShadowMap::bind(gl::ShaderProgram& shader) const {
  shader.setVec2("shadowMapLayer", layer_);
  sky_.shares->bind(kSkyUnit);
  shader.setVec4("skySharePlace", sky_.place);
  if (!hasSun()) return;
  fine_.depths->bind(kFineUnit);
  coarse_.depths->bind(kCoarseUnit);
  shader.setVec4s("inFineShadowMap", fine_.rows);
  shader.setVec2("shadowRadii", glm::vec2(fine_.radiusM, coarse_.radiusM));
  shader.setVec4s("inCoarseShadowMap", coarse_.rows);
}

}  // namespace skydrop::render
