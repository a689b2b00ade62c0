// What a pilot, a key map, the autopilot or an input log hands to one step of the world. Plain data.
#pragma once

#include <cstdint>

namespace skydrop::game {

// Axes in [-1, 1], levers in [0, 1]; anything else is clamped, NaN is read as 0 (Guard::notFiniteControl).
struct Controls {
  double thrust = 0;   // 0..1: key W. Pulls the throttle from cruise towards full
  double brake = 0;    // 0..1: key S. Pulls the throttle from cruise towards idle
  double pitch = 0;    // +1 nose up (down arrow)
  double roll = 0;     // +1 right wing down (D, right arrow)
  double yaw = 0;      // +1 nose right (E)
  bool drop = false;   // a package leaves when this turns true
  bool reset = false;  // the aircraft goes back to its start when this turns true

  bool operator==(const Controls&) const = default;
};

// The values that a log can hold: every axis and lever a multiple of 1/127. World::step rounds what it is
// given in this way, so a flight and its replay see the same bits. Idempotent.
Controls quantised(const Controls& controls);

// The quantised form as integers, -127..127 (levers 0..127).
struct QuantisedControls {
  std::int8_t thrust = 0, brake = 0, pitch = 0, roll = 0, yaw = 0;
  bool drop = false, reset = false;

  bool operator==(const QuantisedControls&) const = default;
};
QuantisedControls quantise(const Controls& controls);
Controls dequantise(const QuantisedControls& controls);

}  // namespace skydrop::game
