#include "skydrop/clouds/cloud_planes_settings.h"

#include <tuple>

namespace skydrop::clouds {

using core::Range, core::TakesEffect;

bool isSameNoise(const CloudPlaneSettings& a, const CloudPlaneSettings& b) {
  const auto noise = [](const CloudPlaneSettings& s) {
    return std::tie(s.octaves, s.frequency, s.amplitude, s.persistence, s.textureSide, s.seed);
  };
  return noise(a) == noise(b);
}

void describe(core::SettingsVisitor& visitor, CloudPlaneSettings& s) {
  visitor.number("cutoff", s.cutoff,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Noise up to this is clear sky; more leaves fewer and smaller clouds, 1 none.",
                  .slider = Range{0.35, 0.85},
                  .aliases = "coverage, threshold, cover"});
  visitor.number("density", s.density,
                 {.unit = "1",
                  .min = 0.8,
                  .max = 0.999,
                  .help = "Share of light that each step of noise above the cutoff lets through; less makes "
                          "clouds opaque with harder edges.",
                  .slider = Range{0.9, 0.995},
                  .aliases = "exponent, opacity, sharpness"});
  visitor.number("height", s.height,
                 {.unit = "m",
                  .min = 100,
                  .max = 12000,
                  .help = "Of the layer above the sea; lower layers drift faster.",
                  .slider = Range{500, 6000},
                  .aliases = "altitude, cloud base"});
  visitor.number("period", s.period,
                 {.unit = "m",
                  .min = 500,
                  .max = 40000,
                  .help = "Across one copy of the texture; more makes bigger clouds.",
                  .logarithmic = true,
                  .slider = Range{3000, 20000},
                  .aliases = "scale, size, tile"});
  visitor.integer("octaves", s.octaves,
                  {.unit = "1",
                   .min = 1,
                   .max = 10,
                   .help = "Of the noise; more makes finer edges, down to the texels.",
                   .takesEffect = TakesEffect::rebuild,
                   .aliases = "noise, detail"});
  visitor.integer("frequency", s.frequency,
                  {.unit = "1",
                   .min = 1,
                   .max = 32,
                   .help = "Clouds across one copy of the texture; more makes smaller ones.",
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
                   .min = 64,
                   .max = 2048,
                   .help = "Texels along a side of the texture; more is sharper overhead and takes longer to "
                           "make.",
                   .takesEffect = TakesEffect::rebuild,
                   .powersOfTwo = true,
                   .slider = Range{128, 2048},
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

void describe(core::SettingsVisitor& visitor, CloudPlanesSettings& s) {
  visitor.integer("count", s.count,
                  {.unit = "1",
                   .min = 0,
                   .max = static_cast<double>(kCloudPlanes),
                   .help = "Layers that are drawn, from the first on; 0 for a clear sky.",
                   .aliases = "number of layers"});
  visitor.number(
      "variation", s.variation,
      {.unit = "1",
       .min = 0,
       .max = 2,
       .help = "How much cover changes over tens of kilometres; 0 is the same everywhere and shows "
               "the texture repeat.",
       .slider = Range{0, 1.5},
       .aliases = "weather, coverage, tiling"});
  visitor.number("detail", s.detail,
                 {.unit = "1",
                  .min = 0,
                  .max = 1,
                  .help = "Share of a finer copy of the noise; more frays edges, 0 leaves them smooth.",
                  .slider = Range{0, 0.6},
                  .aliases = "erosion, edges, ragged"});
  visitor.number("selfShadow", s.selfShadow,
                 {.unit = "1",
                  .min = 0,
                  .max = 8,
                  .help = "How dark clouds make themselves; 0 is evenly white, more darkens thick bases.",
                  .slider = Range{0, 6},
                  .aliases = "shading, lighting, darkness"});
  visitor.number("radiusM", s.radiusM,
                 {.unit = "m",
                  .min = 5000,
                  .max = 200000,
                  .help = "From the eye to where layers have faded.",
                  .logarithmic = true,
                  .slider = Range{20000, 120000},
                  .aliases = "distance, rim"});
  describeResolution(visitor, s.resolution);
  visitor.group("layers", s.layers, "A layer: what it is made of, and where it is.");
}

}  // namespace skydrop::clouds
