// One moment of the game as plain data: what render, ui and audio read. Metres, metres per second, radians,
// seconds; world axes (y up, +x east, -z north); quaternions body to world (body: forward -z, right +x).
// A snapshot is a value: it may be kept, copied and handed to other threads.
#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/game/controls.h"
#include "skydrop/game/surface_burst.h"
#include "skydrop/weather/moment.h"

namespace skydrop::game {

// What the ground knows of the aircraft, in flights with a gear.
struct GearSnapshot {
  bool present = false;  // false without a gear: the rest is then meaningless
  int wheelsDown = 0;    // 0 .. 3
  double brakes = 0;     // 0 .. 1, what the wheels do
  double groundSpeedMps = 0;
  bool onStrip = false;
  bool swims = false;     // ditched, until the respawn
  std::string endReason;  // why the flight ended; empty while it goes on
};

struct AircraftSnapshot {
  bool present = false;  // false in scenes without an aircraft: the rest is then meaningless
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
  glm::dvec3 velocity{0};
  glm::dvec3 angularVelocityBody{0};  // rad/s about the body's axes
  // The attitude that trails softly behind `orientation` while it turns (for a camera that follows).
  glm::dquat trailingOrientation{1, 0, 0, 0};
  double airspeedMps = 0;
  double throttle = 0;           // 0 idle .. 1 full: what the engine does, not what the key asks
  Controls controls;             // of the step that led here
  double propellerAngleRad = 0;  // [0, 2 pi)
  double headingRad = 0;         // compass: 0 north, pi/2 east, in [0, 2 pi)
  double pitchRad = 0;           // nose above the horizon, [-pi/2, pi/2]
  double bankRad = 0;            // right wing down positive, (-pi, pi]
  double angleOfAttackRad = 0;   // air from below positive
  double sideslipRad = 0;        // flight path right of the nose positive
  double loadFactor = 1;         // lift over weight, "g"
  double groundHeight = 0;       // of the surface below: land, or the sea at 0
  double heightAboveGround = 0;
  bool stallWarning = false;  // near the stall, or in it
  bool stalled = false;       // the flow has left the wing: less lift, and the nose drops
  double buffet = 0;          // shaking by torn flow: 0 none .. 1 in a full stall
  bool crashed = false;       // lies where it struck, until the respawn
  double secondsToRespawn = 0;
  std::uint32_t spawnCount = 0;  // changes when the aircraft is placed again: do not interpolate across it
  GearSnapshot gear;
};

// The air round the aircraft, in scenes with weather.
struct AirSnapshot {
  bool present = false;      // false without weather: the rest is then meaningless
  glm::dvec3 wind{0};        // mean, level, m/s
  glm::dvec3 velocity{0};    // of the air, gusts and draughts included, m/s
  double risingMps = 0;      // of draughts
  double turbulenceMps = 0;  // standard deviation of the gusts, mean of the three axes
  double densityShare = 1;   // of that at the sea's level
  double indicatedMps =
      0;  // airspeed that instruments show: true airspeed times the root of the density's share
  double groundMps = 0;  // speed over the ground
  double driftRad = 0;   // of the path over the ground, right of the nose positive; the crab angle's opposite
  double cloudDensity = 0;  // [0, 1]
  double temperatureC = 15;
  double icing = 0;  // 0 none .. 1 the most that the wing carries
};

// Where a package that falls will land, as predicted twice a second from where it is.
struct PackageLanding {
  glm::dvec3 position{0};
  double seconds = 0;           // until then
  std::optional<double> missM;  // from the centre of the target that it was dropped for; none without
  bool hits = false;            // inside that target
};

struct PackageSnapshot {
  std::uint32_t id = 0;  // unique in a run, counts drops from 1
  glm::dvec3 position{0};
  glm::dquat orientation{1, 0, 0, 0};
  glm::dvec3 velocity{0};
  double parachuteOpen = 0;  // 0 packed .. 1 fully open; stays at 1 on the ground
  bool landed = false;
  bool onWater = false;
  glm::dvec3 groundNormal{0, 1, 0};  // unit, of what it landed on
  std::optional<PackageLanding> landing =
      std::nullopt;  // none once it has landed, or where none is predicted
};

struct TargetSnapshot {
  bool present = false;
  std::uint32_t id = 0;
  glm::dvec3 position{0};  // on the ground
  double radius = 0;
  double distance = 0;    // horizontal, from the aircraft
  double bearingRad = 0;  // compass direction from the aircraft, [0, 2 pi); 0 straight above the target
};

struct Message {
  std::string text;
  double secondsLeft = 0;
};

struct Snapshot {
  std::uint64_t stepCount = 0;
  double simulatedSeconds = 0;
  AircraftSnapshot aircraft;
  std::vector<PackageSnapshot> packages;  // oldest first
  TargetSnapshot target;
  std::optional<glm::dvec3> predictedLanding;  // of a package dropped now (refreshed 10 times a second)
  bool dropZone = false;       // the predicted landing point lies inside the target: show the text
  double cooldownSeconds = 0;  // until the next drop is possible
  std::int64_t score = 0;
  std::int64_t drops = 0;
  std::int64_t misses = 0;
  std::int64_t points = 0;        // of all hits together (delivery.h)
  std::vector<Message> messages;  // oldest first
  glm::dvec3 wind{0};             // mean, at the aircraft
  AirSnapshot air;
  weather::Moment weather;           // none in scenes without
  std::vector<SurfaceBurst> bursts;  // oldest first; none where the world keeps none

  // Set by whoever runs the world (app), for the HUD.
  std::optional<double>
      pullUpSeconds;  // until the flight path meets the ground, where that is to be warned of
  bool autopilot = false;
  bool paused = false;
  bool frozen = false;  // time is held, the camera is not
};

}  // namespace skydrop::game
