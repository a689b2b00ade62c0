// What a picture shows of the guards of shading where somebody asks to see them: which pixels were held back, by colour.
#ifndef __cplusplus
#include "shared/half_float.glsl"
#endif

CONST Real kNoGuard = Real(0.0);
CONST Real kBrightestGuard = Real(1.0);   // light was cut at the largest that a target keeps
CONST Real kNegativeGuard = Real(2.0);    // less than no light, shown as none
CONST Real kNotFiniteGuard = Real(3.0);   // infinite, or no number

// Of one channel. Comparisons with what is no number are false.
FN Real guardOfChannel(Real light) {
  if (!(light >= -Real(65504.0) && light <= Real(65504.0))) return kNotFiniteGuard;
  if (light < Real(0.0)) return kNegativeGuard;
  return light >= kBrightest ? kBrightestGuard : kNoGuard;
}

// The worst of the three channels.
FN Real guardOfLight(Vec3 light) {
  return max(max(guardOfChannel(light.x), guardOfChannel(light.y)), guardOfChannel(light.z));
}

// An encoded pixel: at half its brightness where nothing fired, else yellow, cyan or magenta.
FN Vec3 guardMarked(Vec3 encoded, Real guard) {
  if (guard == kNotFiniteGuard) return Vec3(Real(1.0), Real(0.0), Real(1.0));
  if (guard == kNegativeGuard) return Vec3(Real(0.0), Real(1.0), Real(1.0));
  if (guard == kBrightestGuard) return Vec3(Real(1.0), Real(1.0), Real(0.0));
  return encoded * Real(0.5);
}
