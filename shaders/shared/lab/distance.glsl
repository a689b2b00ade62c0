// Signed distances: negative inside, 0 on the surface, positive outside. Lengths in one unit, whichever it is, below 1e18:
// their squares are floats.
// Sources: Hart, "Sphere Tracing", The Visual Computer 12, 1996 (distances and their operators); Thomann, "Procedural
// Cloud Shader", BFH 2020, sections 3.4 to 3.7 (which shapes, and how they are blended).
#ifndef __cplusplus
#include "shared/guards.glsl"
#endif

FN Real sphereDistance(Vec3 p, Real radius) { return length(p) - radius; }

// `reach`: half of each edge.
FN Real boxDistance(Vec3 p, Vec3 reach) {
  Vec3 q = abs(p) - reach;
  Vec3 outside = max(q, Vec3(Real(0.0), Real(0.0), Real(0.0)));
  return length(outside) + min(max(q.x, max(q.y, q.z)), Real(0.0));
}

// A ring around the y axis.
FN Real torusDistance(Vec3 p, Real ring, Real tube) {
  return length(Vec2(length(Vec2(p.x, p.z)) - ring, p.y)) - tube;
}

// `normal` is a unit vector; `height` is that of the plane along it.
FN Real planeDistance(Vec3 p, Vec3 normal, Real height) { return dot(p, normal) - height; }

// Upright, with caps at +-reach.
FN Real cylinderDistance(Vec3 p, Real radius, Real reach) {
  Vec2 q = Vec2(length(Vec2(p.x, p.z)) - radius, abs(p.y) - reach);
  return length(max(q, Vec2(Real(0.0), Real(0.0)))) + min(max(q.x, q.y), Real(0.0));
}

// Gradients of these distances: unit vectors, where there is one. On an axis of symmetry, where the distance has a
// kink, `up`.
FN Vec3 sphereGradient(Vec3 p) { return directionOf(p, Vec3(Real(0.0), Real(1.0), Real(0.0))); }

FN Real awayFromZero(Real x) { return x < Real(0.0) ? Real(-1.0) : Real(1.0); }

FN Vec3 boxGradient(Vec3 p, Vec3 reach) {
  Vec3 q = abs(p) - reach;
  Vec3 signs = Vec3(awayFromZero(p.x), awayFromZero(p.y), awayFromZero(p.z));
  Vec3 outside = max(q, Vec3(Real(0.0), Real(0.0), Real(0.0)));
  if (q.x > Real(0.0) || q.y > Real(0.0) || q.z > Real(0.0)) return signs * directionOf(outside, Vec3(Real(0.0), Real(1.0), Real(0.0)));
  if (q.x >= q.y && q.x >= q.z) return Vec3(signs.x, Real(0.0), Real(0.0));
  if (q.y >= q.z) return Vec3(Real(0.0), signs.y, Real(0.0));
  return Vec3(Real(0.0), Real(0.0), signs.z);
}

FN Vec3 torusGradient(Vec3 p, Real ring) {
  // By the distance from the ring, which is one difference; p less the ring's nearest place would be two.
  Vec3 outward = directionOf(Vec3(p.x, Real(0.0), p.z), Vec3(Real(0.0), Real(0.0), Real(0.0)));
  Vec3 aside = outward * (length(Vec2(p.x, p.z)) - ring);
  // In the middle of the tube every direction is one: outward, which is near where a small distance is rounded to none.
  // Within a float's step of the middle a height beside a distance that is rounded says nothing either.
  bool onAxis = dot(outward, outward) < Real(0.5);
  Real rounding = Real(1.2e-7) * ring;
  if (!onAxis && abs(length(Vec2(p.x, p.z)) - ring) < rounding && abs(p.y) < rounding) return outward;
  return directionOf(Vec3(aside.x, p.y, aside.z), onAxis ? Vec3(Real(0.0), Real(1.0), Real(0.0)) : outward);
}

// Both shapes, what they share, and the first without the second. On the surface and outside the union the union's
// distance is exact; the others are bounds that never reach beyond the surface.
FN Real unionOf(Real a, Real b) { return min(a, b); }
FN Real intersectionOf(Real a, Real b) { return max(a, b); }
FN Real differenceOf(Real a, Real b) { return max(a, -b); }

// A shape between two: the first at share 1, the second at 0. A bound, not a distance.
FN Real blendOf(Real a, Real b, Real share) { return share * a + (Real(1.0) - share) * b; }

// The union with its crease filled over a width (Quilez, "Smooth minimum", 2013): lower than min() by a quarter of the
// width where both are alike, the same beyond. A width of 0 is min() itself; an endless one is treated as 1e9.
FN Real smoothUnionOf(Real a, Real b, Real width) {
  Real w = min(width, Real(1e9));
  if (!(w > Real(0.0))) return min(a, b);
  Real share = max(w - abs(a - b), Real(0.0)) / w;
  return min(a, b) - share * share * w * Real(0.25);
}
