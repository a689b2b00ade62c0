// The pages of clouds. One of PAGE_SAMPLES, PAGE_EXPONENTIAL, PAGE_DENSITY, PAGE_FORWARD, PAGE_LIGHT and PAGE_MOODS is
// defined. The noise of the cube comes in a volume, which the processor made from the same text.
#include "lab/frame.glsl"
#include "shared/lab/cloud.glsl"

layout(binding = 0) uniform sampler3D noises;  // x: Perlin, y: Voronoi; repeats

const float kZoom = 1.8;
const vec3 kSky = vec3(0.1, 0.2, 0.4);
const vec3 kSunLight = vec3(3.0, 2.8, 2.5);
const vec3 kSkyLight = vec3(0.14, 0.18, 0.26);

CubeCloud cubeCloud(float threshold) {
  return CubeCloud(uint(knob_cells), uint(knob_seed), knob_perlinThreshold + threshold, knob_perlinMultiplier,
                   knob_voronoiThreshold + threshold, knob_voronoiMultiplier);
}

float densityAt(vec3 place, int which) {
  vec2 densities = cubeDensities(cubeCloud(0.0), textureLod(noises, place, 0.0).xy);
  return which == 0 ? densities.x : densities.y;
}

Orbit eyeAround() {
  return make_orbit(vec3(0.5), radiansOf(knob_view_azimuthDegrees), radiansOf(knob_view_elevationDegrees),
                    knob_view_distance);
}

RaySpan spanOf(Orbit eye, vec3 direction) { return raySpanOfBox(eye.place, direction, vec3(0.0), vec3(1.0)); }

vec3 toSunOf(float azimuthDegrees, float elevationDegrees) {
  return -make_orbit(vec3(0.0), radiansOf(azimuthDegrees), radiansOf(elevationDegrees), 1.0).ahead;
}

// The optical depth along a ray through the cube, by so many samples.
float depthAlong(vec3 origin, vec3 direction, RaySpan span, int samples, int which) {
  float stride = (span.end - span.begin) / float(max(samples, 1));
  float sum = 0.0;
  for (int i = 0; i < samples; ++i) {
    sum += densityAt(origin + direction * (span.begin + (float(i) + 0.5) * stride), which);
  }
  return sum * stride * knob_extinction;
}

#ifdef PAGE_SAMPLES
vec3 pageColor(vec2 pixel) {
  Panel panel;
  Orbit eye = eyeAround();
  if (panelAt(pixel, vec2(0.0), vec2(0.5, 1.0), panel)) {
    // A level cut, and the samples of one ray through it.
    vec2 at = panel.at / min(panel.aspect, 1.0) * 0.62 + 0.5;
    float size = panel.pixel / min(panel.aspect, 1.0) * 0.62;
    vec3 color = kPaper;
    if (all(greaterThan(at, vec2(0.0))) && all(lessThan(at, vec2(1.0))))
      color = vec3(1.0 - exp(-0.2 * knob_extinction * densityAt(vec3(at.x, 0.5, at.y), 1))) + 0.02;
    vec2 from = vec2(-0.08, 0.3);
    vec2 way = directionOf(vec3(1.0, 0.35, 0.0), vec3(1.0, 0.0, 0.0)).xy;
    RaySpan span = raySpanOfBox(vec3(from, 0.5), vec3(way, 0.0), vec3(0.0), vec3(1.0));
    color = mix(color, vec3(0.4), markLine(at, from, from + way * (span.end + 0.1), size));
    float stride = (span.end - span.begin) / max(knob_steps, 1.0);
    for (int i = 0; i < int(knob_steps); ++i) {
      vec2 here = from + way * (span.begin + (float(i) + 0.5) * stride);
      float dense = saturate(densityAt(vec3(here.x, 0.5, here.y), 1));
      color = mix(color, mix(curveColor(1), curveColor(0), dense > 0.0 ? 1.0 : 0.0), markDisc(at, here, (2.0 + 3.0 * dense) * size, size));
    }
    return color;
  }
  if (!panelAt(pixel, vec2(0.5, 0.0), vec2(1.0), panel)) return vec3(0.0);
  vec3 direction = orbitRay(eye, panel.at, kZoom);
  RaySpan span = spanOf(eye, direction);
  if (span.end <= span.begin) return vec3(0.6);
  // The plain sum, as darkness.
  return vec3(0.55 * saturate(1.0 - 0.4 * depthAlong(eye.place, direction, span, int(knob_steps), 1)));
}
#endif

