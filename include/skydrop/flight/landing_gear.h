// What of the aircraft touches the ground or the water, and what these answer: two main wheels, a tail wheel
// that steers, and points of the hull. docs/ground-handling.md has the model's figures. SI units, double,
// deterministic. Not thread-safe.
//
// - Along the ground's normal a contact is a spring whose damping grows with its compression (Hunt, Crossley
//   1975): force = k x (1 + d dx/dt), never below 0. So it begins and ends without a jump and never pulls.
// - Across a wheel the tyre's deflection z follows its slip with a relaxation length s (Clark, Dodge,
//   Nybakken 1972; Pacejka 2002, 7.2): dz/dt = v - |v_rolling| z / s. Rolling, that is a slip angle; at rest
//   it is a spring that holds on a slope without creeping. The force saturates smoothly at the friction.
// - Along a wheel the same deflection without relaxation is cut where brakes and rolling resistance give way
//   (Prandtl's element): so brakes hold at rest, and slip when they must. A point of the hull is a wheel that
//   is always locked, both ways.
// Friction along takes its share from that across (the friction circle).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "skydrop/flight/gear_settings.h"
#include "skydrop/flight/integrator.h"

namespace skydrop::flight {

enum class GearPoint {
  leftWheel,
  rightWheel,
  tailWheel,
  propeller,
  nose,
  belly,
  tail,
  leftWing,
  rightWing,
  leftTailplane,
  rightTailplane,
  fin,
  roof,
  count_
};
inline constexpr std::size_t kGearPoints = static_cast<std::size_t>(GearPoint::count_);
inline constexpr std::size_t kWheels = 3;  // the first of them

// Where they are on the aircraft, body axes, m: with the springs at full length. Those of wheels touch the
// ground; at rest they are as far up as the model's wheels.
extern const std::array<glm::dvec3, kGearPoints> kGearPlaces;
// Below this height of the aircraft's middle over the ground a point of it can touch, whatever its attitude.
inline constexpr double kGearReach = 6;

// The ground below a point: a plane, and how one rolls on it.
struct GroundPatch {
  double height = 0;       // m, at `at`
  glm::dvec2 at{0};        // x, z
  glm::dvec2 gradient{0};  // m a metre
  double rolling = 0.05;   // rolling resistance, share of the load
  double grip = 1;         // factor on the tyre's friction
  bool water = false;
};

// Answers with the ground at a place; asked for points that are near it, several times a step. Made of a
// callable that takes x and z; a reference, not owned.
class GroundField {
 public:
  template <class F>
  GroundField(const F& f)  // NOLINT: implicit, lambdas are passed in place
      : object_(&f), call_([](const void* o, const glm::dvec2& xz) -> GroundPatch {
          return (*static_cast<const F*>(o))(xz);
        }) {}
  GroundPatch operator()(const glm::dvec2& xz) const { return call_(object_, xz); }

 private:
  const void* object_;
  GroundPatch (*call_)(const void*, const glm::dvec2&);
};

// Of one point.
struct GearContact {
  double deflectionAlong = 0, deflectionAcross = 0;  // m, of the tyre
  bool touching = false;
};

struct GearInput {
  double brake = 0;  // 0 .. 1
  double steer = 0;  // -1 .. 1, nose right positive
};

// What happened to a point in a step.
struct GearLoad {
  double compression = 0;   // m, at the end
  double closingSpeed = 0;  // m/s along the normal as it touched; 0 unless it did in this step, or parted
  double slideSpeed = 0;    // m/s along the ground then
  double force = 0;         // N along the normal, at the end
  double side = 0;          // N across the wheel, at the end
  double slope = 0;         // m a metre, of the ground below
  bool water = false;
};

class LandingGear {
 public:
  explicit LandingGear(const GearSettings& settings) : settings_(settings) {}

  void apply(const GearSettings& settings) { settings_ = settings; }
  const GearSettings& settings() const { return settings_; }

  // As far from any ground.
  void lift();
  // The legs are gone: wheels bear no more.
  void breakLegs() { broken_ = true; }
  void mend() { broken_ = false; }
  bool broken() const { return broken_; }

  // Begins a step: forgets how fast points touched in the last one.
  void beginStep();
  // Begins a part of a step: asks for the ground below the points that are near it.
  void meet(const BodyState& state, const GearInput& input, const GroundField& ground);
  // The forces `seconds` after meet(): a pure function of the state until the next one.
  Wrench wrench(const BodyState& state, double seconds) const;
  // Ends the part, `seconds` after it began.
  void settle(const BodyState& state, double seconds);

  // Energy of its springs, J, at the state of the last settle(): for tests and studies.
  double springEnergy() const;

  const std::array<GearLoad, kGearPoints>& loads() const { return loads_; }
  const std::array<GearContact, kGearPoints>& contacts() const { return contacts_; }
  bool touches() const;    // anything
  int wheelsDown() const;  // 0 .. 3
  // Share of the weight that wheels bear, 0 .. 1, in the last step.
  double borne(double weight) const;

 private:
  struct Point;
  Point at(std::size_t i, const BodyState& state, double seconds) const;

  GearSettings settings_;
  GearInput input_;
  double steerRad_ = 0;
  bool broken_ = false;
  std::array<GearContact, kGearPoints> contacts_;
  std::array<GroundPatch, kGearPoints> patches_;
  std::array<bool, kGearPoints> near_{};
  std::array<glm::dvec3, kGearPoints> velocities_{};  // as the part began
  std::array<GearLoad, kGearPoints> loads_;
};

}  // namespace skydrop::flight
