// A fragment of an impostor: one fetch, of a view that is chosen by dither among the four around.
#include "vegetation/lit_tree.glsl"
#include "vegetation/leaves.glsl"

layout(binding = 6) uniform sampler2D treeAtlas;
uniform float impostorViews;

const float kMeanNormal = 1.25;  // normals that are filtered grow shorter
// Where a pixel covers many texels they grow shorter still, which is no less light: then the light is that of a crown in
// the mean.
const float kMeanLight = 1.0;
const vec2 kManyTexels = vec2(1.5, 5.0);

vec4 atlasTexel(vec2 inView, vec2 views, float kind, vec2 dither) {
  vec2 view = clamp(floor(views + dither), vec2(0.0), vec2(impostorViews - 1.0));
  vec2 at = (view + 0.5 + 0.5 * inView) / impostorViews;
  return textureGrad(treeAtlas, vec2(at.x, (at.y + kind) / 3.0), dFdx(inView) * (0.5 / impostorViews),
                     dFdy(inView) * vec2(0.5, 0.5 / 3.0) / impostorViews);
}

vec3 turnedBack(vec3 v, vec2 turn) { return vec3(v.x * turn.x + v.z * turn.y, v.y, v.z * turn.x - v.x * turn.y); }

// How far a pixel's share of a view is from showing single texels, [0, 1].
float manyTexels(vec2 inView) {
  vec2 across = max(abs(dFdx(inView)), abs(dFdy(inView))) * (0.5 * float(textureSize(treeAtlas, 0).x) / impostorViews);
  return smoothstep(kManyTexels.x, kManyTexels.y, max(across.x, across.y));
}

// rgb: light, a: whether it is drawn (negative: not). many: manyTexels().
vec4 impostorColor(vec4 texel, float many, TreeLight light, vec2 open, vec2 turn) {
  vec3 lit = texel.rgb / max(texel.a, 0.02) * 2.0 - 1.0;
  float left = length(lit);
  vec3 normal = turnedBack(lit / max(left, 1e-3), turn);
  left = mix(min(left / kBakedLight * kMeanNormal, 1.6), kMeanLight, many);
  open.x *= saturate((left - 0.55) * 1.8 + 0.15);
  vec3 sunny = treeRadiance(TreeLight(light.sun, light.above, light.below, vec3(0.0)), normal, open.x,
                            open.y, vec3(1.0)) * left;
  return vec4(sunny + light.air, texel.a - 0.38);
}
