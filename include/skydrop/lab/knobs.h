// The knobs of the laboratory's pages.
#pragma once

#include <cstdint>

#include "skydrop/core/settings.h"

namespace skydrop::lab {

// Where the eye is, around the middle of the scene. The mouse turns these.
struct OrbitKnobs {
  double azimuthDegrees = 25;    // from the front, towards the right, [-360, 360]
  double elevationDegrees = 20;  // (-89, 89)
  double distance = 5;           // units of the scene, [0.1, 50]
};

struct MarchKnobs {
  OrbitKnobs view;
  double stride = 0.25;         // units, [0, 10]; 0 leads nowhere
  double tolerance = 1e-3;      // units, [0, 1]
  double reach = 12;            // units, [0.1, 100]
  std::int64_t mostSteps = 96;  // [0, 1000000]
  double aim = 0.1;             // of the cut's ray: height in the picture, [-1, 1]
};

struct ShapeKnobs {
  OrbitKnobs view{.azimuthDegrees = 25, .elevationDegrees = 28, .distance = 5.5};
  double epsilon = 1e-3;            // of the central differences, [1e-12, 0.5]
  double ambient = 0.15;            // [0, 1]
  double diffuse = 0.75;            // [0, 1]
  double specular = 0.4;            // [0, 1]
  double shininess = 32;            // [1, 1000]
  double sunAzimuthDegrees = 60;    // [-360, 360]
  double sunElevationDegrees = 45;  // [-90, 90]
  double cutHeight = 0.4;           // of the level cut through the distances, units, [-3, 3]
};

struct ShadowKnobs {
  OrbitKnobs view{.azimuthDegrees = 25, .elevationDegrees = 30, .distance = 5.5};
  double hardness = 7;          // k of the second picture, [0, 1e9]
  double softHardness = 1.2;    // k of the third, [0, 1e9]
  double start = 0.02;          // where the shadow's ray begins, units, [0, 1]
  std::int64_t mostSteps = 48;  // [0, 1000000]
  double sunAzimuthDegrees = 60;
  double sunElevationDegrees = 45;
};

struct BlendKnobs {
  OrbitKnobs view{.azimuthDegrees = 30, .elevationDegrees = 25, .distance = 5};
  double share = 0.5;  // of the first shape, [0, 1]
  double width = 0.5;  // of the smooth union's crease, units, [0, 1e9]
};

struct OcclusionKnobs {
  OrbitKnobs view{.azimuthDegrees = 30, .elevationDegrees = 30, .distance = 5};
  double stride = 0.1;     // units, [0, 2]
  std::int64_t count = 3;  // [0, 64]
  double intensity = 0.2;  // [0, 2]
};

struct RandomKnobs {
  double firstScale = 1;       // of the sine, upper picture, [0, 1e6]
  double secondScale = 10000;  // lower picture, [0, 1e6]
  double from = 0;             // where the plots begin, [-1e7, 1e7]
  double width = 12;           // of the plots, [1e-3, 1e5]
  double away = 1e6;           // of the second and fourth field from the origin, cells, [0, 1e7]
  double cells = 90;           // cells to the height of a field, [1, 1000]
  double slice = 0;            // of the fields in space, cells, [0, 1000]
};

struct PerlinKnobs {
  std::int64_t cells = 10;  // to a period, [1, 256]
  std::int64_t seed = 0;    // [0, 1000000]
  double pointX = 0.7;      // of the place that is looked at, in its cell, [0, 1]
  double pointY = 0.35;
  double slice = 0.3;  // of noise in space, periods, [0, 1)
};

struct VoronoiKnobs {
  std::int64_t cells = 8;   // to a picture, [1, 256]
  std::int64_t seed = 0;    // [0, 1000000]
  std::int64_t period = 3;  // of the tiled noise, cells, [1, 1000]
};

struct FractalKnobs {
  std::int64_t cells = 5;     // to a period in the first octave, [1, 64]
  std::int64_t octaves = 10;  // of the last picture, [1, 12]
  double gain = 0.5;          // weight of an octave over the one before, [0, 1]
  std::int64_t seed = 0;      // [0, 1000000]
};

struct CloudKnobs {
  OrbitKnobs view{.azimuthDegrees = 30, .elevationDegrees = 20, .distance = 2.4};  // in edges of the cube
  std::int64_t steps = 24;        // along the eye's ray, [0, 1000]
  std::int64_t lightSamples = 4;  // from each of them to the sun, [0, 1000]
  double extinction = 30;         // of a density of 1, per edge, [0, 1000]
  std::int64_t cells = 4;         // of both noises to an edge, [1, 32]
  std::int64_t seed = 3;          // [0, 1000000]
  double perlinThreshold = 0.5;   // [-1, 1]
  double perlinMultiplier = 2;    // [0, 20]
  double voronoiThreshold = 0.55;  // [-1, 1]
  double voronoiMultiplier = 3;   // [0, 20]
  double sunAzimuthDegrees = 110;
  double sunElevationDegrees = 40;
  double sunReach = 0.7;     // of the sun that is forwarded, half heights of the picture, [0, 10]
  double sunStrength = 0.6;  // exponent of the same, [0, 20]
};

void describe(core::SettingsVisitor& visitor, OrbitKnobs& knobs);
void describe(core::SettingsVisitor& visitor, MarchKnobs& knobs);
void describe(core::SettingsVisitor& visitor, ShapeKnobs& knobs);
void describe(core::SettingsVisitor& visitor, ShadowKnobs& knobs);
void describe(core::SettingsVisitor& visitor, BlendKnobs& knobs);
void describe(core::SettingsVisitor& visitor, OcclusionKnobs& knobs);
void describe(core::SettingsVisitor& visitor, RandomKnobs& knobs);
void describe(core::SettingsVisitor& visitor, PerlinKnobs& knobs);
void describe(core::SettingsVisitor& visitor, VoronoiKnobs& knobs);
void describe(core::SettingsVisitor& visitor, FractalKnobs& knobs);
void describe(core::SettingsVisitor& visitor, CloudKnobs& knobs);

}  // namespace skydrop::lab
