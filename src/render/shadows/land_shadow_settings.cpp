#include "skydrop/render/shadows/land_shadow_settings.h"

namespace skydrop::render {

terrain::ShadeLayout shadeLayout(const LandShadowSettings& settings) {
  switch (settings.detail) {
    case LandShadowDetail::coarse:
      return {3, 256};
    case LandShadowDetail::medium:
      return {2, 512};
    case LandShadowDetail::fine:
      break;
  }
  return {1, 1024};
}

void describe(core::SettingsVisitor& visitor, LandShadowSettings& s) {
  visitor.choice(
      "detail", s.detail, kLandShadowDetailNames,
      {.help = "How finely the shadows of mountains are outlined near the eye: 32, 16 or 8 m. Finer ones "
               "take longer to work out when the sun or the eye moves, and more memory.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "shadow resolution, quality, texels, ridges, relief"});
}

}  // namespace skydrop::render
