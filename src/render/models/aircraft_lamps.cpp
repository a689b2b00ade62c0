#include "skydrop/render/models/aircraft_lamps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace skydrop::render {
namespace {

// Body axes of airplane.glb, m: outside the wing tips, behind the rudder, on top of the fin, in the cabin's
// roof.
constexpr glm::dvec3 kLeftTip{-5.50, 1.26, -0.33}, kRightTip{5.50, 1.26, -0.33}, kTail{0, 0.33, 5.32},
    kFinTop{0, 1.86, 4.45}, kCabinRoof{0, 0.92, 0.1};
constexpr glm::dvec3 kStrobeAside{0, 0, 0.16};  // behind the position light

constexpr double kHalfForwardSector = 110, kHalfTailSector = 70;  // degrees
constexpr double kStrobePeak = 400, kBeaconPeak = 200;            // cd
constexpr double kPulseS = 0.06, kBeaconS = 0.16, kPulseGapS = 0.16;

// cd, of light that falls on the aircraft: the sides of lenses send out less than their fronts.
constexpr double kSideShare = 0.2;
// Of a lamp a metre away, on a white surface, after exposure.
constexpr double kMostShown = 0.45;
constexpr double kCabinIntensity = 0.15;  // cd, of a lamp that is turned down for the night

// Of luminance 1: aviation red, green and white (FAR 23.1397), as far as sRGB has them.
glm::dvec3 ofLuminance1(const glm::dvec3& color) {
  return color / glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double between(double x, double a, double b, double at, double bt) {
  return at + (bt - at) * std::clamp((x - a) / (b - a), 0.0, 1.0);
}

// A pulse around the middle, 1 at its peak and 0 from half its width on.
double pulse(double seconds, double width) {
  const double x = std::abs(seconds) / (0.5 * width);
  return x < 1 ? (1 - x * x) * (1 - x * x) : 0;
}

}  // namespace

double forwardLightIntensity(double fromAheadDegrees, double outsideDegrees) {
  if (outsideDegrees > 0) {
    const double edge = fromAheadDegrees < kHalfForwardSector ? 10 : 5;  // overlap ahead, or cut off behind
    return outsideDegrees < 10 ? between(outsideDegrees, 0, 10, edge, 1) : 1;
  }
  if (fromAheadDegrees <= 10) return 40;
  if (fromAheadDegrees <= 20) return between(fromAheadDegrees, 10, 20, 40, 30);
  return between(fromAheadDegrees, 20, 30, 30, 5);
}

double tailLightIntensity(double outsideDegrees) {
  if (outsideDegrees <= 0) return 20;
  return outsideDegrees < 10 ? between(outsideDegrees, 0, 10, 20, 1) : 1;
}

double verticalShare(double elevationDegrees) {
  struct Row {
    double degrees, share;
  };
  constexpr std::array<Row, 8> kRows = {
      {{0, 1}, {5, 0.9}, {10, 0.8}, {15, 0.7}, {20, 0.5}, {30, 0.3}, {40, 0.1}, {90, 0.05}}};
  const double angle = std::abs(elevationDegrees);
  for (std::size_t i = 1; i < kRows.size(); ++i) {
    if (angle <= kRows[i].degrees)
      return between(angle, kRows[i - 1].degrees, kRows[i].degrees, kRows[i - 1].share, kRows[i].share);
  }
  return kRows.back().share;
}

double flashPhase(double simulatedSeconds, double flashesPerMinute) {
  const double turns = simulatedSeconds * flashesPerMinute / 60;
  return std::isfinite(turns) ? turns - std::floor(turns) : 0;
}

double strobeShare(double phase, double periodS) {
  const double seconds = phase * periodS;
  return pulse(seconds - 0.1, kPulseS) + pulse(seconds - 0.1 - kPulseGapS, kPulseS);
}

double beaconShare(double phase, double periodS) { return pulse((phase - 0.5) * periodS, kBeaconS); }

std::vector<LitLamp> litLamps(const game::AircraftSnapshot& aircraft, const AircraftLightsSettings& settings,
                              double simulatedSeconds, const glm::dvec3& eye) {
  if (!aircraft.present || aircraft.crashed || settings.brightness <= 0) return {};
  const glm::dvec3 red = ofLuminance1({1, 0.05, 0.02}), green = ofLuminance1({0.04, 1, 0.32}),
                   white = ofLuminance1({1, 0.96, 0.88});
  const glm::dquat toBody = glm::conjugate(aircraft.orientation);
  const double phase = flashPhase(simulatedSeconds, settings.flashesPerMinute);
  const double periodS = 60 / settings.flashesPerMinute;
  std::vector<LitLamp> lamps;
  const auto add = [&](std::string_view name, const glm::dvec3& place, const glm::dvec3& color, double cd,
                       double onAircraft) {
    if (cd <= 0 && onAircraft <= 0) return;
    lamps.push_back({name, aircraft.position + aircraft.orientation * place, color, cd * settings.brightness,
                     onAircraft * settings.brightness});
  };
  // Of the direction to the eye from a lamp: degrees right of the nose, and above the level of the wings.
  const auto bearing = [&](const glm::dvec3& place) {
    const glm::dvec3 to = toBody * (eye - aircraft.position) - place;
    const double level = std::hypot(to.x, to.z);
    return glm::dvec2(glm::degrees(std::atan2(to.x, -to.z)), glm::degrees(std::atan2(to.y, level)));
  };
  for (const bool left : {true, false}) {
    const glm::dvec3 place = left ? kLeftTip : kRightTip;
    const glm::dvec2 at = bearing(place);
    const double side = left ? -at.x : at.x;  // 0 ahead, 110 at the sector's rear edge, negative across
    const double outside =
        side < 0 ? std::min(-side, side + 360 - kHalfForwardSector) : side - kHalfForwardSector;
    const double cd = forwardLightIntensity(std::abs(side), outside) * verticalShare(at.y);
    add(left ? "left" : "right", place, left ? red : green, cd, 40 * kSideShare);
  }
  const glm::dvec2 tail = bearing(kTail);
  add("tail", kTail, white,
      tailLightIntensity(180 - std::abs(tail.x) - kHalfTailSector) * verticalShare(tail.y), 20 * kSideShare);
  const double beacon = kBeaconPeak * beaconShare(phase, periodS);
  add("beacon", kFinTop, red, beacon, beacon);
  if (settings.strobes) {
    const double strobe = kStrobePeak * strobeShare(phase, periodS);
    add("leftStrobe", kLeftTip + kStrobeAside, white, strobe, strobe * kSideShare);
    add("rightStrobe", kRightTip + kStrobeAside, white, strobe, strobe * kSideShare);
  }
  return lamps;
}

LitLamp cabinLamp(const game::AircraftSnapshot& aircraft, const AircraftLightsSettings& settings) {
  const double cd = aircraft.crashed ? 0 : kCabinIntensity * settings.cabinBrightness;
  return {"cabin", aircraft.position + aircraft.orientation * kCabinRoof, ofLuminance1({1, 0.45, 0.16}), 0,
          cd};
}

bool isInsideCabin(const game::AircraftSnapshot& aircraft, const glm::dvec3& place) {
  const glm::dvec3 at = glm::conjugate(aircraft.orientation) * (place - aircraft.position);
  return glm::all(glm::greaterThan(at, kCabinLow)) && glm::all(glm::lessThan(at, kCabinHigh));
}

ModelLamps lampsOnModel(const View& view, std::span<const LitLamp> lamps, double exposure) {
  ModelLamps result;
  std::size_t i = 0;
  for (const LitLamp& lamp : lamps) {
    if (i == ModelLamps::kMost) break;
    if (lamp.towardsAircraft <= 0) continue;
    const double light = lamp.towardsAircraft * 1e-3 * exposure;
    const double shown = light / (1 + light / (kMostShown * std::numbers::pi));
    result.places[i] = glm::vec4(relativeToEye(view, lamp.position), 1);
    result.lights[i] = glm::vec4(glm::vec3(lamp.color * shown), 0);
    ++i;
  }
  return result;
}

}  // namespace skydrop::render
