// Flashes of lightning: when and where, how bright at a moment, and along which channel. Pure functions of
// settings, seed, time and place, the same bits on every machine; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/weather/lightning_settings.h"
#include "skydrop/weather/moment.h"

namespace skydrop::weather {

inline constexpr double kLightningSightM = 20000;  // level distance from which a flash is seen and heard

// Time is cut into slots. In each, at most one flash begins within kLightningSightM of any place, in the
// slot's first kFlashStartS, and its strokes follow within kFlashStrokesS: between the last stroke of one
// flash and the first of the next is at least a second, so no second has more than kMostStrokes bright
// moments (WCAG 2.1, 2.3.1 allows three).
inline constexpr double kFlashSlotS = 1.5, kFlashStartS = 0.2, kFlashStrokesS = 0.3;
inline constexpr std::size_t kMostStrokes = 3;
// After its last stroke a flash is out within so much, whatever its softness.
inline constexpr double kLongestFadeS = 0.96;

struct Stroke {
  double afterS = 0;  // since the flash began, [0, kFlashStrokesS]
  double share = 0;   // of the flash's brightness at its peak, [0, 1]
};

struct Flash {
  double seconds = 0;      // simulated, when it begins
  std::uint64_t seed = 0;  // of its channel
  bool toGround = false;   // otherwise within the cloud
  glm::dvec3 from{0};      // where it begins, in the cloud, m
  glm::dvec3 to{0};        // where it ends; to.y of a stroke to ground is the sea's level
  double cloudBaseM = 0;   // of its cloud, above the sea
  double strength = 1;     // of its peak, against that of the usual one, [0.5, 2]
  std::array<Stroke, kMostStrokes> strokes{};
  std::size_t strokeCount = 0;  // at least 1
};

// The flashes that begin after `from` and not after `to` (simulated seconds, finite, any sign) within
// kLightningSightM of a place (x east, z south), in the order of time. None without weather. The rate is
// State::lightningPerMinute where the flash stands, in the mean over long times, up to 31 a minute; there is
// none where there is no layer of clouds. Flashes stand on a lattice of 2 kLightningSightM that is moved to
// another place in each slot: so no two of a slot are within sight of one place.
std::vector<Flash> flashesBetween(const Moment& moment, const LightningSettings& settings, double from,
                                  double to, const glm::dvec2& place);

// The one that shines at a moment, if any: at most one does within sight.
std::vector<Flash> flashesShining(const Moment& moment, const LightningSettings& settings, double seconds,
                                  const glm::dvec2& place);

// Brightness of a flash at a moment, of the usual one's peak: rises within milliseconds, and falls
// exponentially after each stroke; the eye, which integrates over about a tenth of a second (Bloch's law),
// makes that of strokes that last less than one. 0 before it begins and after its end.
double brightnessAt(const Flash& flash, const LightningSettings& settings, double seconds);

// Luminous intensity of the usual flash at its peak, kcd: 4e5 J of light a stroke (Guo and Krider 1982) are
// about 5e7 lm s, which an eye spreads over kFlashDecayS.
inline constexpr double kFlashIntensityKcd = 5e4;
inline constexpr double kFlashDecayS = 0.08;

// A straight piece of a channel.
struct ChannelPiece {
  glm::dvec3 from{0}, to{0};  // world, m
  double share = 1;           // of the brightness of the main channel, a metre
};

struct Channel {
  static constexpr std::size_t kLights = 8;
  std::vector<ChannelPiece> pieces;          // the main channel first, from its beginning; then branches
  std::size_t mainPieces = 0;                // of these
  std::array<glm::dvec3, kLights> lights{};  // middles of equal parts of the main channel
  double mainLengthM = 0;
};

// The channel of a flash above ground of this height: midpoint displacement (Fournier, Fussell and Carpenter
// 1982) with branches that leave at 15 to 50 degrees, are dimmer and taper off (Reed and Wyvill 1994). At
// most kMostPieces; no branch ends below the ground.
inline constexpr std::size_t kMostPieces = 640;
Channel channelOf(const Flash& flash, double groundM);

}  // namespace skydrop::weather
