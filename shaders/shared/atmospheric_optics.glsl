// Halos, sun dogs and rainbows: angles, and how much ice or rain a ray meets. Directions are unit vectors, y up, seen from
// the eye; angles are in radians unless they are called degrees; heights and distances in metres.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/atmosphere_shell.glsl"
#endif

CONST Real kDegree = Real(0.017453292519943295);

// Between two directions, [0, pi]. acos of their product loses half of its digits near 0 and pi; this does not.
FN Real angleBetween(Vec3 a, Vec3 b) { return atan(length(cross(a, b)), dot(a, b)); }

// Where a value lies on a side of a table whose first texel stands for `first` and whose last one for `last`; held outside.
FN Real texturePlace(Real value, Real first, Real last, Real texels) {
  return (saturate((value - first) / (last - first)) * (texels - Real(1.0)) + Real(0.5)) / texels;
}

// How much longer than upright a ray of this elevation's sine is in a thin shell `aboveM` over the eye, >= 1: 20 for level
// rays to ice 8 km up. Rays below the horizontal count as those above it.
FN Real iceSlant(Real sine, Real aboveM) {
  Real above = max(aboveM, Real(1.0));
  Real sum = kEarthRadius + above;
  // 1 - cosine^2 R^2 / (R + h)^2 without its difference of what is nearly 1.
  Real sine2 = saturate(sine * sine);
  Real rest = (above / sum) * ((Real(2.0) * kEarthRadius + above) / sum);
  return Real(1.0) / sqrt(sine2 + (Real(1.0) - sine2) * rest);
}

// Light scattered once towards the eye, per illuminance and phase function, in ice that is lit from behind: of an optical
// depth along the ray. (Exact where light and ray cross it at the same slant.)
FN Real iceScattering(Real depth) { return depth * exp(-depth); }

// Refractive index of ice where red ends (Warren and Brandt 2008); as in assets/scripts/make_halo.py.
CONST Real kRedIndexOfIce = Real(1.3070);
CONST Real kHighestSunDog = Real(60.0);  // degrees: none above

// Azimuth from the light at which level plates deviate red light least, by the sine of the light's elevation
// (Bravais 1847): 21.6 degrees at the horizon, more the higher it stands; 120 where no plate lets it through.
FN Real leastSunDogAzimuth(Real sine) {
  Real cosine2 = max(Real(1.0) - sine * sine, Real(1e-6));
  Real skewed = sqrt((kRedIndexOfIce * kRedIndexOfIce - sine * sine) / cosine2);
  return Real(2.0) * asin(min(skewed * Real(0.5), Real(1.0))) - Real(60.0) * kDegree;
}

FN Real elevationOf(Vec3 direction) {
  return atan(direction.y, sqrt(direction.x * direction.x + direction.z * direction.z) + Real(1e-20));
}

// A direction as the table of sun dogs has it, in degrees: how far along the circle of the light's elevation beyond the
// least deviation, how far above that circle, and the light's elevation.
FN Vec3 sunDogDegrees(Vec3 direction, Vec3 toLight) {
  Real elevation = elevationOf(toLight);
  Real aside = abs(direction.x * toLight.z - direction.z * toLight.x) + Real(0.0);  // no -0, whose angle is -pi
  Real along = direction.x * toLight.x + direction.z * toLight.z;
  // Straight up there is no azimuth, and any will do.
  Real azimuth = atan(aside, abs(along) < Real(1e-20) ? Real(1e-20) : along);
  Real beyond = (azimuth - leastSunDogAzimuth(toLight.y)) * cos(elevation);
  return Vec3(beyond, elevationOf(direction) - elevation, elevation) / kDegree;
}

// The part of a ray that lies in rain, which fills all below topM from nearM to farM away: where it begins, and how long it
// is (0: none). `slope` is the rise a metre; depthM where the ray ends.
FN Vec2 rainPath(Real eyeM, Real slope, Real depthM, Real nearM, Real farM, Real topM) {
  Real above = topM - eyeM;
  Real steep = max(abs(slope), Real(1e-9));
  bool rises = slope >= Real(0.0);
  Real from = rises ? nearM : max(nearM, -above / steep);
  Real to = min(farM, depthM);
  to = rises ? min(to, above / steep) : to;
  return Vec2(from, max(to - from, Real(0.0)));
}

// Light scattered once towards the eye, per illuminance and phase function, in rain that is lit from the eye's side: of an
// optical depth along the ray. Light comes in as far as it goes out: (1 - exp(-2 depth)) / 2.
FN Real rainScattering(Real depth) { return depth * oneMinusExpOverX(Real(2.0) * depth); }

// Rows of the rainbow's table go by the logarithm of the drops' radius, from 0.1 to 1 mm: [0, 1].
FN Real rainbowRow(Real radiusMm) { return saturate(Real(1.0) + log(radiusMm) / Real(2.302585092994046)); }
