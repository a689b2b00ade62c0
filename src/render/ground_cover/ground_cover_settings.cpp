#include "skydrop/render/ground_cover/ground_cover_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, GroundCoverSettings& s) {
  visitor.number("reachM", s.reachM,
                 {.unit = "m",
                  .min = 0,
                  .max = 300,
                  .help = "How far away grass, flowers, stones and reeds stand.",
                  .slider = Range{20, 160},
                  .aliases = "meadow, plants, rocks, view distance"});
  visitor.number("density", s.density,
                 {.unit = "1",
                  .min = 0,
                  .max = 64,
                  .help = "How many tufts, flowers, stones and reeds are in view; 0: none.",
                  .slider = Range{0, 2},
                  .aliases = "meadow, plants, rocks, quality"});
  visitor.number("sway", s.sway,
                 {.unit = "1",
                  .min = 0,
                  .max = 3,
                  .help = "How much grass and reeds bend in the wind.",
                  .aliases = "meadow, plants, wind, bend"});
}

}  // namespace skydrop::render
