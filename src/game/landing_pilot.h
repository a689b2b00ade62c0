// The pilot of the last kilometres: flies down to a strip, flares, rolls out, stops, turns round where it
// must and takes off again. Reads snapshots, answers with controls, as the autopilot that it works for.
#pragma once

#include <cstdint>
#include <optional>

#include "skydrop/game/controls.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::game {

class LandingPilot {
 public:
  enum class Phase { away, approach, final, rollOut, turnRound, takeOff };

  Phase phase() const { return phase_; }
  // Whether wind and gusts, where the aircraft is, let it land there.
  static bool isCalmEnough(const terrain::Strip& strip, const Snapshot& now);
  // Begins to fly to the strip: the way round that has the wind ahead, where both approaches are free.
  void begin(const terrain::Strip& strip, const Snapshot& now);
  // From where the aircraft stands, on a strip or anywhere.
  void beginTakeOff(const std::optional<terrain::Strip>& strip, const Snapshot& now);
  void forget() { phase_ = Phase::away; }

  // In Phase::approach: where to fly before it lands. x, z.
  glm::dvec2 gate() const;
  // The controls in all other phases; goes on to the next one.
  Controls decide(const Snapshot& now);
  // In Phase::approach: whether the final begins here.
  bool entersFinal(const Snapshot& now);

 private:
  Controls flyFinal(const Snapshot& now);
  Controls rollOut(const Snapshot& now);
  Controls turnRound(const Snapshot& now);
  Controls takeOff(const Snapshot& now);
  double steer(const Snapshot& now) const;

  Phase phase_ = Phase::away;
  terrain::Strip strip_;  // landed on along `along`
  std::uint64_t stoppedSteps_ = 0;
  bool flares_ = false;
  bool joined_ = false;  // it has been far enough out to come in along the strip
};

}  // namespace skydrop::game
