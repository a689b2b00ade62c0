#include "skydrop/lab/knobs.h"

namespace skydrop::lab {

void describe(core::SettingsVisitor& v, CloudKnobs& k) {
  v.group("view", k.view, "Where the eye is; the mouse turns it.");
  v.integer("steps", k.steps,
            {.unit = "1",
             .min = 0,
             .max = 1000,
             .help = "Samples along a ray: the cost grows with them.",
             .slider = core::Range{2, 128},
             .aliases = "N"});
  v.integer("lightSamples", k.lightSamples,
            {.unit = "1",
             .min = 0,
             .max = 1000,
             .help = "Samples from each step to the sun: the cost grows with the "
                     "product of both.",
             .slider = core::Range{0, 32},
             .aliases = "L"});
  v.number("extinction", k.extinction,
           {.unit = "1",
            .min = 0,
            .max = 1000,
            .help = "Of a density of 1, per edge of the cube: more is denser.",
            .logarithmic = true,
            .slider = core::Range{1, 200}});
  v.integer("cells", k.cells,
            {.unit = "1",
             .min = 1,
             .max = 32,
             .help = "Lattice cells of both noises to an edge.",
             .slider = core::Range{1, 8}});
  v.integer("seed", k.seed,
            {.unit = "1",
             .min = 0,
             .max = 1e6,
             .help = "Which of the clouds of these knobs.",
             .slider = core::Range{0, 100}});
  v.number("perlinThreshold", k.perlinThreshold,
           {.unit = "1",
            .min = -1,
            .max = 1,
            .help = "Perlin noise up to this is clear air.",
            .slider = core::Range{0, 0.8}});
  v.number("perlinMultiplier", k.perlinMultiplier,
           {.unit = "1",
            .min = 0,
            .max = 20,
            .help = "Weight of Perlin noise above its threshold.",
            .slider = core::Range{0, 8}});
  v.number("voronoiThreshold", k.voronoiThreshold,
           {.unit = "1",
            .min = -1,
            .max = 1,
            .help = "Voronoi noise (1 at its seeds) up to this is clear air.",
            .slider = core::Range{0, 0.9}});
  v.number("voronoiMultiplier", k.voronoiMultiplier,
           {.unit = "1",
            .min = 0,
            .max = 20,
            .help = "Weight of Voronoi noise above its threshold.",
            .slider = core::Range{0, 8}});
  v.number("sunAzimuthDegrees", k.sunAzimuthDegrees,
           {.unit = "deg",
            .min = -360,
            .max = 360,
            .help = "Where the light comes from, from the front to the right.",
            .slider = core::Range{-180, 180}});
  v.number(
      "sunElevationDegrees", k.sunElevationDegrees,
      {.unit = "deg", .min = -90, .max = 90, .help = "Height of the light.", .slider = core::Range{0, 90}});
  v.number("sunReach", k.sunReach,
           {.unit = "1",
            .min = 0,
            .max = 10,
            .help = "How far from the sun its forwarded light reaches on the screen.",
            .slider = core::Range{0.1, 2}});
  v.number("sunStrength", k.sunStrength,
           {.unit = "1",
            .min = 0,
            .max = 20,
            .help = "How slowly forwarded light falls off: more is brighter.",
            .slider = core::Range{0.1, 4}});
}

}  // namespace skydrop::lab
