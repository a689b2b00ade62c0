#include "skydrop/render/sky/halo_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, HaloSettings& s) {
  visitor.number("opticalDepth", s.opticalDepth,
                 {.unit = "1",
                  .min = 0,
                  .max = 3,
                  .help = "How many regular ice crystals lie overhead; 0 is none.",
                  .slider = Range{0, 0.5},
                  .aliases = "cirrus, ice, density, thickness"});
  visitor.number("plates", s.plates,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Share of the ice in plates that lie level: sun dogs beside the sun, less halo.",
                  .aliases = "sun dogs, parhelia, crystals, mock sun"});
  visitor.number("heightM", s.heightM,
                 {.unit = "m",
                  .min = 500,
                  .max = 15000,
                  .help = "Height of the ice above the sea; above it there is no halo.",
                  .slider = Range{1000, 12000},
                  .aliases = "altitude, cirrus"});
}

}  // namespace skydrop::render
