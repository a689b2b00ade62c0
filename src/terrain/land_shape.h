// The shape of the land: how octaves of noise become continents, ranges, valleys and plains. Written once
// over a number type N: Jet<float> in the row kernels, Jet<double> at a point, Interval in bounds().
// docs/terrain-noise.md explains each step with pictures; the ridged sum is Musgrave's multifractal
// (Ebert, Musgrave, Peachey, Perlin, Worley: Texturing and Modeling, 2003, chapter 16).
#pragma once

#include <array>

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

// The amplitude of octave `index` (0 is the coarsest) of the relief, in the ridged and in the smooth sum. The
// coarsest ridges are the mountains themselves; roughness is what stands on them.
inline constexpr double kDetailMetres = 40;  // height of the hills of the coarsest octave
inline double ridgeShare(const TerrainSettings& s, int index) {
  return index == 0 ? 1.0 : s.roughness / static_cast<double>(1 << index);
}
inline double detailShare(const TerrainSettings& s, int index) {
  return kDetailMetres * s.plainRoughness / static_cast<double>(1 << index);
}

// The sums of octaves that the shape starts from, each in about [-1, 1].
template <class N>
struct LandFields {
  N continent, range, valley;
};

// What the octaves of the relief modulate and add to.
template <class N>
struct LandState {
  N base;      // the land without relief, metres
  N mountain;  // how mountainous: 0 on plains and at sea, 1 inside a range
  N relief;    // the ridged sum so far, in about [0, 2]
  N weight;    // what the next octave of the ridged sum may add
  N detail;    // the smooth sum so far, metres
};

// R is the scalar that the constants are kept in; N is Jet<R>, or Interval with R = double.
template <class R>
struct LandShape {
  R landBias, seaDepth, plainHeight, mountainHeight, valleyWidth2;  // mountainHeight is per unit of relief
  SmoothStep<R> rangeStep, inlandStep;
  SoftLimit<R> limit;

  explicit LandShape(const TerrainSettings& s)
      : landBias(static_cast<R>(s.landBias)),
        seaDepth(static_cast<R>(s.seaDepth)),
        plainHeight(static_cast<R>(s.plainHeight)),
        mountainHeight(static_cast<R>(0.7 * s.mountainHeight)),
        valleyWidth2(static_cast<R>(s.valleyWidth * s.valleyWidth)),
        rangeStep{static_cast<R>(0.3 - s.rangeShare), R(2)},
        inlandStep{R(0.02), R(3)},
        limit{R(-200), R(1500), R(56), R(290)} {}

  template <class N>
  SKYDROP_INLINE LandState<N> begin(const LandFields<N>& f) const {
    const N land = f.continent + landBias;
    const N shore = rising(land, SmoothRamp<R>{R(0.1)}) * plainHeight;
    const N shelf = rising(land * R(-1), SmoothRamp<R>{R(0.1)}) * seaDepth;
    const N trough = even(f.valley, Trough<R>{valleyWidth2});
    LandState<N> state;
    state.base = shore - shelf;
    state.mountain = rising(f.range, rangeStep) * rising(land, inlandStep) * trough;
    state.relief = N{};
    state.weight = N{} + R(1);
    state.detail = N{};
    return state;
  }

  // One octave of the relief; its amplitudes in the ridged and in the smooth sum.
  template <class N>
  SKYDROP_INLINE void octave(const N& noise, R ridgeShare, R detailShare, LandState<N>& state) const {
    const N ridge = even(noise, RoundedAbs<R>{R(0.06), R(1 / 0.06)}) * R(-1) + R(1);
    state.weight = ridge * ridge * state.weight;
    state.relief = state.relief + state.weight * ridgeShare;
    state.detail = state.detail + noise * detailShare;
  }

  template <class N>
  SKYDROP_INLINE N finish(const LandState<N>& state) const {
    const N height = state.base + state.detail + state.mountain * state.relief * mountainHeight;
    return rising(height, limit);
  }
};

}  // namespace skydrop::terrain
