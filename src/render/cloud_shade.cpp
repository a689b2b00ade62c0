#include "skydrop/render/cloud_shade.h"

namespace skydrop::render {

void CloudShade::bind(gl::Shader& shader) const {
  fine_.depths->bind(kFineUnit);
  coarse_.depths->bind(kCoarseUnit);
  shader.setVec4s("inFineShade", fine_.rows);
  shader.setVec2("shadeLayer", layer_);
  shader.setVec2("shadeRadii", glm::vec2(fine_.radiusM, coarse_.radiusM));
  shader.setVec4s("inCoarseShade", coarse_.rows);
}

}  // namespace skydrop::render
