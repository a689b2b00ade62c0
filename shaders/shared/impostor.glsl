// Directions of an impostor's views: a square grid over the upper half of all directions (hemi-octahedral map: Cigolle et
// al., "A survey of efficient representations for independent unit vectors", JCGT 3(2), 2014).
#ifndef __cplusplus
#include "shared/dialect.glsl"
#endif

// A direction, not downwards, to the square [0, 1]^2: level ones along its border, straight up in its middle.
FN Vec2 hemiOctOf(Vec3 direction) {
  Real scale = Real(1.0) / (abs(direction.x) + max(direction.y, Real(0.0)) + abs(direction.z));
  Vec2 flatOne = Vec2(direction.x, direction.z) * scale;
  return Vec2(flatOne.x + flatOne.y, flatOne.x - flatOne.y) * Real(0.5) + Vec2(Real(0.5), Real(0.5));
}

// The other way round, unit.
FN Vec3 directionOfHemiOct(Vec2 square) {
  Vec2 at = square * Real(2.0) - Vec2(Real(1.0), Real(1.0));
  Vec2 flatOne = Vec2(at.x + at.y, at.x - at.y) * Real(0.5);
  Vec3 direction = Vec3(flatOne.x, Real(1.0) - abs(flatOne.x) - abs(flatOne.y), flatOne.y);
  return direction / length(direction);
}
