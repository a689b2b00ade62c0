// The light of a listed pixel: its own and that of the pixels across its edges, by the shares that they have of it, mixed
// as the screen shows them (shared/tone_map.glsl).
#include "shared/tone_map.glsl"
#include "edges/lists.glsl"
#include "edges/lights.glsl"

layout(binding = 0) uniform sampler2D sceneColor;

vec3 curveAt(ivec2 pixel) {
  ivec2 inside = clamp(pixel, ivec2(0), textureSize(sceneColor, 0) - 1);
  return toneCurve(max(texelFetch(sceneColor, inside, 0).rgb, vec3(0.0)));
}

// Across the rows or across the columns, whichever edge takes more of the pixel.
vec3 smoothedLight(ivec2 pixel) {
  vec4 all = unpackedShares(imageLoad(shares, pixel).x);
  bool acrossRows = all[kUp] + all[kDown] >= all[kRight] + all[kLeft];
  ivec2 toNext = acrossRows ? ivec2(0, 1) : ivec2(1, 0);
  vec2 ofSides = acrossRows ? vec2(all[kDown], all[kUp]) : vec2(all[kLeft], all[kRight]);
  vec3 curve = curveAt(pixel) * (1.0 - ofSides.x - ofSides.y) + curveAt(pixel - toNext) * ofSides.x +
               curveAt(pixel + toNext) * ofSides.y;
  return lightOfToneCurve(curve);
}

void blendListed(uint index) {
  if (index >= listedPixels.groups.w) return;
  ivec2 pixel = pixelInList(index);
  keepLight(index, pixel, smoothedLight(pixel));
}
