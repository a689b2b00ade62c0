#include "skydrop/render/spray/dust_and_spray_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, DustAndSpraySettings& s) {
  visitor.number("amount", s.amount,
                 {.unit = "1",
                  .min = 0,
                  .max = 3,
                  .help = "How much dust and water flies up; 0: nothing, and no rings or wakes.",
                  .slider = Range{0, 2},
                  .aliases = "splash, smoke, wake, particles"});
  visitor.integer("particles", s.particles,
                  {.unit = "1",
                   .min = 16,
                   .max = 4096,
                   .help = "Particles of a full burst; fewer are larger or denser.",
                   .logarithmic = true,
                   .slider = Range{32, 1024},
                   .aliases = "dust, splash, smoke, quality"});
  visitor.number("reachM", s.reachM,
                 {.unit = "m",
                  .min = 0,
                  .max = 10000,
                  .help = "How far away dust and spray are drawn.",
                  .slider = Range{100, 2500},
                  .aliases = "view distance, splash, smoke"});
}

}  // namespace skydrop::render
