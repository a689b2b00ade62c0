#include "skydrop/clouds/cloud_dome_settings.h"

#include <tuple>

namespace skydrop::clouds {

using core::Range, core::TakesEffect;

bool isSameNoise(const CloudDomeSettings& a, const CloudDomeSettings& b) {
  const auto noise = [](const CloudDomeSettings& s) {
    return std::tie(s.octaves, s.frequency, s.amplitude, s.persistence, s.textureSide, s.seed);
  };
  return noise(a) == noise(b);
}

void describe(core::SettingsVisitor& visitor, CloudDomeSettings& s) {
  visitor.number("cutoff", s.cutoff,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Noise up to this is clear sky; more leaves fewer and smaller clouds, 1 none.",
                  .slider = Range{0.3, 0.85},
                  .aliases = "coverage, threshold, cover"});
  visitor.number("scale", s.scale,
                 {.unit = "1",
                  .min = 0.05,
                  .max = 4,
                  .help = "Of the noise on the dome; more makes smaller clouds.",
                  .logarithmic = true,
                  .slider = Range{0.1, 0.8},
                  .aliases = "size"});
  visitor.number("exponent", s.exponent,
                 {.unit = "1",
                  .min = 0.8,
                  .max = 0.999,
                  .help = "Share of light that each step of noise above the cutoff lets through; less makes "
                          "clouds opaque with harder edges.",
                  .slider = Range{0.9, 0.995},
                  .aliases = "density, opacity, sharpness"});
  visitor.number("bias", s.bias,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Factor of the opacity; less makes all clouds fainter, 0 draws none.",
                  .aliases = "opacity, strength"});
  visitor.number("speedX", s.speedX,
                 {.unit = "1/s",
                  .min = -0.1,
                  .max = 0.1,
                  .help = "Drift: copies of the noise that go past in a second.",
                  .slider = Range{-0.01, 0.01},
                  .aliases = "wind, drift"});
  visitor.number("speedY", s.speedY,
                 {.unit = "1/s",
                  .min = -0.1,
                  .max = 0.1,
                  .help = "Formation: how fast clouds form and dissolve, in copies of the noise a second.",
                  .slider = Range{-0.01, 0.01},
                  .aliases = "formation, evolution"});
  visitor.number(
      "flatness", s.flatness,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "0 wraps the noise around a hemisphere, 1 lays it on a level sheet that gets denser "
               "towards the horizon.",
       .aliases = "perspective, hemisphere, shape"});
  visitor.number("selfShadow", s.selfShadow,
                 {.unit = "1",
                  .min = 0,
                  .max = 8,
                  .help = "How dark clouds make themselves; 0 is evenly white, more darkens thick parts.",
                  .slider = Range{0, 6},
                  .aliases = "shading, lighting, darkness"});
  const auto colour = [&](std::string_view name, double& value) {
    visitor.number(name, value,
                   {.unit = "1",
                    .min = 0,
                    .max = 1,
                    .help = "Of the clouds' colour, linear; all three 1 is white.",
                    .aliases = "colour, color, cloud colour, tint"});
  };
  colour("red", s.red);
  colour("green", s.green);
  colour("blue", s.blue);
  describeResolution(visitor, s.resolution);
  visitor.integer("octaves", s.octaves,
                  {.unit = "1",
                   .min = 1,
                   .max = 8,
                   .help = "Of the noise; more makes finer edges, down to the texels.",
                   .takesEffect = TakesEffect::rebuild,
                   .slider = Range{1, 6},
                   .aliases = "noise, detail"});
  visitor.integer("frequency", s.frequency,
                  {.unit = "1",
                   .min = 1,
                   .max = 32,
                   .help = "Clouds across the volume; more makes smaller ones.",
                   .takesEffect = TakesEffect::rebuild,
                   .slider = Range{1, 21},
                   .aliases = "noise, size"});
  visitor.number("amplitude", s.amplitude,
                 {.unit = "1",
                  .min = 0.1,
                  .max = 2,
                  .help = "Of the first octave; more makes denser clouds with clearer gaps.",
                  .takesEffect = TakesEffect::rebuild,
                  .slider = Range{0.3, 1.3},
                  .aliases = "noise, contrast"});
  visitor.number("persistence", s.persistence,
                 {.unit = "1",
                  .min = 0.1,
                  .max = 0.9,
                  .help = "Amplitude of each octave as a share of the one before; more makes ragged clouds.",
                  .takesEffect = TakesEffect::rebuild,
                  .slider = Range{0.2, 0.75},
                  .aliases = "noise, roughness, gain"});
  visitor.integer("textureSide", s.textureSide,
                  {.unit = "1",
                   .min = 32,
                   .max = 256,
                   .help = "Texels along a side of the volume; more is sharper and takes longer to make.",
                   .takesEffect = TakesEffect::rebuild,
                   .powersOfTwo = true,
                   .slider = Range{64, 256},
                   .aliases = "resolution, texture size"});
  visitor.integer("seed", s.seed,
                  {.unit = "1",
                   .min = 0,
                   .max = 65535,
                   .help = "Of the noise; another seed is another sky of the same kind.",
                   .takesEffect = TakesEffect::rebuild,
                   .slider = Range{0, 99},
                   .aliases = "random"});
}

}  // namespace skydrop::clouds
