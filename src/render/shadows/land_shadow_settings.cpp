#include "skydrop/render/shadows/land_shadow_settings.h"

namespace skydrop::render {

terrain::ShadeLayout shadeLayout(const LandShadowSettings& settings) {
  switch (settings.detail) {
    case LandShadowDetail::coarse:
      return {3, 256};
    case LandShadowDetail::medium:
      return {2, 512};
    case LandShadowDetail::fine:
      return {1, 1024};
    case LandShadowDetail::finest:
      break;
  }
  return {0, 2048};
}

void describe(core::SettingsVisitor& visitor, LandShadowSettings& s) {
  visitor.choice(
      "detail", s.detail, kLandShadowDetailNames,
      {.help = "How finely the shadows of mountains are outlined near the eye: 32, 16, 8 or 4 m. Each step "
               "takes four times the memory, and longer when the sun or the eye moves.",
       .aliases = "shadow resolution, quality, texels, ridges, relief"});
}

}  // namespace skydrop::render
