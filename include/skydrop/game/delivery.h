// What a package earned, and why one missed: the record of each landing. Nothing here decides the future of a
// flight, so none of it is part of the state's digest. Values; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::game {

// The tuned numbers. describe() states and enforces the ranges.
struct DeliverySettings {
  double mostPoints = 1000;       // points, 1 .. 100000: of a package in the centre at once
  double edgeShare = 0.25;        // 1, 0 .. 1: of that, at the edge of the target
  double fadeSeconds = 60;        // s, 1 .. 3600: beyond the way there, after which half of it is left
  bool startFacesTarget = false;  // the flight begins, and begins again (R), with the target ahead
};

void describe(core::SettingsVisitor& visitor, DeliverySettings& settings);

// Whether every number is finite and within what the points need (no negative one, a positive fade).
bool isUsable(const DeliverySettings& settings);

// Points of a package that landed `distanceM` from the centre of a target of `radiusM`, `seconds` after the
// target was drawn, which takes `waySeconds` to fly to:
//
//   mostPoints (1 - (1 - edgeShare) d / r) T / (T + t),    T = fadeSeconds + waySeconds
//
// rounded to a whole number; 0 outside. Never more for a greater distance or a longer time. What is not
// finite, or negative, earns nothing (a negative way counts as none).
std::int64_t pointsOf(const DeliverySettings& settings, double distanceM, double radiusM, double seconds,
                      double waySeconds);

enum class MissReason { none, tooEarly, tooLate, left, right, wind, away };
inline constexpr std::array<std::string_view, 7> kMissReasonNames = {"none",  "tooEarly", "tooLate", "left",
                                                                     "right", "wind",     "away"};

struct Delivery {
  std::uint32_t package = 0, target = 0;  // numbers of the run, from 1
  std::uint64_t step = 0;                 // of the world when it landed
  bool hit = false, onWater = false;
  double distanceM = 0;  // from the target's centre, horizontal
  double radiusM = 0;    // of the target
  double seconds = 0;    // from when the target was drawn until the landing
  double fallSeconds = 0;
  double alongM = 0;   // beyond the centre on the path that was flown at the release; negative before it
  double acrossM = 0;  // right of that path
  double windM = 0;    // by which the wind moved the landing
  MissReason reason = MissReason::none;
  std::int64_t points = 0;
};
inline constexpr std::size_t kMostDeliveries = 256;

// Why it missed. `path`: the horizontal velocity at the release, m/s; below 1 m/s there is none, and a miss
// is just away. `miss`: from the centre to the landing; `stillMiss`: to where it would have landed in still
// air. x is east, y is south.
MissReason missReason(const glm::dvec2& path, const glm::dvec2& miss, const glm::dvec2& stillMiss,
                      double radiusM);

// For the player: "On target, 12 m from the centre: 840 points", "Missed by 30 m: dropped too early".
std::string sentenceOf(const Delivery& delivery);
// The reason alone: "too early"; empty for a hit.
std::string_view reasonText(MissReason reason);

}  // namespace skydrop::game
