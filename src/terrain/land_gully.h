// What water carves: stripes of ridges and gullies that run down the slope of the coarser land. Each node of
// a lattice has a wave of its own, whose crests lie along the slope there; between nodes the four waves blend
// with the fade of the noise. An octave is steered by the land with all coarser octaves on it, so small
// gullies run into large ones and valleys branch. (The idea of noise whose stripes follow the slope: Clay
// John, "Eroded Terrain Noise", 2020. Waves that are fixed at nodes keep the gradient of the height exact.)
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "terrain/jet.h"
#include "terrain/lattice_noise.h"

namespace skydrop::terrain {

struct GullyOctave {
  double cell;    // of its lattice, metres: a power of two
  double metres;  // height of its ridges over the middle of the slope, at strength 1
};
// The coarsest first. The finest cell is not shorter than the sample distance of the coarsest chunk, so a
// chunk of any level is made of waves that blend, never of nodes between its samples.
inline constexpr std::array<GullyOctave, 4> kGullies{{{2048, 150}, {1024, 62}, {512, 27}, {256, 11}}};

// Ridges a cell; how much the direction of a wave may leave that of the slope; the slope at which gullies
// have half their depth; and how deep they may then get.
inline constexpr double kGulliesPerCell = 1.5;
inline constexpr double kGullyWander = 0.3;
inline constexpr double kGullySlope = 0.3;
inline constexpr double kGullyDepth = 1.3;
// How much narrower ridges are than valleys (below 1/2, or valleys get a second ridge), and how high a crest
// then is; what the power of waves that cancel is taken for.
inline constexpr double kGullySharpness = 0.3;
inline constexpr double kGullyCrest = 1 + 0.5 * kGullySharpness;
inline constexpr double kGullyFloor = 0.12;

template <class R>
struct GullyNode {
  R turnsX, turnsZ;  // turns of the wave a cell
  R phase;           // turns, at the node
  R amplitude;       // 0 .. kGullyDepth * strength
};

// The node whose random bits these are, where the land rises by (x, z) a metre.
template <class R>
SKYDROP_INLINE GullyNode<R> gullyNode(std::uint64_t bits, R x, R z, R strength) {
  const R slope2 = x * x + z * z;
  const R slope = std::sqrt(slope2 + R(1e-12));
  // Where the land is flat a direction means nothing: there the wave grows longer and its height is 0 anyway.
  const R perSlope = R(kGulliesPerCell) / std::sqrt(slope2 + R(4e-4));
  const R wander =
      (static_cast<R>(static_cast<std::int32_t>(bits & 0xffff)) * R(0x1p-16) - R(0.5)) * R(kGullyWander);
  const R along = R(1) - R(0.5) * wander * wander;
  return {(z * R(-1) * along - x * wander) * perSlope, (x * along - z * wander) * perSlope,
          static_cast<R>(static_cast<std::int32_t>(bits >> 40) & 0xffffff) * R(0x1p-24),
          strength * slope / (slope + R(kGullySlope)) * R(kGullyDepth)};
}

// A wave of period 1 between -1 and 1: two smooth steps, of which a cosine differs by 0.01.
template <class R>
SKYDROP_INLINE Slope<R> gullyWave(R turns) {  // -4 < turns < 4
  const R shifted = turns + R(4);
  const R t = shifted - static_cast<R>(static_cast<std::int32_t>(shifted)) - R(0.5);
  const R x = R(2) * (t < R(0) ? -t : t);
  const R slope = R(24) * x * (R(1) - x);
  return {R(1) - x * x * (R(6) - R(4) * x), t < R(0) ? slope : -slope};
}

// A node of a cell, seen from a row of samples in it.
template <class R>
struct GullyCorner {
  R phase;  // turns at the west edge of the cell, in this row
  R turnsX, turnsZ, amplitude;
};
template <class R>
SKYDROP_INLINE GullyCorner<R> gullyCorner(const GullyNode<R>& node, bool east, bool south, R w) {
  return {node.phase + node.turnsZ * (south ? w - R(1) : w) - (east ? node.turnsX : R(0)), node.turnsX,
          node.turnsZ, node.amplitude};
}

// A place between nodes along one axis: cells from the first, its fade and the fade's slope.
template <class R>
struct FadePlace {
  R at, fade, slope;
};

// What four waves make together, without regard to their height: where they stand against each other they
// would cancel, so their sum is brought back to a wave of full height by the sum of their quadratures. (Rune
// Skovbo Johansen, "Phacelle noise", 2025.) Value within -1 .. kGullyCrest and derivatives in cells.
template <class R>
SKYDROP_INLINE Jet<R> gullyBlend(const GullyCorner<R>& northWest, const GullyCorner<R>& northEast,
                                 const GullyCorner<R>& southWest, const GullyCorner<R>& southEast,
                                 const FadePlace<R>& x, const FadePlace<R>& z) {
  struct Column {
    Jet<R> wave, quadrature, height;
  };
  const auto column = [&](const GullyCorner<R>& north, const GullyCorner<R>& south) SKYDROP_INLINE_LAMBDA {
    const auto blend = [&](const Slope<R>& n, const Slope<R>& s) SKYDROP_INLINE_LAMBDA {
      const R dn = (R(1) - z.fade) * n.slope, ds = z.fade * s.slope;
      return Jet<R>{n.value + z.fade * (s.value - n.value), dn * north.turnsX + ds * south.turnsX,
                    z.slope * (s.value - n.value) + dn * north.turnsZ + ds * south.turnsZ};
    };
    const R n = north.phase + north.turnsX * x.at, s = south.phase + south.turnsX * x.at;
    return Column{blend(gullyWave(n), gullyWave(s)), blend(gullyWave(n - R(0.25)), gullyWave(s - R(0.25))),
                  Jet<R>{north.amplitude + z.fade * (south.amplitude - north.amplitude), R(0),
                         z.slope * (south.amplitude - north.amplitude)}};
  };
  const Column west = column(northWest, southWest), east = column(northEast, southEast);
  const auto across = [&](const Jet<R>& a, const Jet<R>& b) SKYDROP_INLINE_LAMBDA {
    return Jet<R>{a.v + x.fade * (b.v - a.v), a.x + x.fade * (b.x - a.x) + x.slope * (b.v - a.v),
                  a.z + x.fade * (b.z - a.z)};
  };
  const Jet<R> wave = across(west.wave, east.wave), quadrature = across(west.quadrature, east.quadrature);
  const R power = wave.v * wave.v + quadrature.v * quadrature.v + R(kGullyFloor);
  const R scale = R(1) / std::sqrt(power), perPower = scale / power;
  const R full = wave.v * scale;
  const Jet<R> stripe{full,
                      wave.x * scale - wave.v * (wave.v * wave.x + quadrature.v * quadrature.x) * perPower,
                      wave.z * scale - wave.v * (wave.v * wave.z + quadrature.v * quadrature.z) * perPower};
  // Ridges narrower than the valleys between them.
  const R sharp = R(1) + R(2 * kGullySharpness) * full;
  return Jet<R>{full * (R(1) + R(kGullySharpness) * full) - R(0.5 * kGullySharpness), stripe.x * sharp,
                stripe.z * sharp} *
         across(west.height, east.height);
}

}  // namespace skydrop::terrain
