// Vertices of a stone: a ball with dents of its own, sunk into the ground and tilted with it.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "ground_cover/attributes.glsl"

layout(location = 0) in vec4 ballPlace;

struct StoneVertex {
  vec3 relative;
  vec3 inStone;  // place in the stone, m
  vec3 outwards;  // a normal of the dented ball
};

StoneVertex stoneVertex() {
  uint bits = uint(coverForm.w);
  vec3 ball = ballPlace.xyz;
  vec4 dents = simplexNoise(uvec3(bits & 0xfffu, bits >> 12, 3u), ball * 1.35);
  vec3 shape = ball * (0.92 + 0.42 * dents.w);
  // Cut flat here and there, as stones break.
  float cut = 0.45 + 0.4 * coverAbove.w;
  vec3 side = normalize(vec3(cos(coverForm.y * 3.0), 0.5, sin(coverForm.y * 3.0)));
  float over = max(dot(shape, side) - cut, 0.0);
  shape -= side * over;
  float c = cos(coverForm.y), s = sin(coverForm.y);
  vec3 scaled = vec3(shape.x * 1.2, shape.y, shape.z * 0.85);
  vec3 turned = vec3(scaled.x * c - scaled.z * s, scaled.y, scaled.x * s + scaled.z * c);
  vec3 up = normalize(mix(vec3(0.0, 1.0, 0.0), coverNormal.xyz, 0.8));
  float heightM = coverFoot.w * 0.62;
  vec3 aside = vec3(turned.x, -(turned.x * up.x + turned.z * up.z) / max(up.y, 0.3), turned.z) * coverForm.x;
  StoneVertex result;
  result.relative = coverFoot.xyz + aside + up * (heightM * (turned.y + 0.6));
  result.inStone = shape * coverForm.x;
  vec3 bent = ball - 0.6 * (dents.xyz - ball * dot(dents.xyz, ball));
  result.outwards = normalize(vec3(bent.x * c - bent.z * s, 0.0, bent.x * s + bent.z * c) + up * bent.y);
  return result;
}
