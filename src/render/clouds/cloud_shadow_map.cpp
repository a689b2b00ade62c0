#include "skydrop/render/clouds/cloud_shadow_map.h"

namespace skydrop::render {

void CloudShadowMap::bind(gl::Shader& shader) const {
  fine_.depths->bind(kFineUnit);
  coarse_.depths->bind(kCoarseUnit);
  shader.setVec4s("inFineShadowMap", fine_.rows);
  shader.setVec2("shadowMapLayer", layer_);
  shader.setVec2("shadowRadii", glm::vec2(fine_.radiusM, coarse_.radiusM));
  shader.setVec4s("inCoarseShadowMap", coarse_.rows);
}

}  // namespace skydrop::render
