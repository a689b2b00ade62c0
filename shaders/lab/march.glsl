// The pages of ray marching. MARCH_METHOD is the way to march.
#include "lab/surface.glsl"

const int kMethod = MARCH_METHOD;
const float kSplit = 0.62;

MarchLimits limits() { return make_marchLimits(knob_stride, knob_tolerance, knob_reach); }

March marchOf(vec3 origin, vec3 direction) {
  return marchAlong(kMethod, kBallScene, 0.0, origin, direction, limits(), int(knob_mostSteps));
}

vec3 picture(Panel panel, Orbit eye) {
  Seen seen;
  seen.direction = orbitRay(eye, panel.at, kZoom);
  March march = marchOf(eye.place, seen.direction);
  seen.hit = march.state == kHit;
  seen.place = eye.place + seen.direction * march.t;
  vec3 color = kSky;
  if (seen.hit) {
    vec3 normal = normalAt(kBallScene, 0.0, seen.place, 1e-3);
    color = withSky(litColor(seen, normal, kUsualShares, sunOf(60.0, 45.0), 1.0), seen, eye.place);
  }
  // Where the ray of the cut is.
  return mix(color, kInk, markCircle(panel.at, vec2(0.0, knob_aim), 4.0 * panel.pixel, panel.pixel));
}

vec3 heat(Panel panel, Orbit eye) {
  March march = marchOf(eye.place, orbitRay(eye, panel.at, kZoom));
  return heatColor(float(march.steps) / max(knob_mostSteps, 1.0));
}

// The upright plane through the eye and the ray: its ground behind, then places and distances of the ray.
vec3 cut(Panel panel, Orbit eye) {
  vec3 level = directionOf(vec3(eye.ahead.x, 0.0, eye.ahead.z), vec3(0.0, 0.0, -1.0));
  vec3 direction = orbitRay(eye, vec2(0.0, knob_aim), kZoom);
  // From behind the eye to beyond the ball.
  float away = dot(-eye.place, level);
  float height = max(3.0, eye.place.y + 0.4);
  float scale = max((away + 2.0) / (2.0 * panel.aspect), (height + 0.4) / 2.0);
  vec2 at = vec2(panel.uv.x * 2.0 * panel.aspect * scale - 0.3, (panel.uv.y * 2.0) * scale - 0.4);
  float pixel = panel.pixel * scale;
  vec3 place = vec3(eye.place.x, 0.0, eye.place.z) + level * at.x + vec3(0.0, at.y, 0.0);
  float distance = sceneDistance(kBallScene, 0.0, place);
  vec3 color = kPaper;
  if (distance < 0.0) color = vec3(0.3, 0.17, 0.09);
  vec2 from = vec2(0.0, eye.place.y);
  vec2 along = vec2(dot(direction, level), direction.y);
  March march = make_march(knob_stride);
  float most = min(knob_mostSteps, 200.0);
  vec3 marks = vec3(0.0);  // disc, circle, line
  for (int i = 0; i < int(most) && march.state == kUnderWay; ++i) {
    vec2 here = from + along * march.t;
    march = nextStep(kMethod, limits(), sceneDistance(kBallScene, 0.0, eye.place + direction * march.t), march);
    marks.x = max(marks.x, markDisc(at, here, 2.2 * pixel, pixel));
    if (kMethod == kSphereTracing) marks.y = max(marks.y, markCircle(at, here, march.distance, pixel));
  }
  marks.z = markLine(at, from, from + along * march.t, pixel);
  color = mix(color, vec3(0.1, 0.25, 0.4), marks.y);
  color = mix(color, vec3(0.35), marks.z);
  return mix(color, march.state == kHit ? vec3(1.0, 0.4, 0.1) : vec3(0.3, 0.6, 1.0), marks.x);
}

vec3 pageColor(vec2 pixel) {
  Orbit eye = eyeAround(vec3(0.0, 1.0, 0.0));
  Panel panel;
  if (panelAt(pixel, vec2(0.0), vec2(kSplit, 1.0), panel)) return picture(panel, eye);
  if (panelAt(pixel, vec2(kSplit, 0.5), vec2(1.0), panel)) return heat(panel, eye);
  if (panelAt(pixel, vec2(kSplit, 0.0), vec2(1.0, 0.5), panel)) return cut(panel, eye);
  return vec3(0.0);
}
