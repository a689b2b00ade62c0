#include "skydrop/render/frame/frame_features.h"

namespace skydrop::render {

std::vector<std::string> definesOf(const FrameFeatures& features) {
  std::vector<std::string> defines;
  if (features.haze) defines.emplace_back("HAZE");
  if (features.overcast) defines.emplace_back("OVERCAST");
  return defines;
}

}  // namespace skydrop::render
