#include "skydrop/elevation/elevation_settings.h"

namespace skydrop::elevation {

using core::TakesEffect;

void describe(core::SettingsVisitor& visitor, ElevationSettings& settings) {
  visitor.flag(
      "atCentre", settings.atCentre,
      {.help = "The flight begins over the middle of the first elevation file, instead of over the place.",
       .takesEffect = TakesEffect::restart,
       .aliases = "origin, terrain data, DEM"});
  visitor.number("latitude", settings.latitude,
                 {.unit = "deg",
                  .min = -90,
                  .max = 90,
                  .help = "Of the place that the world's origin lies at, north of the equator.",
                  .takesEffect = TakesEffect::restart});
  visitor.number("longitude", settings.longitude,
                 {.unit = "deg",
                  .min = -180,
                  .max = 180,
                  .help = "Of the place that the world's origin lies at, east of Greenwich.",
                  .takesEffect = TakesEffect::restart});
  visitor.number("blendM", settings.blendM,
                 {.unit = "m",
                  .min = 1,
                  .max = 1e5,
                  .help = "How far beyond the elevation data their land turns into the endless one.",
                  .takesEffect = TakesEffect::restart,
                  .logarithmic = true,
                  .slider = core::Range{200, 20000},
                  .aliases = "edge, transition"});
}

}  // namespace skydrop::elevation
