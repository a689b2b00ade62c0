#include "game/ground_handling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "game/ground_surface.h"
#include "game/steps.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/flight/environment.h"
#include "skydrop/flight/rotation.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;
using flight::GearPoint;

// In the air for so long after the wheels left, the aircraft flies again.
constexpr double kTakenOffSeconds = 1.5;
// Slower than this, with the thrust lever home, the brakes hold by themselves, m/s.
constexpr double kHoldSpeed = 0.5;
// Brakes do nothing at the first pitch and all at the second, radians: or they put it on its nose.
constexpr double kBrakesFromRad = -0.05, kBrakesToRad = 0.12;
constexpr double kMessageSeconds = 3;
// Ground is met faster than this, m/s, or its slope breaks nothing.
constexpr double kSlopeSpeed = 5;
// Lying on its back: the height of the body's up axis.
constexpr double kTurnedOver = -0.2;

constexpr std::array<const char*, flight::kGearPoints> kPartNames = {
    "left wheel", "right wheel", "tail wheel", "propeller", "nose", "belly",       "tail",
    "left wing",  "right wing",  "tailplane",  "tailplane", "fin",  "cabin's roof"};

template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 160> out{};
  std::snprintf(out.data(), out.size(), format, values...);
  return out.data();
}

}  // namespace

void GroundHandling::start(bool onWheels) {
  gear_.lift();
  gear_.mend();
  idles_ = grounded_ = onWheels;
  wrecked_ = false;
  airborneSteps_ = swimSteps_ = 0;
  brakes_ = 0;
}

flight::AirplaneInput GroundHandling::levers(const Controls& c) const {
  if (wrecked_ || swims()) return {.idles = true};
  return {
      .thrust = c.thrust, .brake = c.brake, .pitch = c.pitch, .roll = c.roll, .yaw = c.yaw, .idles = idles_};
}

std::optional<Damage> GroundHandling::step(flight::Airplane& airplane, const Controls& controls,
                                           const flight::AirMass& air, const terrain::HeightSource& ground,
                                           EventLog& eventLog) {
  const flight::BodyState& body = airplane.body().state();
  const bool isFree = wrecked_ || swims();
  flight::GearInput wheels;
  wheels.steer = isFree ? 0 : controls.yaw;
  const double pitch = flight::attitudeOf(body.orientation).pitchRad;
  const double slow = glm::length(body.velocity);
  const bool holds = slow < kHoldSpeed && controls.thrust == 0;
  const double wanted = isFree ? 1 : std::max(controls.brake, holds ? 1.0 : 0.0);
  wheels.brake = wanted * std::clamp((pitch - kBrakesFromRad) / (kBrakesToRad - kBrakesFromRad), 0.0, 1.0);
  const double roughness = gear_.settings().groundRoughness;
  airplane.stepOnGround(levers(controls), air, core::FixedStep::kStepSeconds, gear_, wheels,
                        [&](const glm::dvec2& xz) { return groundPatchAt(ground, xz, roughness); });
  brakes_ = gear_.wheelsDown() > 0 ? wheels.brake : 0;

  std::optional<Damage> damage;
  if (!isFree) damage = damageOf(airplane);
  double sink = 0;
  bool wet = false;
  for (const flight::GearLoad& load : gear_.loads()) {
    sink = std::max(sink, load.closingSpeed);
    wet = wet || load.water;
  }
  if (swims()) {
    ++swimSteps_;
  } else if (wet && !damage && !wrecked_) {
    swimSteps_ = 1;
    const glm::dvec3& at = airplane.body().position();
    eventLog.report({.kind = GameEventKind::ditched, .position = at, .onWater = true, .sinkRate = sink});
    eventLog.say("Ditched: the aircraft floats", gear_.settings().floatSeconds);
  }
  if (!wet) noteWheels(controls, airplane.body().position(), sink, eventLog);
  return damage;
}

void GroundHandling::leave(const Controls& controls, const glm::dvec3& position, EventLog& eventLog) {
  gear_.lift();
  brakes_ = 0;
  noteWheels(controls, position, 0, eventLog);
}

void GroundHandling::noteWheels(const Controls& controls, const glm::dvec3& position, double sinkRate,
                                EventLog& eventLog) {
  if (gear_.wheelsDown() > 0) {
    if (!grounded_) {
      eventLog.report({.kind = GameEventKind::touchedDown, .position = position, .sinkRate = sinkRate});
      if (!wrecked_) eventLog.say(text("Touched down, sinking at %.1f m/s", sinkRate), kMessageSeconds);
      grounded_ = true;
    }
    idles_ = true;
    airborneSteps_ = 0;
    return;
  }
  ++airborneSteps_;
  if (controls.thrust > 0 || airborneSteps_ > stepsOf(kTakenOffSeconds)) idles_ = false;
  if (grounded_ && airborneSteps_ > stepsOf(kTakenOffSeconds)) {
    grounded_ = false;
    eventLog.report({.kind = GameEventKind::tookOff, .position = position});
  }
}

