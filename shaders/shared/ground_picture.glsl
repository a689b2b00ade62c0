// The land under an aerial image: how much of its colour is the image's, and which.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Of the ground's colour. `coverage`: of the image at the place, [0, 1], 0 where it shows nothing and rising over its
// edge; distanceM from the eye, >= 0. Right before the eye it is nearShare of `share`, and all of it from nearM on.
FN Real groundPictureShare(Real coverage, Real distanceM, Real share, Real nearShare, Real nearM) {
  Real t = saturate(distanceM / nearM);
  return coverage * share * mix(nearShare, Real(1.0), t * t * (Real(3.0) - Real(2.0) * t));
}

// The level of an image whose texels are as large as what a pixel covers, both in metres, > 0.
FN Real groundPictureLevel(Real footprintM, Real texelM) { return log(max(footprintM / texelM, Real(1.0))) * Real(1.442695); }

// The albedo of ground that is partly an image's: `seen` is its linear value, which times gain is taken for
// reflectance, as light as fresh snow at most.
FN Vec3 pictured(Vec3 albedo, Vec3 seen, Real share, Real gain) {
  return mix(albedo, min(seen * gain, Vec3(Real(0.9), Real(0.9), Real(0.9))), share);
}
