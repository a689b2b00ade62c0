#include "skydrop/flight/landing_gear.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/flight/environment.h"

namespace skydrop::flight {

namespace dmath = core::dmath;

namespace {

constexpr std::size_t index(GearPoint point) { return static_cast<std::size_t>(point); }

// A tyre's relaxation length, m, and its force per unit of deflection over relaxation length, in loads: the
// cornering stiffness per radian. That of the tail wheel is greater, so that the aircraft steers straight.
constexpr double kRelaxation = 0.3;
constexpr double kMainCornering = 4, kTailCornering = 9;
// Loads a metre of deflection along the wheel, and of a point of the hull both ways.
constexpr double kLocking = 20;
// Seconds of slip that count as deflection at rest, which damps sway; and the rolling speed that halves it.
constexpr double kSwayDamping = 0.05, kSwaySpeed = 1;
// The deflection across a tyre does not grow beyond so many times that at which its friction is reached.
constexpr double kMostDeflection = 3;
// The hull: N/m and s/m of its contacts, and its friction.
constexpr double kHullStiffness = 120000, kHullDamping = 1, kHullFriction = 0.5;
// A point is asked for its own ground within so many metres of the plane below the aircraft's middle, and
// what it may move in a step, s.
constexpr double kAskedWithin = 0.8, kAskedSeconds = 0.02;
// Water: N a metre of depth and the depth at which a point is all below it, m; areas (m^2) of drag along the
// water and into it. The wheels only drag.
struct Swimming {
  double lift, depth, along, into;
};
constexpr double kWaterDensity = 1000;
constexpr Swimming swimmingOf(std::size_t i) {
  switch (static_cast<GearPoint>(i)) {
    case GearPoint::nose:
      return {6000, 0.8, 0.01, 0.5};
    case GearPoint::belly:
      return {16000, 1.2, 0.05, 2};
    case GearPoint::tail:
      return {2500, 0.5, 0.01, 0.5};
    case GearPoint::leftWing:
    case GearPoint::rightWing:
      return {9000, 0.6, 0.03, 1.5};
    case GearPoint::roof:
      return {12000, 0.8, 0.05, 1};
    case GearPoint::leftWheel:
    case GearPoint::rightWheel:
      return {0, 0.3, 0.01, 0.02};
    default:
      return {0, 0.3, 0.005, 0.02};
  }
}

// x for small x, +-1 far out.
double saturated(double x) {
  const double square = x * x;
  return x / std::sqrt(std::sqrt(1 + square * square));
}

}  // namespace

// The main wheels' lowest points are 1.55 m below the middle in the model, the tail wheel's .24 m: at rest,
// after 8 and 7 cm of compression.
const std::array<glm::dvec3, kGearPoints> kGearPlaces{{{-1.18, -1.63, -0.92},
                                                       {1.18, -1.63, -0.92},
                                                       {0, -0.31, 4.54},
                                                       {0, -1.07, -2.9},
                                                       {0, -0.4, -3.1},
                                                       {0, -0.63, -0.3},
                                                       {0, -0.05, 4.72},
                                                       {-5.41, 1.15, 0},
                                                       {5.41, 1.15, 0},
                                                       {-1.72, 0.33, 4.6},
                                                       {1.72, 0.33, 4.6},
                                                       {0, 1.75, 4.6},
                                                       {0, 1.38, 0}}};

// A point as it stands in or over its patch.
struct LandingGear::Point {
  glm::dvec3 arm{0};  // from the middle, world axes
  glm::dvec3 normal{0, 1, 0}, along{0}, across{0};
  double compression = 0;  // m, along the normal; not positive without a contact
  double closing = 0;      // m/s
  double velocityAlong = 0, velocityAcross = 0;
  double force = 0, forceAlong = 0, forceAcross = 0;  // N
  double limitAlong = 0, limitAcross = 0;             // m, of the deflections
  double deflectionAlong = 0, deflectionAcross = 0;   // before they are cut
  glm::dvec3 water{0};                                // N, of water instead of all that
};

LandingGear::Point LandingGear::at(std::size_t i, const BodyState& state, double seconds) const {
  const GroundPatch& patch = patches_[i];
  const GearContact& contact = contacts_[i];
  const bool isWheel = i < kWheels, isTail = i == index(GearPoint::tailWheel);
  Point p;
  p.arm = state.orientation * kGearPlaces[i];
  const glm::dvec3 place = state.position + p.arm;
  const double scale = 1 / std::sqrt(1 + glm::dot(patch.gradient, patch.gradient));
  p.normal = glm::dvec3(-patch.gradient.x, 1, -patch.gradient.y) * scale;
  const double surface = patch.height + glm::dot(patch.gradient, glm::dvec2(place.x, place.z) - patch.at);
  p.compression = (surface - place.y) * scale;
  if (!(p.compression > 0)) return p;
  const glm::dvec3 velocity =
      state.velocity + state.orientation * glm::cross(state.angularVelocity, kGearPlaces[i]);
  p.closing = -glm::dot(velocity, p.normal);

  if (patch.water) {
    const Swimming swims = swimmingOf(i);
    const double depth = std::min(p.compression, swims.depth), wet = depth / swims.depth;
    const glm::dvec3 flat(velocity.x, 0, velocity.z);
    p.water = -0.5 * kWaterDensity * wet *
              (swims.along * glm::length(flat) * flat +
               glm::dvec3(0, swims.into * std::abs(velocity.y) * velocity.y, 0));
    // A hull in water is damped by the waves that it makes: as much as brings it to rest in a swing or two.
    p.water.y += swims.lift * depth - 0.4 * swims.lift * wet * velocity.y;
    p.water -= 0.1 * swims.lift * wet * flat;
    return p;
  }

  const double stiffness = isWheel ? (isTail ? 0.5 : 1.0) * settings_.stiffness : kHullStiffness;
  const double damping = isWheel ? settings_.damping : kHullDamping;
  p.force = stiffness * p.compression * std::max(1 + damping * p.closing, 0.0);

  // The wheel's own directions on the ground; where its nose points at the sky, any.
  glm::dvec3 ahead =
      state.orientation *
      (isTail ? glm::dvec3(-dmath::sin(steerRad_), 0, -dmath::cos(steerRad_)) : glm::dvec3(0, 0, -1));
  ahead -= p.normal * glm::dot(ahead, p.normal);
  const double length = glm::length(ahead);
  if (length > 0.05) {
    p.along = ahead / length;
  } else {
    const glm::dvec3 right = state.orientation * glm::dvec3(1, 0, 0);
    p.along = glm::normalize(glm::cross(p.normal, right - p.normal * glm::dot(right, p.normal)));
  }
  p.across = glm::cross(p.along, p.normal);
  p.velocityAlong = glm::dot(velocity, p.along);
  p.velocityAcross = glm::dot(velocity, p.across);

  const double most = isWheel ? settings_.friction * patch.grip : kHullFriction;
  const double brake = isTail ? 0 : settings_.brakeFriction * input_.brake;
  const double held = isWheel ? std::min(settings_.rollingResistance * patch.rolling + brake, most) : most;
  // Along: a deflection that gives way at `held`.
  p.limitAlong = held / kLocking;
  p.deflectionAlong = contact.deflectionAlong + seconds * p.velocityAlong;
  const double bent = p.deflectionAlong + kSwayDamping * p.velocityAlong;
  p.forceAlong = -p.force * kLocking * std::clamp(bent, -p.limitAlong, p.limitAlong);
  // Across: what friction is left.
  const double share = p.force > 0 ? p.forceAlong / (p.force * most) : 0;
  const double left = most * std::sqrt(std::max(1 - share * share, 0.0));
  if (isWheel) {
    const double slope = (isTail ? kTailCornering : kMainCornering) / kRelaxation;
    const double rolling = std::abs(p.velocityAlong);
    p.limitAcross = kMostDeflection * most / slope;
    p.deflectionAcross =
        (contact.deflectionAcross + seconds * p.velocityAcross) / (1 + seconds * rolling / kRelaxation);
    const double swayed = p.deflectionAcross + kSwayDamping * p.velocityAcross / (1 + rolling / kSwaySpeed);
    p.forceAcross = left > 0 ? -p.force * left * saturated(slope * swayed / left) : 0;
  } else {
    p.limitAcross = left / kLocking;
    p.deflectionAcross = contact.deflectionAcross + seconds * p.velocityAcross;
    const double swayed = p.deflectionAcross + kSwayDamping * p.velocityAcross;
    p.forceAcross = -p.force * kLocking * std::clamp(swayed, -p.limitAcross, p.limitAcross);
  }
  return p;
}

void LandingGear::lift() {
  contacts_ = {};
  loads_ = {};
  near_ = {};
  steerRad_ = 0;
}

void LandingGear::beginStep() {
  for (GearLoad& load : loads_) load.closingSpeed = load.slideSpeed = 0;
}

void LandingGear::meet(const BodyState& state, const GearInput& input, const GroundField& ground) {
  input_ = input;
  const glm::dvec3 forward = state.orientation * glm::dvec3(0, 0, -1);
  const double rolling = glm::dot(state.velocity, forward) / settings_.steeringSpeed;
  // Nose right: the tail wheel points left.
  steerRad_ = settings_.steeringDeg * dmath::kRadPerDeg * std::clamp(input.steer, -1.0, 1.0) /
              (1 + rolling * rolling);
  const GroundPatch below = ground({state.position.x, state.position.z});
  const double margin = kAskedWithin + kAskedSeconds * glm::length(state.velocity);
  for (std::size_t i = 0; i < kGearPoints; ++i) {
    near_[i] = false;
    if (broken_ && i < kWheels) continue;
    const glm::dvec3 place = state.position + state.orientation * kGearPlaces[i];
    const glm::dvec2 xz(place.x, place.z);
    const double over = place.y - below.height - glm::dot(below.gradient, xz - below.at);
    if (over > margin + 0.1 * glm::length(below.gradient)) continue;
    near_[i] = true;
    patches_[i] = ground(xz);
    velocities_[i] = state.velocity + state.orientation * glm::cross(state.angularVelocity, kGearPlaces[i]);
  }
}

Wrench LandingGear::wrench(const BodyState& state, double seconds) const {
  Wrench total;
  glm::dvec3 torque(0);  // world axes
  for (std::size_t i = 0; i < kGearPoints; ++i) {
    if (!near_[i]) continue;
    const Point p = at(i, state, seconds);
    if (!(p.compression > 0)) continue;
    const glm::dvec3 force = p.normal * p.force + p.along * p.forceAlong + p.across * p.forceAcross + p.water;
    total.force += force;
    torque += glm::cross(p.arm, force);
  }
  total.torque = glm::conjugate(state.orientation) * torque;
  return total;
}

void LandingGear::settle(const BodyState& state, double seconds) {
  for (std::size_t i = 0; i < kGearPoints; ++i) {
    GearContact& contact = contacts_[i];
    GearLoad load{.closingSpeed = loads_[i].closingSpeed, .slideSpeed = loads_[i].slideSpeed};
    if (near_[i]) {
      const Point p = at(i, state, seconds);
      if (p.compression > 0) {
        load.compression = p.compression;
        load.slope = glm::length(patches_[i].gradient);
        load.water = patches_[i].water;
        if (!contact.touching) {
          load.closingSpeed = std::max(-glm::dot(velocities_[i], p.normal), p.closing);
          load.slideSpeed = glm::length(velocities_[i] - p.normal * glm::dot(velocities_[i], p.normal));
        }
        load.force = p.force;
        load.side = p.forceAcross;
        contact.touching = true;
        contact.deflectionAlong = std::clamp(p.deflectionAlong, -p.limitAlong, p.limitAlong);
        contact.deflectionAcross = std::clamp(p.deflectionAcross, -p.limitAcross, p.limitAcross);
        loads_[i] = load;
        continue;
      }
    }
    contact = {};
    loads_[i] = load;
  }
}

double LandingGear::springEnergy() const {
  double energy = 0;
  for (std::size_t i = 0; i < kGearPoints; ++i) {
    if (loads_[i].water) continue;
    const double x = loads_[i].compression;
    const double k =
        i >= kWheels ? kHullStiffness : (i == index(GearPoint::tailWheel) ? 0.5 : 1.0) * settings_.stiffness;
    energy += 0.5 * k * x * x;
  }
  return energy;
}

bool LandingGear::touches() const {
  return std::any_of(contacts_.begin(), contacts_.end(), [](const GearContact& c) { return c.touching; });
}

int LandingGear::wheelsDown() const {
  int down = 0;
  for (std::size_t i = 0; i < kWheels; ++i) down += contacts_[i].touching && !loads_[i].water ? 1 : 0;
  return down;
}

double LandingGear::borne(double weight) const {
  double force = 0;
  for (std::size_t i = 0; i < kWheels; ++i) force += loads_[i].force;
  return std::clamp(force / weight, 0.0, 1.0);
}

}  // namespace skydrop::flight
