#include "skydrop/render/precipitation/precipitation_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, PrecipitationSettings& s) {
  visitor.number("drops", s.drops,
                 {.unit = "1",
                  .min = 0,
                  .max = 12000,
                  .help = "Most drops or flakes around the eye; each stands for those that are left out.",
                  .slider = Range{200, 8000},
                  .aliases = "rain, snow, particles, streaks, density"});
  visitor.number("rangeM", s.rangeM,
                 {.unit = "m",
                  .min = 4,
                  .max = 60,
                  .help = "How far away single drops are drawn; beyond, rain is a veil.",
                  .slider = Range{8, 50},
                  .aliases = "rain, snow, distance"});
  visitor.number("shutterS", s.shutterS,
                 {.unit = "s",
                  .min = 0.001,
                  .max = 0.1,
                  .help = "How long the shutter is open: streaks are as long as drops pass by in it.",
                  .logarithmic = true,
                  .aliases = "rain, streak, length, motion blur"});
  visitor.number("splashes", s.splashes,
                 {.unit = "1",
                  .min = 0,
                  .max = 4000,
                  .help = "Most splashes of rain on water near the eye.",
                  .aliases = "rain, rings, sea, drops"});
  visitor.number("veilColumns", s.veilColumns,
                 {.unit = "1",
                  .min = 8,
                  .max = 320,
                  .help = "Columns of the grid in which rain far away is worked out.",
                  .slider = Range{8, 160},
                  .aliases = "rain, shafts, curtains, resolution"});
  visitor.number("veilSteps", s.veilSteps,
                 {.unit = "1",
                  .min = 4,
                  .max = 384,
                  .help = "Steps of a ray through rain far away.",
                  .slider = Range{4, 64},
                  .aliases = "rain, shafts, curtains, march"});
  visitor.number("veilRangeM", s.veilRangeM,
                 {.unit = "m",
                  .min = 2000,
                  .max = 60000,
                  .help = "How far away rain is still seen.",
                  .slider = Range{5000, 50000},
                  .aliases = "rain, shafts, curtains, distance"});
  visitor.flag("wetGround", s.wetGround,
               {.help = "Rain darkens the land and leaves puddles; snow whitens it.",
                .aliases = "rain, snow, puddles, wet"});
}

}  // namespace skydrop::render
