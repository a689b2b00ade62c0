// Elementary functions whose every bit is the same on any x86-64, because they are compiled with our flags
// and use only + - * / sqrt and exact operations. The simulation uses these instead of libm, whose last bits
// change with the processor and the version (docs/determinism.md). Pure, thread-safe, never throw; NaN in
// gives NaN out, infinities and signed zeros follow IEEE 754 (C99 annex F).
//
// Errors in units in the last place of the result (ulp), measured against long double libm over the domains
// below, and asserted in tests/unit/deterministic_math_test.cpp.
#pragma once

namespace skydrop::core::dmath {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kHalfPi = kPi / 2;
inline constexpr double kTwoPi = kPi * 2;
inline constexpr double kRadPerDeg = kPi / 180;
inline constexpr double kDegPerRad = 180 / kPi;

// Angle in radians, any finite value: two-step reduction (Cody, Waite 1980) below 1e6, the digits of 2/pi
// (Payne, Hanek 1983) above. Error < 1 ulp; tan < 2.5 ulp. Infinity gives NaN.
double sin(double angleRad);
double cos(double angleRad);
double tan(double angleRad);

// e to the x. Error < 1 ulp. Above 709.78 infinity, below -745.13 zero; denormal results are rounded twice
// (< 1 denormal step off).
double exp(double x);

// Natural logarithm. Error < 1 ulp. log(0) = -infinity, log of a negative number = NaN.
double log(double x);

// Angle of the point (x, y), in [-pi, pi]. Error < 2 ulp. All cases of zeros and infinities as in C99
// F.9.1.4.
double atan2(double y, double x);

// In [-pi/2, pi/2] and [0, pi]. Error < 2.5 ulp. NaN outside [-1, 1]; core::safeAsin clamps and counts.
double asin(double x);
double acos(double x);

// x to the y. Error < 2 ulp while |y log x| < 30, growing to 16 ulp at the ends of the range. A negative x
// needs an integer y, else NaN; pow(x, 0) = pow(1, y) = 1.
double pow(double x, double y);

}  // namespace skydrop::core::dmath
