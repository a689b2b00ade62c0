// Where a frame's land and sea are, for the programs that give them light.
#include "frame.glsl"
#include "shared/terrain_grid.glsl"

uniform vec3 eyeFromBase;  // x, z: metres from the base (a chunk corner near the eye); y: height above the sea
uniform ivec2 baseChunk;   // of the base, level 0, wrapped to 20 bits with sign
uniform float farM;        // where land ends

// Towards the end of the land everything turns into the haze that stands at the horizon, so that the end is not seen:
// the share of a surface's own light that is left.
float leftOfLight(vec3 relative) { return 1.0 - smoothstep(0.6 * farM, 0.97 * farM, length(relative.xz)); }

// The distance along the view axis of the land's depth at a pixel; kFarMarker where there is none.
layout(binding = 3) uniform sampler2D landDepth;
float landViewZ(ivec2 pixel) { return viewZOfDepth(texelFetch(landDepth, pixel, 0).r, frame.eye.y); }

// What clouds and what flies leave of the light at each pixel of the land (frame.glsl); its last channel belongs to nobody.
layout(binding = 4) uniform sampler2D lightShares;
vec3 keptSharesAt(ivec2 pixel) { return texelFetch(lightShares, pixel, 0).rgb; }

// Where the land of a pixel is, relative to the eye; where it shows none, far away.
vec3 landPlace(ivec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) * frame.viewport.zw * 2.0 - 1.0;
  return (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz * min(landViewZ(pixel), 1e9);
}
