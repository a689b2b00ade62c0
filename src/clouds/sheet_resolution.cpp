#include "skydrop/clouds/sheet_resolution.h"

namespace skydrop::clouds {

void describeResolution(core::SettingsVisitor& visitor, SheetResolution& resolution) {
  visitor.choice("resolution", resolution, kSheetResolutionNames,
                 {.help = "Light is worked out for each pixel, for each 2 x 2 or for each 4 x 4; fewer are "
                          "softer and faster. Surfaces cut clouds at each pixel all the same.",
                  .takesEffect = core::TakesEffect::variant,
                  .aliases = "downsampling, upscaling"});
}

}  // namespace skydrop::clouds
