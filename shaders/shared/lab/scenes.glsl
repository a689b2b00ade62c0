// The scenes that the laboratory marches through, by number, and the closed form of the first. A number that is
// constant where it is compiled leaves one scene. `amount` is the scene's own knob: the share of a blend, or the width of
// a smooth union. Heights are above the floor, which all but the bare scenes have.
#ifndef __cplusplus
#include "shared/lab/distance.glsl"
#endif

CONST int kBallScene = 0;        // a sphere of radius 1 on the floor
CONST int kShapesScene = 1;      // sphere, box, torus and cylinder
CONST int kShadowScene = 2;      // a sphere over a flat box
CONST int kBlendScene = 3;       // sphere and box, blended
CONST int kSmoothScene = 4;      // sphere and box, joined smoothly
CONST int kHolesScene = 5;       // a box, blended with a sphere, with a hole along each axis
CONST int kUnionScene = 6;       // sphere and box
CONST int kIntersectionScene = 7;
CONST int kDifferenceScene = 8;
CONST int kTorusScene = 9;       // alone, without a floor

FN Real ballAt(Vec3 p, Vec3 middle, Real radius) { return sphereDistance(p - middle, radius); }
FN Real boxAt(Vec3 p, Vec3 middle, Real x, Real y, Real z) { return boxDistance(p - middle, Vec3(x, y, z)); }

// Box blended with a sphere by `share`, with three holes.
FN Real drilledBox(Vec3 p, Real share) {
  Real body = blendOf(sphereDistance(p, Real(1.15)), boxDistance(p, Vec3(Real(0.85), Real(0.85), Real(0.85))), share);
  Real holes = unionOf(length(Vec2(p.y, p.z)), unionOf(length(Vec2(p.x, p.z)), length(Vec2(p.x, p.y)))) - Real(0.45);
  return differenceOf(body, holes);
}

FN Real sceneDistance(int scene, Real amount, Vec3 p) {
  Real floorAt = p.y;
  if (scene == kBallScene) return min(ballAt(p, Vec3(Real(0.0), Real(1.0), Real(0.0)), Real(1.0)), floorAt);
  if (scene == kShapesScene) {
    Real shapes = ballAt(p, Vec3(Real(-1.6), Real(0.7), Real(0.6)), Real(0.7));
    shapes = min(shapes, boxAt(p, Vec3(Real(-0.5), Real(0.55), Real(-1.2)), Real(0.55), Real(0.55), Real(0.55)));
    shapes = min(shapes, torusDistance(p - Vec3(Real(0.3), Real(0.25), Real(0.9)), Real(0.6), Real(0.25)));
    shapes = min(shapes, cylinderDistance(p - Vec3(Real(1.6), Real(0.7), Real(-0.4)), Real(0.5), Real(0.7)));
    return min(shapes, floorAt);
  }
  if (scene == kShadowScene) {
    Real ball = ballAt(p, Vec3(Real(0.0), Real(1.5), Real(0.0)), Real(0.6));
    return min(min(ball, boxAt(p, Vec3(Real(0.0), Real(0.2), Real(0.0)), Real(1.2), Real(0.2), Real(1.2))), floorAt);
  }
  if (scene == kTorusScene) return torusDistance(p, Real(0.7), Real(0.3));
  Vec3 q = p - Vec3(Real(0.0), Real(1.1), Real(0.0));
  if (scene == kHolesScene) return min(drilledBox(q, amount), floorAt);
  if (scene == kBlendScene) {
    return min(blendOf(sphereDistance(q, Real(1.1)), boxDistance(q, Vec3(Real(0.8), Real(0.8), Real(0.8))), amount),
               floorAt);
  }
  // Two that overlap by a corner.
  Real ball = sphereDistance(q - Vec3(Real(0.5), Real(0.35), Real(0.3)), Real(0.7));
  Real box = boxDistance(q - Vec3(Real(-0.35), Real(-0.35), Real(-0.2)), Vec3(Real(0.7), Real(0.7), Real(0.7)));
  if (scene == kSmoothScene) return min(smoothUnionOf(ball, box, amount), floorAt);
  if (scene == kIntersectionScene) return min(intersectionOf(ball, box), floorAt);
  if (scene == kDifferenceScene) return min(differenceOf(box, ball), floorAt);
  return min(unionOf(ball, box), floorAt);
}

// How far along a ray (unit direction) a sphere begins, negative where the ray misses it; 0 from inside or on it. The
// square is taken across the ray, so that a small sphere far away does not drown in a difference of large squares.
FN Real rayToSphere(Vec3 origin, Vec3 direction, Vec3 middle, Real radius) {
  Vec3 to = middle - origin;
  Real along = dot(to, direction);
  if (dot(to, to) <= radius * radius) return Real(0.0);
  Vec3 across = to - direction * along;
  Real square = radius * radius - dot(across, across);
  if (square < Real(0.0) || along < Real(0.0)) return Real(-1.0);
  return along - sqrt(square);
}

FN Real rayToFloor(Vec3 origin, Vec3 direction) {
  if (origin.y <= Real(0.0)) return Real(0.0);
  return direction.y < Real(0.0) ? origin.y / -direction.y : Real(-1.0);
}

// The closed form of kBallScene; negative where the ray hits nothing.
FN Real rayToBallScene(Vec3 origin, Vec3 direction) {
  Real ball = rayToSphere(origin, direction, Vec3(Real(0.0), Real(1.0), Real(0.0)), Real(1.0));
  Real ground = rayToFloor(origin, direction);
  if (ball < Real(0.0)) return ground;
  return ground < Real(0.0) ? ball : min(ball, ground);
}
