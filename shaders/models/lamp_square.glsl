// Where the square of a lamp lies, and how much of the lamp is hidden.
#include "models/lamps_seen.glsl"

layout(binding = 8) uniform sampler2D lampDepth;

// A lamp lies on a surface, which must not hide it.
const float kBesideM = 0.25;

vec4 clipOfLamp(int lamp) { return frame.viewProjection * vec4(glowPlaces[lamp].xyz, 1.0); }

// Share of five pixels around a lamp in which nothing is nearer.
float shownShare(vec4 clip) {
  vec2 pixel = (clip.xy / clip.w * 0.5 + 0.5) * frame.viewport.xy;
  float nearest = depthOfViewZ(max(clip.w - kBesideM, frame.eye.y), frame.eye.y);
  float shown = 0.0;
  for (int i = 0; i < 5; ++i) {
    vec2 aside = i == 0 ? vec2(0.0) : i < 3 ? vec2(float(2 * i - 3), 0.0) : vec2(0.0, float(2 * i - 7));
    ivec2 at = ivec2(clamp(pixel + aside, vec2(0.0), frame.viewport.xy - 1.0));
    shown += texelFetch(lampDepth, at, 0).r <= nearest ? 0.2 : 0.0;
  }
  return shown;
}

// Two triangles; behind the eye, and where nothing of it is seen, none.
vec2 glowAside(int vertex) {
  int corner = vertex % 6;
  return vec2(corner == 1 || corner == 2 || corner == 4 ? 1.0 : -1.0, corner == 2 || corner > 3 ? 1.0 : -1.0) *
         glowVeils[vertex / 6].w;
}

vec4 glowCorner(vec4 clip, vec2 pixelsAside, float shown) {
  if (clip.w <= frame.eye.y || shown <= 0.0) return vec4(0.0, 0.0, -1.0, 1.0);
  return vec4(clip.xy + pixelsAside * 2.0 * frame.viewport.zw * clip.w, clip.zw);
}
