#include "skydrop/noise/noise_settings.h"

namespace skydrop::noise {

using core::TakesEffect;

void describe(core::SettingsVisitor& v, NoiseSettings& s) {
  v.integer(
      "octaves", s.octaves,
      {.unit = "1",
       .min = 1,
       .max = 16,
       .help = "Octaves that are summed, each of twice the frequency of the one before: more adds finer "
               "detail, until it is finer than the texels.",
       .takesEffect = TakesEffect::rebuild,
       .slider = core::Range{1, 10},
       .aliases = "detail, fBm"});
  v.integer("frequency", s.frequency,
            {.unit = "1",
             .min = 1,
             .max = 512,
             .help = "Lattice cells to a period in the first octave: more makes smaller features.",
             .takesEffect = TakesEffect::rebuild,
             .logarithmic = true,
             .slider = core::Range{1, 64},
             .aliases = "scale, period, cells"});
  v.number("amplitude", s.amplitude,
           {.unit = "1",
            .min = 0,
            .max = 4,
            .help = "Weight of the first octave: more widens the range of values, until it is clipped.",
            .takesEffect = TakesEffect::rebuild,
            .slider = core::Range{0, 2},
            .aliases = "contrast, gain"});
  v.number("persistence", s.persistence,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Weight of an octave over that of the one before: more makes rougher noise.",
            .takesEffect = TakesEffect::rebuild,
            .aliases = "gain, roughness"});
  v.integer("seed", s.seed,
            {.unit = "1",
             .min = 0,
             .max = 4294967295.0,
             .help = "Which of the noises of these settings: any other number gives one without likeness.",
             .takesEffect = TakesEffect::rebuild,
             .slider = core::Range{0, 1000},
             .aliases = "random"});
}

void describe(core::SettingsVisitor& v, PostProcess& p) {
  v.number("cutoff", p.cutoff,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Noise up to this value is clear sky: more leaves fewer and smaller clouds.",
            .takesEffect = TakesEffect::rebuild,
            .slider = core::Range{0.2, 0.85},
            .aliases = "coverage, threshold"});
  v.number(
      "density", p.density,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "Share of light that a step of 1/255 above the cutoff lets through: less gives harder edges.",
       .takesEffect = TakesEffect::rebuild,
       .slider = core::Range{0.85, 0.995},
       .aliases = "exponent, sharpness"});
}

}  // namespace skydrop::noise