std::optional<Damage> GroundHandling::damageOf(const flight::Airplane& airplane) const {
  const flight::GearSettings& s = gear_.settings();
  const flight::BodyState& body = airplane.body().state();
  const double weight = airplane.settings().mass * flight::kGravity;
  double side = 0;
  bool onGround = false;
  for (std::size_t i = 0; i < flight::kGearPoints; ++i) {
    const flight::GearLoad& load = gear_.loads()[i];
    if (!gear_.contacts()[i].touching) continue;
    const char* part = kPartNames[i];
    if (load.water) {
      if (swims() || load.closingSpeed <= 0) continue;
      if (load.closingSpeed > s.mostWaterSink)
        return Damage{text("Broke up on the water: met it at %.1f m/s (limit %.1f)", load.closingSpeed,
                           s.mostWaterSink),
                      true, true};
      if (load.slideSpeed > s.mostWaterSpeed)
        return Damage{text("Broke up on the water: too fast at %.0f m/s (limit %.0f)", load.slideSpeed,
                           s.mostWaterSpeed),
                      true, true};
      continue;
    }
    onGround = true;
    if (i >= flight::kWheels) {
      const double speed =
          std::sqrt(load.closingSpeed * load.closingSpeed + load.slideSpeed * load.slideSpeed);
      if (speed > s.mostStrikeSpeed)
        return Damage{
            text("The %s struck the ground at %.0f m/s (limit %.0f)", part, speed, s.mostStrikeSpeed)};
      if (i == static_cast<std::size_t>(GearPoint::propeller) && airplane.throttle() > 0.05)
        return Damage{"The propeller struck the ground"};
      continue;
    }
    if (load.closingSpeed > s.mostSinkRate)
      return Damage{text("The gear broke: the %s met the ground at %.1f m/s (limit %.1f)", part,
                         load.closingSpeed, s.mostSinkRate),
                    true};
    if (load.slideSpeed > kSlopeSpeed && load.slope > dmath::tan(s.mostSlopeDeg * dmath::kRadPerDeg))
      return Damage{text("The gear broke: too steep a ground, %.0f degrees (limit %.0f)",
                         dmath::atan2(load.slope, 1) / dmath::kRadPerDeg, s.mostSlopeDeg),
                    true};
    side += load.side;
  }
  if (std::abs(side) > s.mostSideLoad * weight)
    return Damage{text("The gear broke: %.1f weights across the wheels (limit %.1f)", std::abs(side) / weight,
                       s.mostSideLoad),
                  true};
  if (onGround && (body.orientation * glm::dvec3(0, 1, 0)).y < kTurnedOver) return Damage{"Turned over"};
  return {};
}

void GroundHandling::wreck(bool legs) {
  wrecked_ = true;
  if (legs) gear_.breakLegs();
}

void GroundHandling::fill(GearSnapshot& out, const flight::BodyState& body,
                          const terrain::HeightSource& ground) const {
  out.present = true;
  out.wheelsDown = gear_.wheelsDown();
  out.brakes = brakes_;
  out.groundSpeedMps = std::sqrt(body.velocity.x * body.velocity.x + body.velocity.z * body.velocity.z);
  out.swims = swims();
  if (out.wheelsDown > 0) {
    if (const terrain::Strips* strips = ground.strips())
      out.onStrip = strips->at({body.position.x, body.position.z}).has_value();
  }
}

void GroundHandling::addTo(core::StateHasher& h) const {
  for (const flight::GearContact& contact : gear_.contacts()) {
    h.add(contact.deflectionAlong), h.add(contact.deflectionAcross), h.add(std::uint64_t{contact.touching});
  }
  // What the next step reads of the last: how much the wheels bear, and whether they are down.
  for (const flight::GearLoad& load : gear_.loads()) h.add(load.force), h.add(std::uint64_t{load.water});
  h.add(std::uint64_t{gear_.broken()}), h.add(std::uint64_t{idles_}), h.add(std::uint64_t{grounded_});
  h.add(std::uint64_t{wrecked_}), h.add(airborneSteps_), h.add(swimSteps_);
}

}  // namespace skydrop::game
