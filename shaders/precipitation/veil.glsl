// Rain and snow over distances: at the corners of a grid over the picture, optical depth up to four distances and the light
// of what falls (render::RainVeilPass).
#include "frame.glsl"
#include "precipitation/rain_map.glsl"
#ifdef CLOUD_SHADE
#include "clouds/shadow_map.glsl"
#endif

uniform vec4 fallLayer;  // base and top above the sea (m), mm/h on the ground, evaporation (mm/h a metre)
uniform vec4 fallKind;   // height of freezing (m), share of snow on the ground, metres aside a metre of fall (x, z)
uniform ivec2 gridSize;  // columns and rows
uniform vec2 veilSpan;   // how far it reaches (m), steps of a ray

const float kSpans = 4.0;         // of a ray, each four times as long as the one before
const float kFallForward = 0.75;  // anisotropy of light that drops scatter once
const float kFallOnce = 0.5;      // of that in what a shaft sends; the rest has lost its direction

FallField fallFieldOfFrame() {
  FallField field;
  field.baseM = fallLayer.x;
  field.topM = fallLayer.y;
  field.groundRate = fallLayer.z;
  field.evaporation = fallLayer.w;
  field.freezingM = fallKind.x;
  field.snowShare = fallKind.y;
  return field;
}

struct Veil {
  vec4 depths;  // optical depth within each span
  vec3 light;   // of a thick veil, as it reaches the eye
  float seenM;  // where most of it comes from
  float reachM; // where the last span ends
};

// Shares of light below the clouds, as frame.glsl has them.
vec3 lightBelowClouds(vec3 relative) {
#ifdef CLOUD_SHADE
  return lightThroughClouds(relative);
#else
  return kOpenSky;
#endif
}

vec3 lightOfFall(vec3 direction, vec3 relative) {
  vec3 shares = lightBelowClouds(relative);
  float phase = mix(1.0 / (4.0 * kPi), henyeyGreenstein(dot(direction, frame.toSun.xyz), kFallForward), kFallOnce);
  // Below clouds the light of the sky is white: they scatter all colours alike.
  vec3 around = (frame.skyLight.xyz + frame.groundLight.xyz) * (shares.y * 0.5 / kPi);
  around = mix(vec3(dot(around, vec3(0.2126, 0.7152, 0.0722))), around, shares.y);
  // What clouds have scattered of the sun's comes from above, from half of all directions.
  return frame.sunLight.xyz * (shares.x * phase) + around + diffuseSun(shares) * (0.5 / kPi);
}

// Where a ray leaves what falls, upwards or into the sea, m; at most where it is no longer seen.
float reachOf(FallField field, float rise) {
  float roomM = rise > 0.0 ? max(field.topM - frame.eye.x, 0.0) : 1.3 * max(frame.eye.x, 0.0) + 100.0;
  return clamp(roomM / max(abs(rise), 1e-6), 100.0, veilSpan.x);
}

// Where the spans of a ray end, as shares of its reach.
const vec4 kSpanEnds = vec4(1.0 / 64.0, 1.0 / 16.0, 0.25, 1.0);
// A share of the reach times the one less the other goes from 0 to 1 over a span.
const vec4 kSpanScales = vec4(64.0, 64.0 / 3.0, 16.0 / 3.0, 4.0 / 3.0);
const vec4 kSpanOffsets = vec4(0.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0);

vec2 gridPlace(int vertex) {
  ivec2 corner = ivec2(vertex % (gridSize.x + 1), vertex / (gridSize.x + 1));
  return vec2(corner) / vec2(gridSize) * 2.0 - 1.0;
}

Veil veilTowards(vec2 ndc) {
  vec3 direction = normalize((frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz);
  FallField field = fallFieldOfFrame();
  float cellAngle = frame.depthToSea.w * frame.viewport.x / float(gridSize.x);
  int steps = int(veilSpan.y / kSpans);
  Veil veil = Veil(vec4(0.0), vec3(0.0), 0.0, reachOf(field, direction.y));
  float through = 1.0, fromM = 0.0;
  vec3 light = vec3(0.0);
  for (int span = 0; span < 4; ++span) {
    float toM = veil.reachM * kSpanEnds[span];
    float stepM = (toM - fromM) / float(steps);
    for (int i = 0; i < steps; ++i) {
      float alongM = fromM + (float(i) + 0.5) * stepM;
      vec3 relative = direction * alongM;
      float heightM = frame.eye.x + relative.y + alongM * alongM * 7.8e-8;  // over the round earth
      float fallen = max(field.baseM - heightM, 0.0);
      float share = rainShareAt(relative.xz - fallKind.zw * fallen, max(alongM * cellAngle, 0.5 * stepM));
      float rate = fallRate(field, heightM, share);
      float depth = fallExtinction(rate, snowAt(field, heightM)) * stepM * smoothstep(1.0, 0.7, alongM / veilSpan.x);
      float left = exp(-depth), taken = through * (1.0 - left);
      if ((i & 1) == 0) light = lightOfFall(direction, relative);  // of two steps
      veil.light += light * taken;
      veil.seenM += alongM * taken;
      veil.depths[span] += depth;
      through *= left;
    }
    fromM = toM;
  }
  float opacity = max(1.0 - through, 1e-6);
  veil.seenM = max(veil.seenM / opacity, 1.0);
  veil.light = min(applyAerialPerspective(veil.light / opacity, direction * veil.seenM), vec3(kBrightest));
  return veil;
}
