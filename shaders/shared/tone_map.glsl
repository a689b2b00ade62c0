// From scene light to the screen. The curve is Stephen Hill's fit (2015) of the ACES reference rendering and output
// transforms for sRGB screens: bright saturated light turns white, and middle grey stays near where it was.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

FN Vec3 acesCurve(Vec3 v) {
  Vec3 a = v * (v + Vec3(Real(0.0245786), Real(0.0245786), Real(0.0245786))) -
           Vec3(Real(0.000090537), Real(0.000090537), Real(0.000090537));
  Vec3 b = v * (v * Real(0.983729) + Vec3(Real(0.4329510), Real(0.4329510), Real(0.4329510))) +
           Vec3(Real(0.238081), Real(0.238081), Real(0.238081));
  return a / b;
}

// Linear light in [0, 65504] on the curve, [-0.0004, 1.0166] a channel. What the screen shows is linear in it but for the
// ends: the mean of pixels as they are shown is the mean of this.
FN Vec3 toneCurve(Vec3 light) {
  return acesCurve(Vec3(Real(0.59719) * light.x + Real(0.35458) * light.y + Real(0.04823) * light.z,
                        Real(0.07600) * light.x + Real(0.90834) * light.y + Real(0.01566) * light.z,
                        Real(0.02840) * light.x + Real(0.13383) * light.y + Real(0.83777) * light.z));
}

// From the curve to linear screen light in [0, 1].
FN Vec3 screenOfToneCurve(Vec3 v) {
  return Vec3(saturate(Real(1.60475) * v.x - Real(0.53108) * v.y - Real(0.07367) * v.z),
              saturate(Real(-0.10208) * v.x + Real(1.10813) * v.y - Real(0.00605) * v.z),
              saturate(Real(-0.00327) * v.x - Real(0.07276) * v.y + Real(1.07602) * v.z));
}

// Linear light in [0, 65504] to linear screen light in [0, 1].
FN Vec3 toneMap(Vec3 light) { return screenOfToneCurve(toneCurve(light)); }

// The positive root of the curve's quadratic; of values between those of 0 and of 65504.
FN Real acesCurveInverse(Real y) {
  Real a = max(Real(1.0) - Real(0.983729) * y, Real(1e-6));
  Real b = Real(0.0245786) - Real(0.4329510) * y;
  Real c = Real(0.000090537) + Real(0.238081) * y;
  Real root = squareRoot(b * b + Real(4.0) * a * c);
  // Of the two forms the one in which nothing cancels.
  return b < Real(0.0) ? (root - b) / (Real(2.0) * a) : Real(2.0) * c / max(root + b, Real(1e-12));
}

// The light, [0, 65504], that toneCurve() sends there.
FN Vec3 lightOfToneCurve(Vec3 curve) {
  Vec3 v = Vec3(acesCurveInverse(curve.x), acesCurveInverse(curve.y), acesCurveInverse(curve.z));
  Vec3 light = Vec3(Real(1.7647410) * v.x - Real(0.6757777) * v.y - Real(0.0889633) * v.z,
                    Real(-0.1470279) * v.x + Real(1.1602515) * v.y - Real(0.0132237) * v.z,
                    Real(-0.0363368) * v.x - Real(0.1624364) * v.y + Real(1.1987733) * v.z);
  return clamp(light, Vec3(Real(0.0), Real(0.0), Real(0.0)), Vec3(Real(65504.0), Real(65504.0), Real(65504.0)));
}

// The transfer function of sRGB (IEC 61966-2-1), [0, 1] to [0, 1].
FN Real srgbEncode1(Real linear) {
  return linear <= Real(0.0031308) ? Real(12.92) * linear
                                   : Real(1.055) * pow(linear, Real(1.0) / Real(2.4)) - Real(0.055);
}

FN Vec3 srgbEncode(Vec3 linear) {
  return Vec3(srgbEncode1(linear.x), srgbEncode1(linear.y), srgbEncode1(linear.z));
}

FN Real srgbDecode1(Real encoded) {
  return encoded <= Real(0.04045) ? encoded / Real(12.92)
                                  : pow((encoded + Real(0.055)) / Real(1.055), Real(2.4));
}

FN Vec3 srgbDecode(Vec3 encoded) {
  return Vec3(srgbDecode1(encoded.x), srgbDecode1(encoded.y), srgbDecode1(encoded.z));
}
