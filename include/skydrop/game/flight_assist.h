// What helps the one who flies: turns with a limited bank that keep the height, and a warning of ground
// ahead. Both work on what a pilot has (a snapshot, the height of the ground) and stand before the world as
// the autopilot does: what they make of the player's controls is what a log records and a replay flies, so a
// flight without them, and every log of an earlier one, is what it was. Deterministic. Not thread-safe.
#pragma once

#include <optional>

#include "skydrop/core/settings.h"
#include "skydrop/game/controls.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::terrain {
class HeightSource;
}

namespace skydrop::game {

// describe() states and enforces the ranges.
struct AssistSettings {
  bool turns = true;           // off: expert mode, the controls are the player's own
  double maxBankDeg = 45;      // degrees, 10 .. 60: of assisted turns
  bool terrainWarning = true;  // "PULL UP"
  double warningSeconds = 6;   // s, 1 .. 20: of flight before the ground
};

void describe(core::SettingsVisitor& visitor, AssistSettings& settings);

class FlightAssist {
 public:
  // The controls for the step after `now`: those of the player until they roll; from then on a bank as far as
  // the key or stick asks for, never above the limit, at the height at which nobody pulled or pushed last;
  // the player's own again once the wings are level. Without aircraft, in a crash and on the ground: as
  // given.
  Controls decide(const Snapshot& now, const Controls& player, const AssistSettings& settings);

 private:
  bool turning_ = false;
  std::optional<double> heldM_;  // height above the sea, while nobody pulls or pushes
};

// Seconds until the path that the aircraft flies (its speed, its climb, the turn that its bank makes) meets
// land or sea; none within `horizonSeconds`, without aircraft, after a crash, for values that are not finite,
// and for a touch-down: on wheels, or a path that meets the ground at less than kGentleSink where there is a
// gear.
std::optional<double> secondsToGround(const terrain::HeightSource& ground, const AircraftSnapshot& aircraft,
                                      double horizonSeconds);
inline constexpr double kGentleSink = 4;  // m/s into the ground

}  // namespace skydrop::game
