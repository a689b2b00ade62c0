// Sea water seen from above: what it reflects, what it lets through, what it sends back.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Share of light that a sea with waves reflects towards the eye, by the cosine of the mean view angle: Schlick's form
// with the mean over slopes of Bruneton, Neyret, Holzschuch, "Real-time Realistic Ocean Lighting using Seamless
// Transitions from Geometry to BRDF", 2010, section 4. `slope` is the standard deviation of the waves' slope.
FN Real seaReflectance(Real cosView, Real slope) {
  Real power = Real(5.0) * exp(Real(-2.69) * slope);
  return Real(0.02) + Real(0.98) * pow(Real(1.0) - saturate(cosView), power) /
                          (Real(1.0) + Real(22.7) * pow(slope, Real(1.5)));
}

// Absorption and scattering out of the way, 1/m: clear coastal water (between Jerlov's types III and 1).
FN Vec3 seaExtinction() { return Vec3(Real(0.420), Real(0.110), Real(0.090)); }

// Irradiance reflectance of deep water: what comes back of the light that enters.
FN Vec3 seaBodyAlbedo() { return Vec3(Real(0.006), Real(0.022), Real(0.034)); }

// Share of light that reaches the floor at a depth and comes back up, along slanted ways (1.2 times the depth each).
FN Vec3 throughWater(Real depthM) {
  Vec3 optical = seaExtinction() * (max(depthM, Real(0.0)) * Real(2.4));
  return Vec3(exp(-optical.x), exp(-optical.y), exp(-optical.z));
}
