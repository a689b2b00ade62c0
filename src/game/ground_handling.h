// The aircraft on the ground and on water: what its gear bears, what the pilot's levers do there, and what
// breaks. A part of the aircraft's step; nothing of it runs higher than kGearReach above the surface.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "game/event_log.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/landing_gear.h"
#include "skydrop/game/controls.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::game {

// Why a flight ends on the ground.
struct Damage {
  std::string reason;  // for the player: what broke, and at what limit
  bool legs = false;   // the gear is gone
  bool water = false;
};

class GroundHandling {
 public:
  explicit GroundHandling(const flight::GearSettings& settings) : gear_(settings) {}

  void apply(const flight::GearSettings& settings) { gear_.apply(settings); }
  // In the air, or at rest on the wheels.
  void start(bool onWheels);

  // Whether a step at this height above the surface can touch it.
  bool isNear(double clearance) const { return clearance < flight::kGearReach || gear_.touches(); }
  // The levers as they act now: on the wheels the throttle rests at idle, a wreck has none.
  flight::AirplaneInput levers(const Controls& controls) const;

  // A step of the airplane near the ground. Returns what broke in it.
  std::optional<Damage> step(flight::Airplane& airplane, const Controls& controls, const flight::AirMass& air,
                             const terrain::HeightSource& ground, EventLog& eventLog);
  // A step away from it.
  void leave(const Controls& controls, const glm::dvec3& position, EventLog& eventLog);

  // After damage that ended the flight: no engine, no levers.
  void wreck(bool legs);
  bool swims() const { return swimSteps_ > 0; }
  // Steps since it ditched.
  std::uint64_t swimSteps() const { return swimSteps_; }
  bool onWheels() const { return gear_.wheelsDown() > 0; }
  double wheelBrakes() const { return brakes_; }

  void fill(GearSnapshot& out, const flight::BodyState& body, const terrain::HeightSource& ground) const;
  void addTo(core::StateHasher& hash) const;

 private:
  std::optional<Damage> damageOf(const flight::Airplane& airplane) const;
  void noteWheels(const Controls& controls, const glm::dvec3& position, double sinkRate, EventLog& eventLog);

  flight::LandingGear gear_;
  bool idles_ = false;     // the throttle's rest, until the aircraft has flown for a while
  bool grounded_ = false;  // between a touch-down and the take-off after it
  bool wrecked_ = false;
  std::uint64_t airborneSteps_ = 0;
  std::uint64_t swimSteps_ = 0;
  double brakes_ = 0;  // derived, for the view
};

}  // namespace skydrop::game
