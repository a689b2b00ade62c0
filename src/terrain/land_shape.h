// The shape of the land: how octaves of noise become continents, ranges, valleys and plains. Written once
// over a number type N: Jet<float> in the row kernels, Jet<double> at a point, Interval in bounds().
// docs/terrain-noise.md explains each step; what water carves into the slopes is land_gully.h.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "skydrop/terrain/terrain_settings.h"
#include "terrain/jet.h"

namespace skydrop::terrain {

// Smooth step from 0 at `from` to 1 at `to`: 3t^2 - 2t^3.
template <class R>
struct SmoothStep {
  R from, scale;
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    R t = (x - from) * scale;
    t = t < R(0) ? R(0) : t;
    t = t > R(1) ? R(1) : t;
    return {t * t * (R(3) - R(2) * t), R(6) * scale * t * (R(1) - t)};
  }
};

// |x| - e / 2 with the foot between -e and e replaced by the parabola x^2 / (2 e).
template <class R>
struct RoundedAbs {
  R e, scale;  // scale = 1 / e
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    R t = x * scale;
    t = t < R(-1) ? R(-1) : t;
    t = t > R(1) ? R(1) : t;
    return {t * (x - R(0.5) * e * t), t};
  }
};

// x^2 / (x^2 + w^2): 0 in a band of half-width about w around x = 0, 1 far from it.
template <class R>
struct Trough {
  R w2;
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    const R q = R(1) / (x * x + w2);
    return {x * x * q, R(2) * x * w2 * q * q};
  }
};

// (x + sqrt(x^2 + e^2)) / 2: 0 far to the left, x far to the right.
template <class R>
struct SmoothRamp {
  R e;
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    const R root = std::sqrt(x * x + e * e);
    return {R(0.5) * (x + root), R(0.5) + R(0.5) * x / root};
  }
};

// Identity between `low` and `high`; beyond, approaches low - room and high + room and never reaches them.
template <class R>
struct SoftLimit {
  R low, high, roomLow, roomHigh;
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    const R over = x > high ? x - high : R(0);
    const R under = x < low ? low - x : R(0);
    const R a = roomHigh / (roomHigh + over), b = roomLow / (roomLow + under);
    const R inside = x > high ? high : x < low ? low : x;
    return {inside + over * a - under * b, a * a * b * b};
  }
};

// 1 - 1 / (1 + |x| / w)^2 with a rounded foot: 0 on the crest line of a range, 1 far from it. Steep beside
// the crest and ever gentler below, as slopes of carved land are.
template <class R>
struct FallFromCrest {
  RoundedAbs<R> distance;
  R perWidth;  // 1 / w
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    const Slope<R> d = distance(x);
    const R q = R(1) / (R(1) + d.value * perWidth);
    return {R(1) - q * q, R(2) * q * q * q * perWidth * d.slope};
  }
};

inline constexpr std::size_t kHillOctaves = 4;

// The sums of octaves that the shape starts from, each in about [-1, 1]; of the hills every octave by itself,
// because they also bend the coast, the crests and the valleys.
template <class N>
struct LandFields {
  N continent, range, crest, valley;
  std::array<N, kHillOctaves> hills;
};

template <class N>
struct LandState {
  N height;    // metres, without what is still to come
  N strength;  // how deep water carves here: 0 at sea, about 1 high in a range
  N detail;    // sum of the octaves below the hills, in about [-1, 1]
};

// R is the scalar that the constants are kept in; N is Jet<R>, or Interval with R = double.
template <class R>
struct LandShape {
  R landBias, seaDepth, plainHeight, mountainHeight, hillHeight, carving, plainDetail, rockDetail;
  SmoothStep<R> rangeStep;
  Trough<R> river, pass;
  SoftLimit<R> limit;

  explicit LandShape(const TerrainSettings& s)
      : landBias(static_cast<R>(s.landBias)),
        seaDepth(static_cast<R>(1.1 * s.seaDepth)),
        plainHeight(static_cast<R>(s.plainHeight)),
        mountainHeight(static_cast<R>(s.mountainHeight)),
        hillHeight(static_cast<R>(80 * s.plainRoughness)),
        carving(static_cast<R>(s.roughness)),
        plainDetail(static_cast<R>(2.5 * s.plainRoughness)),
        rockDetail(static_cast<R>(8 * s.roughness)),
        rangeStep{static_cast<R>(0.1 - s.rangeShare), R(1.6)},
        river{static_cast<R>(s.valleyWidth * s.valleyWidth)},
        pass{static_cast<R>(4 * s.valleyWidth * s.valleyWidth)},
        limit{R(-200), R(1500), R(56), R(290)} {}

  template <class N>
  SKYDROP_INLINE LandState<N> begin(const LandFields<N>& f) const {
    const N &h0 = f.hills[0], &h1 = f.hills[1], &h2 = f.hills[2], &h3 = f.hills[3];
    const N land = f.continent + h0 * R(0.06) + h1 * R(0.035) + h2 * R(0.02) + landBias;
    const N inland = rising(land, SmoothStep<R>{R(0), R(1 / 0.35)});
    const N shore = rising(land, SmoothRamp<R>{R(0.02)}) * (R(0.5) * plainHeight);
    const N shelf = rising(land * R(-1), SmoothRamp<R>{R(0.03)}) * seaDepth;

    const N valley = f.valley + h1 * R(0.1) + h2 * R(0.05);
    const N bank = even(valley, river);
    const N mountains = rising(f.range + h0 * R(0.1), rangeStep) * inland;

    // Hills stand on plains that the rivers cut down to their own height.
    const N rolling = rising(f.range, SmoothStep<R>{R(-0.8), R(0.9)}) * R(0.8) + R(0.2);
    const N dry = rising(land, SmoothStep<R>{R(-0.02), R(5)});
    const N hills = (h0 * R(0.25) + h1 * R(0.5) + h2 * R(0.4) + h3 * R(0.18) + R(0.35)) * rolling * dry;
    const N plain = (shore + hills * hillHeight) * (bank * R(0.9) + R(0.1)) + (bank + R(-1)) * R(8);

    // A crest line along the range, lower ridges across it, passes where valleys cross.
    const N crest = even(f.crest + h0 * R(0.2) + h1 * R(0.09) + h2 * R(0.03),
                         FallFromCrest<R>{{R(0.03), R(1 / 0.03)}, R(1 / 0.32)}) *
                        R(-1) +
                    R(1);
    const N spine = even(h0 * R(0.7) + h1 * R(0.5), RoundedAbs<R>{R(0.08), R(1 / 0.08)}) * R(-1) + R(1);
    const N massif = mountains * (even(valley, pass) * R(0.6) + R(0.4));
    const N rise = massif * (crest * (spine * R(0.45) + R(0.5)) + spine * R(0.12));

    LandState<N> state;
    state.height = plain - shelf + rise * mountainHeight * R(1.25);
    state.strength = (massif * (crest * R(0.9) + R(0.2)) + rolling * dry * R(0.25)) * carving;
    state.detail = N{};
    return state;
  }

  template <class N>
  SKYDROP_INLINE N finish(const LandState<N>& state) const {
    return rising(state.height + state.detail * (state.strength * rockDetail + plainDetail), limit);
  }
};

}  // namespace skydrop::terrain
