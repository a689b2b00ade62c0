#include "skydrop/lab/knobs.h"

namespace skydrop::lab {
namespace {

using core::SettingsVisitor;

void describeSun(SettingsVisitor& v, double& azimuth, double& elevation) {
  v.number("sunAzimuthDegrees", azimuth,
           {.unit = "deg",
            .min = -360,
            .max = 360,
            .help = "Where the light comes from, from the front to the right.",
            .slider = core::Range{-180, 180}});
  v.number("sunElevationDegrees", elevation,
           {.unit = "deg",
            .min = -90,
            .max = 90,
            .help = "Height of the light: low light makes long shadows.",
            .slider = core::Range{5, 90}});
}

}  // namespace

void describe(SettingsVisitor& v, OrbitKnobs& k) {
  v.number("azimuthDegrees", k.azimuthDegrees,
           {.unit = "deg",
            .min = -360,
            .max = 360,
            .help = "Where the eye is, from the front to the right.",
            .slider = core::Range{-180, 180}});
  v.number("elevationDegrees", k.elevationDegrees,
           {.unit = "deg", .min = -89, .max = 89, .help = "Height of the eye above the level."});
  v.number("distance", k.distance,
           {.unit = "1",
            .min = 0.1,
            .max = 50,
            .help = "From the eye to the middle: within the scene's bodies "
                    "rays begin inside.",
            .logarithmic = true,
            .slider = core::Range{1, 20}});
}

void describe(SettingsVisitor& v, MarchKnobs& k) {
  v.group("view", k.view, "Where the eye is; the mouse turns it.");
  v.number("stride", k.stride,
           {.unit = "1",
            .min = 0,
            .max = 10,
            .help = "Length of a step, the first one where it is halved: more takes "
                    "fewer steps and misses more.",
            .logarithmic = true,
            .slider = core::Range{0.02, 1},
            .aliases = "step size"});
  v.number("tolerance", k.tolerance,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "A surface that is nearer is hit, or a step that is shorter ends "
                    "the halving: less is more exact.",
            .logarithmic = true,
            .slider = core::Range{1e-5, 0.1},
            .aliases = "epsilon, surface distance"});
  v.number("reach", k.reach,
           {.unit = "1",
            .min = 0.1,
            .max = 100,
            .help = "How far a ray is followed: less ends rays that miss sooner.",
            .logarithmic = true,
            .slider = core::Range{4, 40}});
  v.integer("mostSteps", k.mostSteps,
            {.unit = "1",
             .min = 0,
             .max = 1e6,
             .help = "Questions to the scene until a ray gives up.",
             .logarithmic = true,
             .slider = core::Range{1, 512}});
  v.number(
      "aim", k.aim,
      {.unit = "1", .min = -1, .max = 1, .help = "Height in the picture of the ray that the cut shows."});
}

void describe(SettingsVisitor& v, ShapeKnobs& k) {
  v.group("view", k.view, "Where the eye is; the mouse turns it.");
  v.number("epsilon", k.epsilon,
           {.unit = "1",
            .min = 1e-12,
            .max = 0.5,
            .help = "Step of the central differences: more rounds edges, less "
                    "drowns in rounding.",
            .logarithmic = true,
            .slider = core::Range{1e-7, 0.1}});
  v.number("ambient", k.ambient,
           {.unit = "1", .min = 0, .max = 1, .help = "Light that reaches every place."});
  v.number("diffuse", k.diffuse,
           {.unit = "1", .min = 0, .max = 1, .help = "Light that is scattered evenly."});
  v.number("specular", k.specular, {.unit = "1", .min = 0, .max = 1, .help = "Light that is mirrored."});
  v.number("shininess", k.shininess,
           {.unit = "1",
            .min = 1,
            .max = 1000,
            .help = "Exponent of the mirrored light: more makes smaller spots.",
            .logarithmic = true,
            .slider = core::Range{2, 256}});
  describeSun(v, k.sunAzimuthDegrees, k.sunElevationDegrees);
  v.number("cutHeight", k.cutHeight,
           {.unit = "1",
            .min = -3,
            .max = 3,
            .help = "Height of the level cut through the distances.",
            .slider = core::Range{0, 2}});
}

void describe(SettingsVisitor& v, ShadowKnobs& k) {
  v.group("view", k.view, "Where the eye is; the mouse turns it.");
  v.number("hardness", k.hardness,
           {.unit = "1",
            .min = 0,
            .max = 1e9,
            .help = "k of the middle picture: more makes narrower penumbras.",
            .logarithmic = true,
            .slider = core::Range{0.5, 64},
            .aliases = "k"});
  v.number("softHardness", k.softHardness,
           {.unit = "1",
            .min = 0,
            .max = 1e9,
            .help = "k of the right picture.",
            .logarithmic = true,
            .slider = core::Range{0.5, 64},
            .aliases = "k"});
  v.number("start", k.start,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Where a shadow's ray begins: too near, and surfaces shade "
                    "themselves.",
            .slider = core::Range{0.002, 0.2}});
  v.integer("mostSteps", k.mostSteps,
            {.unit = "1",
             .min = 0,
             .max = 1e6,
             .help = "Questions to the scene until a ray gives up.",
             .logarithmic = true,
             .slider = core::Range{1, 256}});
  describeSun(v, k.sunAzimuthDegrees, k.sunElevationDegrees);
}

void describe(SettingsVisitor& v, BlendKnobs& k) {
  v.group("view", k.view, "Where the eye is; the mouse turns it.");
  v.number("share", k.share,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Of the sphere in the blend: 0 is the box, 1 the sphere.",
            .aliases = "k"});
  v.number("width", k.width,
           {.unit = "1",
            .min = 0,
            .max = 1e9,
            .help = "Of the crease that the smooth union fills: 0 is the union.",
            .slider = core::Range{0, 1.5},
            .aliases = "k"});
}

void describe(SettingsVisitor& v, OcclusionKnobs& k) {
  v.group("view", k.view, "Where the eye is; the mouse turns it.");
  v.number("stride", k.stride,
           {.unit = "1",
            .min = 0,
            .max = 2,
            .help = "Between the places along the normal: more reaches further.",
            .slider = core::Range{0.02, 0.5}});
  v.integer("count", k.count,
            {.unit = "1",
             .min = 0,
             .max = 64,
             .help = "Places along the normal: each costs a distance.",
             .slider = core::Range{0, 12}});
  v.number("intensity", k.intensity,
           {.unit = "1",
            .min = 0,
            .max = 2,
            .help = "How much a near surface darkens: more is darker.",
            .slider = core::Range{0, 1}});
}

}  // namespace skydrop::lab
