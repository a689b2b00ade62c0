// The aircraft as the game flies it: controls in, contact with the ground, crash, respawn and reset.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "game/event_log.h"
#include "game/flown_air.h"
#include "game/ground_handling.h"
#include "game/safe_places.h"
#include "game/trailing_attitude.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/controls.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/game/world.h"

namespace skydrop::game {

class PlayerAircraft {
 public:
  // Keeps all three, which must outlive it; the settings may change between steps. Starts at setup.start.
  // Throws core::RangeError when settings or pose are unusable.
  PlayerAircraft(const WorldSetup& setup, FlownAir& air, EventLog& eventLog);

  // One step, number `step`: reset, waiting after a crash, or flight.
  void advance(const Controls& controls, std::uint64_t step);

  // Again at a pose, at cruise throttle; a pose inside the ground is raised. Throws core::RangeError, and
  // changes nothing, unless finite.
  void place(const StartPose& pose, std::uint64_t step);
  void apply(const flight::AirplaneSettings& settings) { airplane_.apply(settings); }
  // After the setup's gear became another, came or went.
  void applyGear(std::uint64_t step);
  // After the ground became another: where it is nearer than the safe height, or above, the aircraft is
  // lifted and flies on level.
  void clearGround(std::uint64_t step);
  // The air became another, where it flies.
  void meetAir(std::uint64_t step);

  const flight::BodyState& body() const { return airplane_.body().state(); }
  double clearance() const { return clearance_; }
  bool crashed() const { return crashed_; }
  // Whether a package can leave: in flight.
  bool canDrop() const { return !crashed_ && !(ground_ && (ground_->onWheels() || ground_->swims())); }
  // Whether this step pressed the key that the last one did not.
  bool dropPressed() const { return controls_.drop && !lastControls_.drop; }
  // Whether it went back to its start in this step.
  bool wasReset() const { return controls_.reset && !lastControls_.reset; }
  std::uint32_t spawnCount() const { return spawnCount_; }

  AircraftSnapshot snapshot() const;
  void addTo(core::StateHasher& hash) const;

 private:
  void put(const glm::dvec3& position, double headingRad, double pitchRad, double bankRad, double speed,
           std::uint64_t step);
  void respawn(std::uint64_t step);
  void fly(std::uint64_t step);
  void noteSafePlace(std::uint64_t step);
  void putOnWheels(const StartPose& pose, std::uint64_t step);
  // Flies, or slides as a wreck; ends the flight where something breaks or the sea has it for long enough.
  void move(std::uint64_t step);
  void crash(const Contact& contact, std::string reason);
  void endFlight(const Damage& damage);
  // What is in the way where it is, as the reason for the end of a flight; null: nothing.
  const char* touchedObstacle() const;
  void turnPropeller();

  const WorldSetup* setup_;
  FlownAir* air_;
  EventLog* eventLog_;
  flight::Airplane airplane_;
  Controls controls_, lastControls_;
  double clearance_ = 0;  // of its middle above the surface, m
  double propellerAngleRad_ = 0;
  bool crashed_ = false;
  std::uint64_t stepsToRespawn_ = 0;
  std::uint32_t spawnCount_ = 0;
  SafePlaces safePlaces_;
  std::optional<GroundHandling> ground_;  // with a gear
  bool slides_ = false;                   // a wreck that moves on
  bool hasFlown_ = false;                 // since it was placed: a safe place was noted
  std::string endReason_;                 // derived, for the view
  TrailingAttitude trail_;                // derived, for the view
};

}  // namespace skydrop::game
