// The air that the aircraft meets, step by step: mean wind, draughts, turbulence, density and ice. Without
// weather it is the setup's wind and costs nothing.
//
// What changes slowly is worked out four times a second, for the place where the aircraft will be by then,
// and mixed linearly between (docs/weather.md has the error); the filters of the turbulence advance with each
// step.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "skydrop/core/hash.h"
#include "skydrop/flight/airplane.h"
#include "skydrop/flight/rigid_body.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/game/world.h"
#include "skydrop/weather/dryden.h"
#include "skydrop/weather/wind_profile.h"

namespace skydrop::game {

class FlownAir {
 public:
  // Keeps the setup, which must outlive it; it may change between steps.
  explicit FlownAir(const WorldSetup& setup);

  // The aircraft is placed here, with the surface so high below: the air of this place at once, and no ice.
  void meet(const glm::dvec3& position, double surface, std::uint64_t step);
  // Once a step, before the aircraft moves; `clearance` is its height above the surface.
  void advance(const flight::BodyState& aircraft, double clearance, std::uint64_t step);

  const flight::AirMass& now() const { return now_; }
  // The mean wind at a place above a surface of this height, under the weather that the aircraft has: for the
  // prediction of where a package lands.
  glm::dvec3 meanWind(const glm::dvec3& position, double surface) const;
  // The same under the weather of the place itself: what carries a package there.
  glm::dvec3 meanWindOf(const glm::dvec3& position, double surface, double seconds) const;

  // The same with the gusts and draughts that a package feels there, m/s, as much of them as the settings
  // say. gusts: its own, advanced by this call, number `count` of them, over `interval` seconds.
  glm::dvec3 windOnPackage(const glm::dvec3& position, const glm::dvec3& velocity, double surface,
                           double seconds, weather::Dryden& gusts, std::uint64_t count,
                           double interval) const;

  AirSnapshot snapshot(const flight::BodyState& aircraft) const;
  void addTo(core::StateHasher& hash) const;

 private:
  static constexpr std::uint64_t kSampleSteps = 30;
  // What is mixed between two samples: velocity of the air without gusts, share of density, intensities.
  enum Mixed { kEast, kUp, kSouth, kDensity, kSigmaU, kSigmaV, kSigmaW, kMixed };
  using Sample = std::array<double, kMixed>;

  Sample sample(const glm::dvec3& position, double surface, double airspeed, double seconds);
  void turnAxis(const flight::BodyState& aircraft);
  void mix(double share);

  const WorldSetup* setup_;
  weather::Dryden dryden_;
  weather::WindProfile profile_;
  weather::DrydenStep gustStep_;
  Sample from_{}, to_{};
  std::array<double, kMixed> mixed_{};
  glm::dvec2 axis_{1, 0};  // of the longitudinal gusts: x east, z south, unit
  double draught_ = 0;     // of clouds, with rounded edges, m/s
  double ice_ = 0;
  double cloudDensity_ = 0, temperatureC_ = 15;
  std::uint64_t sampledStep_ = 0;
  flight::AirMass now_;
};

}  // namespace skydrop::game
