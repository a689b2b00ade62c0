// Torque-free rotation to about 1e-14: the truth that the integrators are measured against. Euler's equations
// and the quaternion in long double, Runge-Kutta of order 4 at 40 kHz (halving its step changes the result by
// 1e-14).
#pragma once

#include <array>
#include <cmath>

namespace skydrop::test {

struct RotationState {
  std::array<long double, 3> spin{};                // rad/s, principal body axes
  std::array<long double, 4> attitude{1, 0, 0, 0};  // w, x, y, z, body to world
};

inline RotationState rotateFreely(const RotationState& start, const std::array<long double, 3>& inertia,
                                  double seconds, int stepsPerSecond = 40000) {
  using Vector = std::array<long double, 7>;
  const auto rate = [&](const Vector& s) {
    const auto& [a, b, c] = inertia;
    return Vector{(b - c) * s[1] * s[2] / a,
                  (c - a) * s[2] * s[0] / b,
                  (a - b) * s[0] * s[1] / c,
                  0.5L * (-s[4] * s[0] - s[5] * s[1] - s[6] * s[2]),
                  0.5L * (s[3] * s[0] + s[5] * s[2] - s[6] * s[1]),
                  0.5L * (s[3] * s[1] + s[6] * s[0] - s[4] * s[2]),
                  0.5L * (s[3] * s[2] + s[4] * s[1] - s[5] * s[0])};
  };
  const auto moved = [](const Vector& s, const Vector& r, long double h) {
    Vector out{};
    for (std::size_t i = 0; i < 7; ++i) out[i] = s[i] + h * r[i];
    return out;
  };
  Vector s{start.spin[0],     start.spin[1],     start.spin[2],    start.attitude[0],
           start.attitude[1], start.attitude[2], start.attitude[3]};
  const auto steps = static_cast<long>(seconds * stepsPerSecond + 0.5);
  const long double h = static_cast<long double>(seconds) / static_cast<long double>(steps);
  for (long i = 0; i < steps; ++i) {
    const Vector a = rate(s), b = rate(moved(s, a, h / 2)), c = rate(moved(s, b, h / 2)),
                 d = rate(moved(s, c, h));
    for (std::size_t k = 0; k < 7; ++k) s[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
  return {{s[0], s[1], s[2]}, {s[3], s[4], s[5], s[6]}};
}

// Complete elliptic integral of the first kind with parameter m (not modulus), by the arithmetic-geometric
// mean.
inline long double ellipticK(long double m) {
  long double a = 1, b = sqrtl(1 - m);
  while (fabsl(a - b) > 1e-18L * a) {
    const long double mean = (a + b) / 2;
    b = sqrtl(a * b);
    a = mean;
  }
  return 3.14159265358979323846264338328L / (2 * a);
}

}  // namespace skydrop::test
