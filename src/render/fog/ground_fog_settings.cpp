#include "skydrop/render/fog/ground_fog_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, GroundFogSettings& s) {
  visitor.number("density", s.density,
                 {.unit = "1/m",
                  .min = 0,
                  .max = 0.2,
                  .help = "Extinction in the fog: one sees 3.9 divided by it in metres; 0 is no fog.",
                  .logarithmic = true,
                  .slider = Range{0.0005, 0.05},
                  .aliases = "visibility, thickness, extinction, mist"});
  visitor.number("baseM", s.baseM,
                 {.unit = "m",
                  .min = -500,
                  .max = 5000,
                  .help = "Height above the sea up to which the fog is evenly dense; more fills valleys.",
                  .slider = Range{0, 1000},
                  .aliases = "altitude, top, height, valley"});
  visitor.number("scaleHeightM", s.scaleHeightM,
                 {.unit = "m",
                  .min = 5,
                  .max = 2000,
                  .help = "Height over which the fog thins to 37 % above its base; less makes a flat top.",
                  .logarithmic = true,
                  .slider = Range{10, 400},
                  .aliases = "falloff, softness, edge"});
}

}  // namespace skydrop::render
