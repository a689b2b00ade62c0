// What a frame looks like, apart from what is in it.
#pragma once

#include "skydrop/core/settings.h"

namespace skydrop::render {

struct CameraSettings {
  double fovDegrees = 60;        // vertical
  double nearM = 0.1;            // m
  double chaseDistance = 15;     // m behind the aircraft
  double chaseHeight = 2.8;      // m above it, in its own axes
  double chaseSoftness = 1;      // 0 bolted to the aircraft .. 1 hangs back in its turns
  double groundClearance = 2;    // m of the chase camera above land and sea, at least
  double buffetDegrees = 0.35;   // by how much a full stall shakes the picture
  double cockpitForward = 0.35;  // m ahead of the aircraft's centre
  double cockpitHeight = 0.72;   // m above it
};

struct SunSettings {
  double elevationDegrees = 40;  // above the horizon; negative: night
  double azimuthDegrees = 135;   // compass
};

struct AtmosphereSettings {
  double visibilityM = 100000;  // distance at which contrast falls to 2 %, at sea level
  double hazeHeightM = 1200;    // scale height of the aerosol
  double hazeAnisotropy = 0.7;  // g of its phase function
};

// How much of the land's surface is worked out.
enum class LandDetail {
  plain,  // colours down to 40 m, and the samples' normals
  rich    // trees, strata, clods and grains, hollows and ridges
};

struct RenderSettings {
  CameraSettings camera;
  SunSettings sun;
  AtmosphereSettings atmosphere;
  double exposureStops = 0;  // on top of the automatic exposure
  bool smoothModels = true;  // four samples a pixel for aircraft and packages
  LandDetail landDetail = LandDetail::rich;
  bool wireframe = false;
  bool terrainNormals = false;
};

void describe(core::SettingsVisitor& visitor, CameraSettings& settings);
void describe(core::SettingsVisitor& visitor, SunSettings& settings);
void describe(core::SettingsVisitor& visitor, AtmosphereSettings& settings);
void describe(core::SettingsVisitor& visitor, RenderSettings& settings);

}  // namespace skydrop::render
