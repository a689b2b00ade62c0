// Puts what the sea mirrors of the scene in place of the sky that its light has.
#include "terrain/surface.glsl"
#include "water/sea_pixel.glsl"

layout(binding = 6) uniform sampler2D mirrored;
layout(binding = 7) uniform sampler2D keptMirror;  // render::SeaWaves::mirror
uniform int spacing;

// Four looks a texel apart: neighbours follow other slopes, and this is the mean of four of them everywhere.
vec4 mirroredAt(ivec2 pixel) {
  vec2 at = (vec2(pixel) - float(spacing / 2)) / float(spacing) + 0.5;
  vec2 perTexel = 1.0 / vec2(textureSize(mirrored, 0));
  vec4 aside = vec4(-0.5, 0.5, -0.5, 0.5);
  return 0.25 * (texture(mirrored, (at + aside.xz) * perTexel) + texture(mirrored, (at + aside.yz) * perTexel) +
                 texture(mirrored, (at + aside.xw) * perTexel) + texture(mirrored, (at + aside.yw) * perTexel));
}

bool mirrorsAt(ivec2 pixel) { return mirroredAt(pixel).a > 0.004 && isSeaAt(pixel, sceneViewZ(pixel), rayOf(pixel)); }

// To be added to the light of a pixel. What is mirrored has come about as far through the air as the scene has.
vec3 mirroredLight(ivec2 pixel) {
  vec4 kept = texelFetch(keptMirror, pixel, 0);
  vec4 scene = mirroredAt(pixel);
  return kept.a * (scene.rgb - kept.rgb * scene.a);
}