#ifdef PAGE_EXPONENTIAL
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(0.4, 1.0), 1, 2, panel);
  if (which >= 0) {
    float x = panel.uv.x * 6.0;
    float value = which == 0 ? exp(-x) : stepOpacity(x);
    float slope = (which == 0 ? -exp(-x) : exp(-x)) * 6.0 / panel.aspect;
    return mix(plotPaper(panel.uv), curveColor(which), markValue(panel.uv.y, value, slope, 0.5 * panel.pixel));
  }
  which = gridPanel(pixel, vec2(0.4, 0.0), vec2(1.0), 1, 2, panel);
  if (which < 0) return vec3(0.0);
  Orbit eye = eyeAround();
  vec3 direction = orbitRay(eye, panel.at * 1.1, kZoom);
  RaySpan span = spanOf(eye, direction);
  float depth = span.end > span.begin ? depthAlong(eye.place, direction, span, int(knob_steps), 1) : 0.0;
  // Above the sum itself as opacity, cut at 1; below by the exponential.
  return mix(kSky, vec3(0.8), which == 0 ? saturate(depth) : stepOpacity(depth));
}
#endif

// Light with the sun's depth by so many samples on the way to the edge of the cube.
CubeLight lightAlong(vec3 origin, vec3 direction, RaySpan span, vec3 toSun, int steps, int lightSamples) {
  CubeLight light = make_cubeLight();
  float stride = (span.end - span.begin) / float(max(steps, 1));
  for (int i = 0; i < steps; ++i) {
    vec3 place = origin + direction * (span.begin + (float(i) + 0.5) * stride);
    float depth = knob_extinction * stride * densityAt(place, 1);
    if (depth <= 0.0) continue;
    RaySpan toEdge = raySpanOfBox(place, toSun, vec3(0.0), vec3(1.0));
    light = afterStep(light, depth, depthAlong(place, toSun, toEdge, lightSamples, 1));
  }
  return light;
}

vec3 lightColor(CubeLight light, float cosAngle, vec3 behind, float exposure) {
  float phase = 0.5 * (henyeyGreenstein(cosAngle, 0.6) + henyeyGreenstein(cosAngle, -0.2)) * 4.0 * kPi;
  return behind * light.transmittance + kSunLight * phase * light.sun * exposure + kSkyLight * light.sky;
}

#ifdef PAGE_DENSITY
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 2, 1, panel);
  if (which < 0) return vec3(0.0);
  Orbit eye = eyeAround();
  vec3 direction = orbitRay(eye, panel.at, kZoom);
  RaySpan span = spanOf(eye, direction);
  if (span.end <= span.begin) return kSky;
  return mix(kSky, vec3(0.8), stepOpacity(depthAlong(eye.place, direction, span, int(knob_steps), which)));
}
#endif

#ifdef PAGE_FORWARD
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 4, 1, panel);
  if (which < 0) return vec3(0.0);
  Orbit eye = eyeAround();
  panel.at *= max(1.0, 0.9 / panel.aspect);
  vec3 direction = orbitRay(eye, panel.at, kZoom);
  // The sun is behind the cube, somewhat above its middle.
  vec2 sunAt = vec2(0.12, 0.18);
  vec3 toSun = orbitRay(eye, sunAt, kZoom);
  float away = length(panel.at - sunAt);
  vec3 behind = kSky + kSunLight * saturate((0.07 - away) / panel.pixel);
  RaySpan span = spanOf(eye, direction);
  if (span.end <= span.begin) return behind;
  if (which < 2) {
    float depth = depthAlong(eye.place, direction, span, int(knob_steps), 1);
    float sun = forwardedSun(away, knob_sunReach, knob_sunStrength) * (which == 1 ? exp(-depth) : 1.0);
    return mix(behind, vec3(0.25, 0.27, 0.3), stepOpacity(depth)) + 0.5 * kSunLight * sun * stepOpacity(depth);
  }
  int steps = which == 2 ? int(knob_steps) : 40;
  int lightSamples = which == 2 ? int(knob_lightSamples) : 16;
  return lightColor(lightAlong(eye.place, direction, span, toSun, steps, lightSamples), dot(direction, toSun), behind, 0.1);
}
#endif

