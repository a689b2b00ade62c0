// Ground fog: extinction is even up to a base and falls exponentially with height above it. The optical depth of a
// straight path has a closed form (Wenzel, "Real-time Atmospheric Effects in Games", SIGGRAPH course, 2006; Quilez,
// "Better Fog", 2010), written here so that level paths, endless ones and any height of the eye are no special cases.
// Heights are above the base of the fog, in metres, of any sign.
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

// Length that a path of lengthM (m, >= |riseM|, at most kFarMarker) would have in fog of full density: optical depth is
// this times the extinction up to the base. It starts fromM above the base and ends riseM higher.
FN Real groundFogPath(Real fromM, Real riseM, Real lengthM, Real scaleHeightM) {
  Real low = riseM < Real(0.0) ? fromM + riseM : fromM;
  Real high = riseM < Real(0.0) ? fromM : fromM + riseM;
  Real rise = abs(riseM);
  // Both shares from their own ends: the small one must not come out of 1 minus the other.
  bool isLevel = rise < Real(1e-30);
  Real below = isLevel ? (low < Real(0.0) ? Real(1.0) : Real(0.0)) : saturate(-low / rise);
  Real above = isLevel ? Real(1.0) - below : saturate(high / rise);
  Real lowest = max(low, Real(0.0));
  Real span = isLevel ? Real(0.0) : min(rise, max(high, Real(0.0)));
  Real thin = exp(-lowest / scaleHeightM) * oneMinusExpOverX(span / scaleHeightM);
  return lengthM * (below + above * thin);
}

// 1 - exp(-depth), for depth >= 0.
FN Real groundFogOpacity(Real depth) { return saturate(depth * oneMinusExpOverX(depth)); }

// How far along a ray its optical depth reaches `depth` (> 0): what is seen of the fog is about that far away. slope:
// rise a metre, [-1, 1]; extinction: of the fog up to the base, 1/m, > 0. Taken as if fog grew on below the base, and,
// where the ray rises, as if it stayed as it is at its start: exact where the two meet, on level rays.
FN Real groundFogDistance(Real fromM, Real slope, Real depth, Real extinction, Real scaleHeightM) {
  Real steep = max(abs(slope), Real(1e-6));
  // In logarithms, because 1e6 m above the fog its density is no float.
  Real u = log(steep * depth / (extinction * scaleHeightM)) + max(fromM, Real(0.0)) / scaleHeightM;
  Real falling = u < Real(-8.0) ? exp(u) : max(u, Real(0.0)) + log(Real(1.0) + exp(-abs(u)));
  return scaleHeightM / steep * (slope < Real(0.0) ? falling : exp(min(u, Real(0.0))));
}
