// What a surface of the laboratory's scenes looks like: normal, Phong's light, shadows, ambient occlusion.
// Sources: Phong, "Illumination for Computer Generated Pictures", CACM 18(6), 1975; Thomann, "Procedural Cloud Shader",
// BFH 2020, sections 3.5 to 3.8; Quilez, "Free penumbra shadows for raymarching", 2010; Evans, "Fast Approximations for
// Global Illumination on Dynamic Scenes", SIGGRAPH 2006 (occlusion by distances).
#ifndef __cplusplus
#include "shared/lab/march.glsl"
#endif

// Central differences over 2 epsilon, not normalised: of length 1 where the distance is exact and smooth.
FN Vec3 differencesAt(int scene, Real amount, Vec3 p, Real epsilon) {
  Vec3 x = Vec3(epsilon, Real(0.0), Real(0.0));
  Vec3 y = Vec3(Real(0.0), epsilon, Real(0.0));
  Vec3 z = Vec3(Real(0.0), Real(0.0), epsilon);
  return Vec3(sceneDistance(scene, amount, p + x) - sceneDistance(scene, amount, p - x),
              sceneDistance(scene, amount, p + y) - sceneDistance(scene, amount, p - y),
              sceneDistance(scene, amount, p + z) - sceneDistance(scene, amount, p - z)) /
         (Real(2.0) * max(epsilon, Real(1e-30)));
}

// Where rounding leaves no difference at all, up.
FN Vec3 normalAt(int scene, Real amount, Vec3 p, Real epsilon) {
  return directionOf(differencesAt(scene, amount, p, epsilon), Vec3(Real(0.0), Real(1.0), Real(0.0)));
}

struct PhongShares {
  Real ambient;
  Real diffuse;
  Real specular;
  Real shininess;
};

// Of one light of strength 1: x is scattered evenly by the surface, y mirrored. Unit vectors away from the surface.
FN Vec2 phongLight(PhongShares shares, Vec3 normal, Vec3 toLight, Vec3 toEye) {
  Real facing = dot(normal, toLight);
  if (facing <= Real(0.0)) return Vec2(Real(0.0), Real(0.0));
  Vec3 mirrored = normal * (Real(2.0) * facing) - toLight;
  Real along = clamp(dot(mirrored, toEye), Real(0.0), Real(1.0));  // rounding beyond 1 would grow with the power
  // Of what is no normal float renderers' pow makes what they like, and of nothing there is no gloss.
  Real gloss = along > Real(1e-37) ? pow(along, shares.shininess) : Real(0.0);
  return Vec2(shares.diffuse * facing, shares.specular * gloss);
}

// The share of light that reaches a place: by sphere tracing towards the light, from `start` to `reach`. The nearest pass
// of the ray, as distance over way, times `hardness` is what is left of it: an endless hardness makes hard shadows, 0
// leaves no light at all.
struct Shade {
  Real light;
  int steps;
};

FN Shade shadeAlong(int scene, Real amount, Vec3 p, Vec3 direction, Real start, Real reach, Real hardness, int most) {
  Shade shade;
  shade.light = Real(1.0);
  shade.steps = 0;
  Real t = start;
  for (int i = 0; i < most; ++i) {
    Real distance = sceneDistance(scene, amount, p + direction * t);
    shade.steps = shade.steps + 1;
    if (distance < Real(1e-3)) {
      shade.light = Real(0.0);
      return shade;
    }
    shade.light = min(shade.light, hardness * distance / max(t, Real(1e-30)));
    t += distance;
    if (t > reach) return shade;
  }
  return shade;
}

// 1 without a shadow caster near: how much nearer than the way along the normal the scene is, at `count` places.
FN Real opennessAt(int scene, Real amount, Vec3 p, Vec3 normal, Real stride, int count, Real intensity) {
  Real closed = Real(0.0);
  for (int i = 1; i <= count; ++i) {
    Real way = max(stride * Real(i), Real(1e-6));
    closed += max(way - sceneDistance(scene, amount, p + normal * way), Real(0.0)) / way;
  }
  return saturate(Real(1.0) - closed * intensity);
}
