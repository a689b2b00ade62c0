#include "skydrop/render/sky/rainbow_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, RainbowSettings& s) {
  visitor.number("extinction", s.extinction,
                 {.unit = "1/m",
                  .min = 0,
                  .max = 0.01,
                  .help = "Of the rain: 0.0003 in 1 mm an hour, 0.0015 in 10; 0 is no rain.",
                  .logarithmic = true,
                  .slider = Range{1e-4, 0.005},
                  .aliases = "rain, density, visibility, shower"});
  visitor.number("dropRadiusMm", s.dropRadiusMm,
                 {.unit = "mm",
                  .min = 0.1,
                  .max = 1,
                  .help = "Radius of the drops: large ones make narrow vivid bows, drizzle wide pale ones.",
                  .logarithmic = true,
                  .aliases = "rain, size, drizzle"});
  visitor.number("nearM", s.nearM,
                 {.unit = "m",
                  .min = 0,
                  .max = 50000,
                  .help = "How far away the rain begins.",
                  .slider = Range{0, 4000},
                  .aliases = "rain, distance"});
  visitor.number("farM", s.farM,
                 {.unit = "m",
                  .min = 0,
                  .max = 50000,
                  .help = "How far away the rain ends; no rain if that is nearer than where it begins.",
                  .slider = Range{500, 10000},
                  .aliases = "rain, distance"});
  visitor.number("topM", s.topM,
                 {.unit = "m",
                  .min = 0,
                  .max = 10000,
                  .help = "Height above the sea up to which rain fills the air: that of the clouds.",
                  .slider = Range{0, 2500},
                  .aliases = "rain, altitude, cloud base"});
}

}  // namespace skydrop::render
