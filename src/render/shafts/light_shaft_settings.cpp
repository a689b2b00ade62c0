#include "skydrop/render/shafts/light_shaft_settings.h"

namespace skydrop::render {

using core::Range;

int spacingOf(const LightShaftSettings& settings) { return 1 << static_cast<int>(settings.resolution); }

void describe(core::SettingsVisitor& visitor, LightShaftSettings& s) {
  visitor.choice("resolution", s.resolution, kLightShaftResolutionNames,
                 {.help = "Share of the picture's width and height that rays are marched in; between them "
                          "light is interpolated, but not across outlines.",
                  .aliases = "quality, god rays, crepuscular rays"});
  visitor.integer("steps", s.steps,
                  {.unit = "1",
                   .min = 2,
                   .max = 1024,
                   .help = "Places along each ray at which the sun is looked for. Neighbours look at others, "
                           "so few are enough.",
                   .logarithmic = true,
                   .slider = Range{4, 128},
                   .aliases = "samples, quality, god rays, crepuscular rays"});
  visitor.number(
      "distanceM", s.distanceM,
      {.unit = "m",
       .min = 1000,
       .max = 60'000,
       .help = "How far away shade still takes light from the air; it fades over the last quarter.",
       .logarithmic = true,
       .slider = Range{2000, 48'000},
       .aliases = "range, reach, god rays"});
}

}  // namespace skydrop::render
