// Where the aircraft's lamps are, how bright they are towards a place, and how they are shown. Pure functions
// of snapshot and time; any thread.
//
// Figures: FAR 23.1385 to 23.1397 (position lights: dihedral angles of 110, 110 and 140 degrees; at least 40
// cd ahead, 30 from 10 degrees on, 5 from 20 on, 20 behind; at most 10 cd within 10 degrees beyond a sector
// and 1 cd farther out) and 23.1401 (anti-collision: 40 to 100 flashes a minute, red or white, 100 to 400 cd
// of effective intensity).
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "skydrop/game/snapshot.h"
#include "skydrop/render/frame/view.h"
#include "skydrop/render/models/aircraft_lights_settings.h"
#include "skydrop/render/models/model_lamps.h"

namespace skydrop::render {

// What a position light sends out in a level direction, cd. `outsideDegrees`: from the edge of its sector,
// negative within; `fromAheadDegrees`: from straight ahead, 0 to 180 (of the tail light: from straight
// behind).
double forwardLightIntensity(double fromAheadDegrees, double outsideDegrees);
double tailLightIntensity(double outsideDegrees);
// Of all position lights: what of the level intensity is left at an angle above or below, 0 to 90
// (FAR 23.1393).
double verticalShare(double elevationDegrees);

// Of a flash whose peak is 1, at a phase of its period, [0, 1): two pulses of a strobe, one of a beacon. A
// pulse is as long as a few frames, where a real one takes a millisecond: none falls between two frames.
double strobeShare(double phase, double periodS);
double beaconShare(double phase, double periodS);
// [0, 1); finite for any time.
double flashPhase(double simulatedSeconds, double flashesPerMinute);

// One lamp as it is now.
struct LitLamp {
  std::string_view name;
  glm::dvec3 position{0};      // world, m
  glm::dvec3 color{1};         // linear sRGB primaries of luminance 1
  double towardsEye = 0;       // cd
  double towardsAircraft = 0;  // cd, what falls on the aircraft itself
};

// The lamps on the outside as an eye (world) sees them; of a wreck none is lit.
std::vector<LitLamp> litLamps(const game::AircraftSnapshot& aircraft, const AircraftLightsSettings& settings,
                              double simulatedSeconds, const glm::dvec3& eye);
// Over the instruments.
LitLamp cabinLamp(const game::AircraftSnapshot& aircraft, const AircraftLightsSettings& settings);

// The inside of the fuselage of airplane.glb, body axes, m.
inline constexpr glm::dvec3 kCabinLow{-0.57, -0.6, -1.3}, kCabinHigh{0.57, 1.05, 1.5};
// Whether a place (world) is in there.
bool isInsideCabin(const game::AircraftSnapshot& aircraft, const glm::dvec3& place);

// The lamps of a frame. A resource of the frame (FrameResources), published by LampsPass before models are
// drawn.
struct AircraftLamps {
  std::vector<LitLamp> outside;  // empty where the eye is inside: then the cabin's is all there is
  ModelLamps onModel;
  bool areSeenOnModel = true;  // not where the sun outshines them: then the aircraft is drawn without
};

// Light on the aircraft, after exposure. A lamp saturates at a share of white a metre away, as an eye
// shows it that gets used to it. From inside, the cabin's lamp alone.
ModelLamps lampsOnModel(const View& view, std::span<const LitLamp> lamps, double exposure);

}  // namespace skydrop::render
