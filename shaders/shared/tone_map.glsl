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

// Linear light in [0, 65504] to linear screen light in [0, 1].
FN Vec3 toneMap(Vec3 light) {
  Vec3 v = Vec3(Real(0.59719) * light.x + Real(0.35458) * light.y + Real(0.04823) * light.z,
                Real(0.07600) * light.x + Real(0.90834) * light.y + Real(0.01566) * light.z,
                Real(0.02840) * light.x + Real(0.13383) * light.y + Real(0.83777) * light.z);
  v = acesCurve(v);
  return Vec3(saturate(Real(1.60475) * v.x - Real(0.53108) * v.y - Real(0.07367) * v.z),
              saturate(Real(-0.10208) * v.x + Real(1.10813) * v.y - Real(0.00605) * v.z),
              saturate(Real(-0.00327) * v.x - Real(0.07276) * v.y + Real(1.07602) * v.z));
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
