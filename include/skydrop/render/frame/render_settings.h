// What a frame looks like, apart from what is in it. Plain values; describe() states and enforces the ranges
// at every entry (files, --set, the menu). Renderer::apply takes a change over for the next frame.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "skydrop/core/settings.h"
#include "skydrop/sky/atmosphere.h"

namespace skydrop::render {

struct CameraSettings {
  double fovDegrees = 60;        // vertical, 20 .. 120
  double nearM = 0.1;            // m, 0.02 .. 5
  double chaseDistance = 15;     // m behind the aircraft, 4 .. 60
  double chaseHeight = 2.8;      // m above it, in its own axes, 0 .. 20
  double chaseSoftness = 1;      // 0 bolted to the aircraft .. 1 hangs back in its turns
  double groundClearance = 2;    // m of the chase camera above land and sea, at least; 0.5 .. 50
  double buffetDegrees = 0.35;   // by how much a full stall shakes the picture, 0 .. 2
  double cockpitForward = 0.35;  // m ahead of the aircraft's centre, -2 .. 5
  double cockpitHeight = 0.72;   // m above it, -1 .. 3
};

// Who decides where the sun stands.
enum class SunSource {
  manual,  // two angles
  clock    // place and time: the almanac (skydrop/sky/almanac.h)
};
inline constexpr std::array<std::string_view, 2> kSunSourceNames = {"manual", "clock"};

struct SunSettings {
  double elevationDegrees = 40;  // above the horizon, -30 .. 90; negative: night
  double azimuthDegrees = 135;   // compass, 0 .. 360
  SunSource source = SunSource::manual;
  // Of the clock: the time is utcMs + shiftDays + shiftHours + offsetSeconds + simulated seconds * timeScale.
  std::int64_t utcMs = 1782036000000;  // ms since 1970 (sky::Instant): 2026-06-21T10:00:00Z
  double shiftDays = 0;                // d, -366 .. 366
  double shiftHours = 0;               // h, -24 .. 24
  double timeScale = 1;                // 0 .. 3600
  double offsetSeconds = 0;            // s, that changes of timeScale in flight have left (clock_pace.h)
  double latitudeDegrees = 47.5;       // north, -90 .. 90
  double longitudeDegrees = 11;        // east, -360 .. 360

  bool operator==(const SunSettings&) const = default;
};

struct AtmosphereSettings {
  double visibilityM = 100000;  // m, 1e3 .. 250e3: distance at which contrast falls to 2 %, at sea level
  double hazeHeightM = 1200;    // m, 100 .. 4000: scale height of the aerosol
  double hazeAnisotropy = 0.7;  // g of its phase function, 0 .. 0.95

  bool operator==(const AtmosphereSettings&) const = default;
};

struct SkySettings {
  sky::SkyModel model = sky::SkyModel::shell;
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
  SkySettings sky;
  double exposureStops = 0;       // EV, -6 .. 6, on top of the automatic exposure
  double scale = 1;               // of the sides in which the scene is drawn, .25 .. 4 of the picture's
  double interfaceAtNight = 0.5;  // brightness of the interface at night, 0.2 .. 1
  bool smoothModels = true;       // four samples a pixel for aircraft and packages
  bool smoothEdges = true;        // blends pixels at edges of what is drawn with one
  double leastEdge = 0.03;        // of the distance, by which surfaces at an edge differ, 0.002 .. 0.9
  bool guardMarks = false;        // shows where a guard of the shading fired
  LandDetail landDetail = LandDetail::rich;
  bool wireframe = false;       // the land as lines
  bool terrainNormals = false;  // a stroke along the normal of each of its vertices
};

void describe(core::SettingsVisitor& visitor, CameraSettings& settings);
void describe(core::SettingsVisitor& visitor, SunSettings& settings);
void describe(core::SettingsVisitor& visitor, AtmosphereSettings& settings);
void describe(core::SettingsVisitor& visitor, SkySettings& settings);
void describe(core::SettingsVisitor& visitor, RenderSettings& settings);

}  // namespace skydrop::render
