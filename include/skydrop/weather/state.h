// The state of the air at one place and moment: what render draws, flight feels and audio plays. A plain
// value; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "skydrop/weather/layer_look.h"

namespace skydrop::weather {

// The ten genera of the International Cloud Atlas (WMO 2017).
enum class Genus {
  stratus,
  stratocumulus,
  cumulus,
  altostratus,
  altocumulus,
  cirrus,
  cirrostratus,
  cirrocumulus,
  nimbostratus,
  cumulonimbus
};
inline constexpr std::array<std::string_view, 10> kGenusNames = {
    "stratus", "stratocumulus", "cumulus",      "altostratus",  "altocumulus",
    "cirrus",  "cirrostratus",  "cirrocumulus", "nimbostratus", "cumulonimbus"};

inline constexpr std::size_t kLayers = 4;      // of clouds, at most
inline constexpr std::size_t kWindLevels = 3;  // of the wind in the free air

struct Layer {
  Genus genus = Genus::cumulus;
  double baseM = 1555;  // above the sea
  double topM = 3355;   // above the sea, above the base
  double cover = 0;     // share of the sky, [0, 1]; 0: there is none
  double density = 1;   // of the genus's usual density, [0, 4]
  LayerLook look = {};  // by which its medium departs from the genus's; heights and cover have theirs

  bool operator==(const Layer&) const = default;
};

struct WindLevel {
  double heightM = 0;       // above the sea
  double speedMps = 0;      // >= 0
  double directionDeg = 0;  // by compass where it comes from, [0, 360)

  bool operator==(const WindLevel&) const = default;
};

// Near the ground by the logarithmic law, up to the gradient height; above it between levels
// (wind_profile.h).
struct Wind {
  double speedMps = 0;                          // 10 m above the ground, >= 0
  double directionDeg = 0;                      // there, by compass where it comes from, [0, 360)
  double gustMps = 0;                           // by which the strongest gusts there exceed it, >= 0
  double roughnessM = 0.05;                     // roughness length of the ground, > 0
  double gradientHeightM = 300;                 // where the ground no longer slows it, > 10
  std::array<WindLevel, kWindLevels> levels{};  // heights ascend, from above the gradient height

  bool operator==(const Wind&) const = default;
};

struct Fog {
  double extinction = 0;  // 1/m at the ground; 0: there is none
  double topM = 60;       // above the sea

  bool operator==(const Fog&) const = default;
};

// Water equivalent in mm/h on the ground.
struct Precipitation {
  double rain = 0, snow = 0, sleet = 0, hail = 0;

  bool operator==(const Precipitation&) const = default;
};

struct State {
  Wind wind;
  std::array<Layer, kLayers> layers{};
  Fog fog;
  Precipitation precipitation;
  double visibilityM = 30000;     // meteorological optical range, > 0
  double temperatureC = 15;       // at the sea's level
  double pressurePa = 101325;     // at the sea's level
  double lightningPerMinute = 0;  // flashes within sight
  // Of turbulence above 2000 ft: the exponent of the probability that its intensity is exceeded, 10^-x
  // (MIL-F-8785C, figure 7). 0 none, 2 light, 3 moderate, 5 severe; [0, 6].
  double turbulenceSeverity = 0;

  bool operator==(const State&) const = default;
};

// Throws core::RangeError that names the place within the state ("layers.1: ...") and the reason, unless
// every number is finite and in its range, no layer is upside down and the levels of the wind ascend.
void requireUsable(const State& state);

// The state a share [0, 1] of the way from one to another, in space or time; clamped, 0 and 1 give the ends.
// Numbers are mixed; directions turn the shorter way round, clockwise where both are as long, and a calm has
// none: the turn is weighed by the speeds. A layer that changes its genus goes before the other comes; one
// that has no cover on one side keeps the place that it has on the other.
State mixed(const State& from, const State& to, double share);

// The direction a share of the way, turned the shorter way, with speeds as weights. Degrees, [0, 360).
double mixedDirection(double fromDeg, double fromSpeed, double toDeg, double toSpeed, double share);

}  // namespace skydrop::weather
