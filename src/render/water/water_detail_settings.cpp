#include "skydrop/render/water/water_detail_settings.h"

#include <algorithm>

namespace skydrop::render {

using core::Range;

int spacingOf(const WaterDetailSettings& settings) {
  return 1 << (3 - std::max(static_cast<int>(settings.reflection), 1));
}

void describe(core::SettingsVisitor& visitor, WaterDetailSettings& s) {
  visitor.integer("wavesPerOctave", s.wavesPerOctave,
                  {.unit = "1",
                   .min = 2,
                   .max = 8,
                   .help = "From so many directions waves of one length come; about half of them with the "
                           "wind.",
                   .aliases = "water, sea, waves, quality"});
  visitor.number("shortestM", s.shortestM,
                 {.unit = "m",
                  .min = 0.04,
                  .max = 8,
                  .help = "Length of the shortest waves that are drawn; shorter ones only roughen the sea.",
                  .logarithmic = true,
                  .slider = Range{0.1, 2},
                  .aliases = "water, sea, ripples, quality"});
  visitor.number("foam", s.foam,
                 {.unit = "1",
                  .min = 0,
                  .max = 3,
                  .help = "Whitecaps and surf: 1 is what the wind makes.",
                  .aliases = "water, sea, whitecaps, surf, spray"});
  visitor.number("turbidity", s.turbidity,
                 {.unit = "1",
                  .min = 0,
                  .max = 20,
                  .help = "Matter in the water: 0 is pure, 1 clear coastal water.",
                  .slider = Range{0, 5},
                  .aliases = "water, sea, murk, clarity"});
  visitor.number("caustics", s.caustics,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "How strongly waves gather light on shallow ground.",
                  .aliases = "water, sea, ground"});
  visitor.choice("reflection", s.reflection, kWaterReflectionNames,
                 {.help = "Share of the picture's width and height in which water mirrors land, trees and "
                          "aircraft; off: it mirrors the sky alone.",
                  .aliases = "water, mirror, screen space, quality"});
  visitor.choice(
      "mirror", s.mirror, kWaterMirrorNames,
      {.help = "Where water finds what it mirrors: in the picture, or in one of its own that is drawn "
               "from below, which also has undersides and what is out of the picture, and costs as "
               "much as land and trees once more in a picture of that size.",
       .aliases = "water, reflection, planar, screen space, quality"});
  visitor.number(
      "mirrorMargin", s.mirrorMargin,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "How far a picture of the water's own reaches beyond the picture on each side, as a "
               "share of it: waves mirror what is there.",
       .aliases = "water, mirror, reflection, planar, quality"});
  visitor.integer("reflectionSteps", s.reflectionSteps,
                  {.unit = "1",
                   .min = 4,
                   .max = 512,
                   .help = "Places along each mirrored ray at which something is looked for.",
                   .logarithmic = true,
                   .slider = Range{8, 128},
                   .aliases = "water, mirror, samples, quality"});
  visitor.integer("reflectionRays", s.reflectionRays,
                  {.unit = "1",
                   .min = 1,
                   .max = 16,
                   .help = "Mirrored rays of a pixel, by slopes of waves that are too small for it.",
                   .slider = Range{1, 8},
                   .aliases = "water, mirror, samples, quality, roughness"});
  visitor.number("reflectionM", s.reflectionM,
                 {.unit = "m",
                  .min = 10,
                  .max = 20'000,
                  .help = "How far mirrored rays look, and up to which height of the eye.",
                  .logarithmic = true,
                  .slider = Range{100, 6000},
                  .aliases = "water, mirror, range"});
}

}  // namespace skydrop::render