#ifdef PAGE_LIGHT
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.62, 0.0), vec2(1.0), 1, 2, panel);
  if (which == 1) return plotColor(panel);
  if (which < 0 && !panelAt(pixel, vec2(0.0), vec2(0.62, 1.0), panel)) return vec3(0.0);
  Orbit eye = eyeAround();
  vec3 direction = orbitRay(eye, panel.at, kZoom);
  vec3 toSun = toSunOf(knob_sunAzimuthDegrees, knob_sunElevationDegrees);
  RaySpan span = spanOf(eye, direction);
  if (span.end <= span.begin) return which == 0 ? vec3(0.0) : kSky;
  CubeLight light = lightAlong(eye.place, direction, span, toSun, int(knob_steps), int(knob_lightSamples));
  if (which < 0) return lightColor(light, dot(direction, toSun), kSky, 0.35);
  CubeLight finer = lightAlong(eye.place, direction, span, toSun, int(knob_steps), 16);
  return heatColor(8.0 * abs(light.sun - finer.sun));
}
#endif

#ifdef PAGE_MOODS
float moodDensity(vec3 place, CubeMood mood) {
  vec3 at = vec3(place.x, place.y * 0.5 + 0.21, place.z);
  float edge = saturate(min(place.y, 1.0 - place.y) * 5.0);
  return cubeDensities(cubeCloud(mood.threshold), textureLod(noises, at, 0.0).xy).y * edge;
}

vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 3, 2, panel);
  if (which < 0) return vec3(0.0);
  CubeMood mood = cubeMood(which);
  // Under a layer of clouds of the height 1, a unit up, whose cubes repeat.
  Orbit eye = make_orbit(vec3(0.0), radiansOf(knob_view_azimuthDegrees), radiansOf(knob_view_elevationDegrees - 45.0), 0.0);
  vec3 direction = orbitRay(eye, panel.at, 1.3);
  vec3 toSun = toSunOf(knob_view_azimuthDegrees + 205.0, mood.sunElevation);
  float up = max(direction.y, 0.0);
  vec3 behind = mix(mood.horizon, mood.zenith, pow(saturate(up), 0.45));
  float cosAngle = dot(direction, toSun);
  behind += mood.sunColor * mood.sunStrength * (0.08 * pow(saturate(cosAngle), 30.0) + smoothstep(0.9993, 0.9996, cosAngle));
  if (up < 0.03) return behind;
  float stride = 1.0 / up / knob_steps;
  float begin = 1.0 / up;
  CubeLight light = make_cubeLight();
  float extinction = knob_extinction * mood.extinction;
  for (int i = 0; i < int(knob_steps); ++i) {
    vec3 place = direction * (begin + (float(i) + 0.5) * stride) - vec3(0.0, 1.0, 0.0);
    float depth = extinction * stride * moodDensity(place * vec3(0.35, 1.0, 0.35), mood);
    if (depth <= 0.0) continue;
    float sunWay = (1.0 - place.y) / max(toSun.y, 0.15) / knob_lightSamples;
    float sunDepth = 0.0;
    for (int j = 0; j < int(knob_lightSamples); ++j) {
      vec3 there = place + toSun * (float(j) + 0.5) * sunWay;
      sunDepth += extinction * sunWay * moodDensity(there * vec3(0.35, 1.0, 0.35), mood);
    }
    light = afterStep(light, depth, 0.4 * sunDepth);
  }
  float phase = 0.6 * henyeyGreenstein(cosAngle, 0.6) * 4.0 * kPi + 0.5;
  vec3 cloud = mood.sunColor * mood.sunStrength * phase * light.sun * 0.2 + mix(mood.zenith, mood.horizon, 0.6) * 0.8 * light.sky;
  // Far away it fades into the horizon.
  return mix(mood.horizon, behind * light.transmittance + cloud, smoothstep(0.03, 0.2, up));
}
#endif
