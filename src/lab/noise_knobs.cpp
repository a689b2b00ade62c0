#include "skydrop/lab/knobs.h"

namespace skydrop::lab {
namespace {

using core::SettingsVisitor;

void describeSeed(SettingsVisitor& v, std::int64_t& seed) {
  v.integer("seed", seed,
            {.unit = "1",
             .min = 0,
             .max = 1e6,
             .help = "Which of the noises of these knobs.",
             .slider = core::Range{0, 100}});
}

void describeCells(SettingsVisitor& v, std::int64_t& cells, double most) {
  v.integer("cells", cells,
            {.unit = "1",
             .min = 1,
             .max = most,
             .help = "Lattice cells to a period: more makes smaller features.",
             .slider = core::Range{1, 32},
             .aliases = "frequency"});
}

}  // namespace

void describe(SettingsVisitor& v, RandomKnobs& k) {
  v.number("firstScale", k.firstScale,
           {.unit = "1",
            .min = 0,
            .max = 1e6,
            .help = "What the sine of the upper plot is stretched by.",
            .logarithmic = true,
            .slider = core::Range{0.5, 100000}});
  v.number("secondScale", k.secondScale,
           {.unit = "1",
            .min = 0,
            .max = 1e6,
            .help = "What the sine of the lower plot is stretched by.",
            .logarithmic = true,
            .slider = core::Range{0.5, 100000}});
  v.number("from", k.from,
           {.unit = "1",
            .min = -1e7,
            .max = 1e7,
            .help = "Where the plots begin: far away the sine is coarse.",
            .slider = core::Range{-100, 100}});
  v.number("width", k.width,
           {.unit = "1",
            .min = 1e-3,
            .max = 1e5,
            .help = "What the plots span.",
            .logarithmic = true,
            .slider = core::Range{0.01, 1000}});
  v.number("away", k.away,
           {.unit = "1",
            .min = 0,
            .max = 1e7,
            .help = "How far from the origin the second and fourth field are, in "
                    "cells.",
            .slider = core::Range{0, 4e6}});
  v.number("cells", k.cells,
           {.unit = "1",
            .min = 1,
            .max = 1000,
            .help = "Cells to the height of a field.",
            .slider = core::Range{8, 180}});
  v.number("slice", k.slice,
           {.unit = "1",
            .min = 0,
            .max = 1000,
            .help = "Which slice of space the lower fields show.",
            .slider = core::Range{0, 20}});
}

void describe(SettingsVisitor& v, PerlinKnobs& k) {
  describeCells(v, k.cells, 256);
  describeSeed(v, k.seed);
  v.number("pointX", k.pointX,
           {.unit = "1", .min = 0, .max = 1, .help = "Place in the cell, from left to right."});
  v.number("pointY", k.pointY, {.unit = "1", .min = 0, .max = 1, .help = "Place in the cell, upwards."});
  v.number("slice", k.slice,
           {.unit = "1", .min = 0, .max = 0.999, .help = "Height of the first slice, in periods."});
}

void describe(SettingsVisitor& v, VoronoiKnobs& k) {
  describeCells(v, k.cells, 256);
  describeSeed(v, k.seed);
  v.integer("period", k.period,
            {.unit = "1",
             .min = 1,
             .max = 1000,
             .help = "Cells after which the tiled noise repeats.",
             .slider = core::Range{1, 12}});
}

void describe(SettingsVisitor& v, FractalKnobs& k) {
  describeCells(v, k.cells, 64);
  v.integer("octaves", k.octaves,
            {.unit = "1",
             .min = 1,
             .max = 12,
             .help = "Octaves of the last pictures: each costs as much as the first.",
             .aliases = "detail"});
  v.number("gain", k.gain,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Weight of an octave over the one before: more is rougher.",
            .aliases = "persistence"});
  describeSeed(v, k.seed);
}

}  // namespace skydrop::lab
