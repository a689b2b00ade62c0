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

// sqrt(x^2 + e^2) - e: |x| with a rounded foot.
template <class R>
struct SmoothAbs {
  R e;
  SKYDROP_INLINE Slope<R> operator()(R x) const {
    const R root = std::sqrt(x * x + e * e);
    return {root - e, x / root};
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
  N relief;    // the ridged sum so far
  N weight;    // what the next octave of the ridged sum may add
  N detail;    // the smooth sum so far
};

// R is the scalar that the constants are kept in; N is Jet<R>, or Interval with R = double.
template <class R>
struct LandShape {
  R landBias, seaDepth, plainHeight, mountainHeight, valleyWidth2, roughness, plainRoughness;
  SmoothStep<R> rangeStep, inlandStep;
  SoftLimit<R> limit;

  explicit LandShape(const TerrainSettings& s)
      : landBias(static_cast<R>(s.landBias)),
        seaDepth(static_cast<R>(s.seaDepth)),
        plainHeight(static_cast<R>(s.plainHeight)),
        mountainHeight(static_cast<R>(s.mountainHeight)),
        valleyWidth2(static_cast<R>(s.valleyWidth * s.valleyWidth)),
        roughness(static_cast<R>(s.roughness)),
        plainRoughness(static_cast<R>(s.plainRoughness)),
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

  // One octave of the relief; `share` is its amplitude (1, 1/2, 1/4, ...).
  template <class N>
  SKYDROP_INLINE void octave(const N& noise, R share, LandState<N>& state) const {
    const N ridge = even(noise, SmoothAbs<R>{R(0.06)}) * R(-1) + R(1);
    const N signal = ridge * ridge;
    state.relief = state.relief + signal * state.weight * share;
    state.weight = signal * state.weight;
    state.detail = state.detail + noise * share;
  }

  template <class N>
  SKYDROP_INLINE N finish(const LandState<N>& state) const {
    const N plain = state.detail * (R(40) * plainRoughness);
    const N height = state.base + plain + state.mountain * state.relief * (R(0.7) * mountainHeight);
    return rising(height, limit);
  }
};

}  // namespace skydrop::terrain
