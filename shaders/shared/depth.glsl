// Reversed depth with an infinite far plane: depth = nearM / viewZ, 1 at the near plane, 0 at infinity.
// viewZ is the distance along the view axis, in metres; a ray's length is viewZ times the length of its direction
// scaled to reach 1 along that axis.
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

// What stands for "nothing there" in place of a distance, in metres.
CONST Real kFarMarker = Real(1e30);

FN Real depthOfViewZ(Real viewZ, Real nearM) { return nearM / viewZ; }

// At most kFarMarker: a depth that is no normal float is no surface.
FN Real viewZOfDepth(Real depth, Real nearM) {
  return depth > Real(0.0) ? min(nearM / depth, kFarMarker) : kFarMarker;
}

// Distance from the eye to the surface of a depth sample. `rayScale` is the length of the pixel's ray where its
// component along the view axis is 1 (at least 1: larger in the corners). At most kFarMarker.
FN Real distanceOfDepth(Real depth, Real nearM, Real rayScale) {
  return depth > Real(0.0) ? min(nearM / depth * rayScale, kFarMarker) : kFarMarker;
}
