// A pilot: reads a snapshot and the height of the ground, answers with controls. Flies to the target at a
// safe height, drops when the predicted landing point is well inside, and goes around when it cannot. Where
// the flight has a gear it takes off from the ground, and on request lands on the nearest strip. It uses
// nothing that a player does not have, so its flights can be recorded and replayed like a player's.
// Deterministic; depends on the snapshots it was shown only. Not thread-safe.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "skydrop/core/settings.h"
#include "skydrop/game/controls.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::terrain {
class HeightSource;
}

namespace skydrop::game {

class LandingPilot;

// describe() states and enforces the ranges.
struct AutopilotSettings {
  double clearance = 150;        // m above the highest ground ahead, 30 .. 2000
  double lookAheadSeconds = 25;  // s of flight in which the ground counts, 5 .. 120
  double maxBankDeg = 50;        // degrees, 10 .. 70
  double dropMargin = 0.5;       // of the radius, 0.05 .. 1: drops when the predicted miss is below this
  std::int64_t landEvery = 0;    // packages, 0 .. 100: lands after so many and takes off again; 0 never
};

void describe(core::SettingsVisitor& visitor, AutopilotSettings& settings);

class Autopilot {
 public:
  // `ground`: that of the world it flies in, not null.
  explicit Autopilot(std::shared_ptr<const terrain::HeightSource> ground,
                     const AutopilotSettings& settings = {});
  ~Autopilot();
  Autopilot(Autopilot&&) noexcept;

  // The controls for the step after `now`. Without aircraft: neutral. Without a target: level flight around.
  Controls decide(const Snapshot& now);

  void apply(const AutopilotSettings& settings) { settings_ = settings; }
  // What stands on the ground, m: its clearance is then so much and 20 m at least. 0 without.
  void setObstacleHeight(double metres) { obstacleHeight_ = metres; }

 private:
  // Where to fly: along a bearing, as far as `distance`.
  struct Aim {
    double bearingRad = 0, distance = 0;
    bool present = false;
    bool descendsThere = false;  // beyond it ground does not count: another way is flown from there
  };
  Controls flyTo(const Snapshot& now, const Aim& aim);
  // Lands and takes off, where the settings, the aircraft and the land have it: nothing while it flies.
  std::optional<Controls> handleGround(const Snapshot& now);
  static Aim aimOf(const Snapshot& now);

  std::shared_ptr<const terrain::HeightSource> ground_;
  AutopilotSettings settings_;
  std::uint64_t plannedStep_ = 0;  // of the last look at the ground ahead
  double obstacleHeight_ = 0;      // m
  double wantedSlope_ = 0;         // m a metre
  bool goingAround_ = false;       // flying away from a target that is too near to turn to
  bool planned_ = false;
  std::unique_ptr<LandingPilot> landing_;
  std::int64_t landedAtDrops_ = 0;  // how many there had been at the last landing
};

}  // namespace skydrop::game
