#include "skydrop/render/places/places_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, PlacesViewSettings& s) {
  visitor.number("houseM", s.houseM,
                 {.unit = "m",
                  .min = 0,
                  .max = 3800,
                  .help = "How far away houses are drawn.",
                  .slider = Range{300, 2600},
                  .aliases = "villages, buildings, view distance"});
  visitor.number("hedgeM", s.hedgeM,
                 {.unit = "m",
                  .min = 0,
                  .max = 2000,
                  .help = "How far away hedges stand; beyond, they are painted on the land.",
                  .slider = Range{100, 1000},
                  .aliases = "villages, fields, bushes, view distance"});
  visitor.number("windows", s.windows,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Share of the windows that are lit in the evening.",
                  .aliases = "villages, houses, night, lights"});
  visitor.number("light", s.light,
                 {.unit = "1",
                  .min = 0,
                  .max = 5,
                  .help = "How bright lit windows are.",
                  .slider = Range{0.1, 3},
                  .aliases = "villages, houses, night, lights"});
}

}  // namespace skydrop::render
