#include "skydrop/render/sky/stars_settings.h"

namespace skydrop::render {

using core::Range;

void describe(core::SettingsVisitor& visitor, StarsSettings& s) {
  visitor.number("faintestMagnitude", s.faintestMagnitude,
                 {.unit = "mag",
                  .min = -1.5,
                  .max = 6,
                  .help = "Stars that are fainter are left out; 6 is what the eye sees in a dark night.",
                  .slider = Range{1, 6},
                  .aliases = "stars, limiting magnitude, catalogue"});
  visitor.number("brightness", s.brightness,
                 {.unit = "1",
                  .min = 0,
                  .max = 8,
                  .help = "Times the light that stars send; 1 is what they have.",
                  .slider = Range{0, 4},
                  .aliases = "stars, intensity"});
  visitor.number("twinkle", s.twinkle,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Share of its light by which a star low in the sky flickers; 0 is a still sky.",
                  .aliases = "stars, scintillation, flicker"});
}

}  // namespace skydrop::render
