// Numbers that carry their gradient (forward differentiation) or their bounds (interval arithmetic), with the
// few operations that the shape of the land needs. The land is written once, as a template over the number
// (land_shape.h): heights with exact gradients and conservative bounds come out of the same formula.
//
// Everything here is forced inline: the row kernels compile it for several instruction sets, and no copy of
// one may be linked into another.
#pragma once

#include <algorithm>
#include <cmath>

#include "skydrop/core/force_inline.h"

namespace skydrop::terrain {

// A value and its derivatives by x (east) and z (south), per metre.
template <class Real>
struct Jet {
  using Scalar = Real;
  Real v{}, x{}, z{};
};

template <class R>
SKYDROP_INLINE Jet<R> operator+(Jet<R> a, Jet<R> b) {
  return {a.v + b.v, a.x + b.x, a.z + b.z};
}
template <class R>
SKYDROP_INLINE Jet<R> operator-(Jet<R> a, Jet<R> b) {
  return {a.v - b.v, a.x - b.x, a.z - b.z};
}
template <class R>
SKYDROP_INLINE Jet<R> operator*(Jet<R> a, Jet<R> b) {
  return {a.v * b.v, a.x * b.v + a.v * b.x, a.z * b.v + a.v * b.z};
}
template <class R>
SKYDROP_INLINE Jet<R> operator*(Jet<R> a, R k) {
  return {a.v * k, a.x * k, a.z * k};
}
template <class R>
SKYDROP_INLINE Jet<R> operator+(Jet<R> a, R k) {
  return {a.v + k, a.x, a.z};
}

// Bounds of a value. Rounding is not directed: whoever needs certainty widens the result (bounds() does).
struct Interval {
  using Scalar = double;
  double lo{}, hi{};
};

SKYDROP_INLINE Interval operator+(Interval a, Interval b) { return {a.lo + b.lo, a.hi + b.hi}; }
SKYDROP_INLINE Interval operator-(Interval a, Interval b) { return {a.lo - b.hi, a.hi - b.lo}; }
SKYDROP_INLINE Interval operator+(Interval a, double k) { return {a.lo + k, a.hi + k}; }
SKYDROP_INLINE Interval operator*(Interval a, double k) {
  return k < 0 ? Interval{a.hi * k, a.lo * k} : Interval{a.lo * k, a.hi * k};
}
SKYDROP_INLINE Interval operator*(Interval a, Interval b) {
  const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
}

// A function of one variable: its value and its slope.
template <class R>
struct Slope {
  R value, slope;
};

// f(a) for a function that never falls. f(R) returns Slope<R>.
template <class R, class F>
SKYDROP_INLINE Jet<R> rising(Jet<R> a, const F& f) {
  const Slope<R> s = f(a.v);
  return {s.value, s.slope * a.x, s.slope * a.z};
}
template <class F>
SKYDROP_INLINE Interval rising(Interval a, const F& f) {
  return {f(a.lo).value, f(a.hi).value};
}

// f(a) for an even function that never falls to the right of 0.
template <class R, class F>
SKYDROP_INLINE Jet<R> even(Jet<R> a, const F& f) {
  return rising(a, f);
}
template <class F>
SKYDROP_INLINE Interval even(Interval a, const F& f) {
  const double far = std::max(-a.lo, a.hi);
  const double near = a.lo > 0 ? a.lo : a.hi < 0 ? -a.hi : 0.0;
  return {f(near).value, f(far).value};
}

}  // namespace skydrop::terrain
