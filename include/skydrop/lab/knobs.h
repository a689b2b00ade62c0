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

void describe(core::SettingsVisitor& visitor, OrbitKnobs& knobs);
void describe(core::SettingsVisitor& visitor, MarchKnobs& knobs);
void describe(core::SettingsVisitor& visitor, ShapeKnobs& knobs);
void describe(core::SettingsVisitor& visitor, ShadowKnobs& knobs);
void describe(core::SettingsVisitor& visitor, BlendKnobs& knobs);
void describe(core::SettingsVisitor& visitor, OcclusionKnobs& knobs);

}  // namespace skydrop::lab
