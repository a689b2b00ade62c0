// The pages of signed distances. One of PAGE_SHAPES, PAGE_NORMALS, PAGE_SHADOWS, PAGE_BLENDS, PAGE_OPERATORS and
// PAGE_OCCLUSION is defined.
#include "lab/surface.glsl"

#if defined(PAGE_SHAPES) || defined(PAGE_NORMALS)
vec3 toSun() { return sunOf(knob_sunAzimuthDegrees, knob_sunElevationDegrees); }

// Lines of equal distance: every tenth of a unit, heavier on the surface.
vec3 isolines(float distance, float pixel) {
  float tenths = abs(fract(distance * 10.0 + 0.5) - 0.5) / 10.0;
  vec3 color = distance < 0.0 ? vec3(0.25, 0.12, 0.05) : mix(vec3(0.02, 0.08, 0.14), kPaper, saturate(distance));
  color = mix(color, color * 2.5 + 0.03, saturate(1.0 - tenths / pixel));
  return mix(color, kInk, saturate(2.0 - abs(distance) / pixel));
}
#endif

#ifdef PAGE_SHAPES
vec3 pageColor(vec2 pixel) {
  Panel panel;
  if (panelAt(pixel, vec2(0.0), vec2(0.62, 1.0), panel)) {
    Orbit eye = eyeAround(vec3(0.0, 0.6, 0.0));
    Seen seen = seenBy(eye, panel.at, kShapesScene, 0.0);
    if (!seen.hit) return kSky;
    vec3 normal = normalAt(kShapesScene, 0.0, seen.place, knob_epsilon);
    PhongShares shares = PhongShares(knob_ambient, knob_diffuse, knob_specular, knob_shininess);
    return withSky(litColor(seen, normal, shares, toSun(), 1.0), seen, eye.place);
  }
  if (!panelAt(pixel, vec2(0.62, 0.0), vec2(1.0), panel)) return vec3(0.0);
  float scale = 2.6 / panel.aspect;
  vec3 place = vec3(panel.at.x * scale, knob_cutHeight, -panel.at.y * scale);
  return isolines(sceneDistance(kShapesScene, 0.0, place), panel.pixel * scale);
}
#endif

#ifdef PAGE_NORMALS
vec3 pageColor(vec2 pixel) {
  Panel panel;
  bool upper = panelAt(pixel, vec2(0.62, 0.5), vec2(1.0), panel);
  if (!upper && panelAt(pixel, vec2(0.62, 0.0), vec2(1.0, 0.5), panel)) return plotColor(panel);
  if (!upper && !panelAt(pixel, vec2(0.0), vec2(0.62, 1.0), panel)) return vec3(0.0);
  Orbit eye = eyeAround(vec3(0.0));
  Seen seen = seenBy(eye, panel.at, kTorusScene, 0.0);
  if (!seen.hit) return kSky;
  vec3 normal = normalAt(kTorusScene, 0.0, seen.place, knob_epsilon);
  if (upper) {
    float error = length(normal - torusGradient(seen.place, 0.7));
    return heatColor(log2(max(error, 1e-7) * 1e7) / 24.0);
  }
  PhongShares shares = PhongShares(knob_ambient, knob_diffuse, knob_specular, knob_shininess);
  vec2 light = phongLight(shares, normal, toSun(), -seen.direction);
  return (normal * 0.5 + 0.5) * (shares.ambient + light.x) + light.y;
}
#endif

#ifdef PAGE_SHADOWS
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 3, 1, panel);
  if (which < 0) return vec3(0.0);
  Orbit eye = eyeAround(vec3(0.0, 0.8, 0.0));
  Seen seen = seenBy(eye, panel.at * 1.5, kShadowScene, 0.0);
  if (!seen.hit) return kSky;
  vec3 normal = normalAt(kShadowScene, 0.0, seen.place, 1e-3);
  vec3 sun = sunOf(knob_sunAzimuthDegrees, knob_sunElevationDegrees);
  float hardness = which == 0 ? 1e9 : which == 1 ? knob_hardness : knob_softHardness;
  Shade shade = Shade(0.0, 0);
  if (dot(normal, sun) > 0.0) {
    shade = shadeAlong(kShadowScene, 0.0, seen.place, sun, knob_start, 10.0, hardness, int(knob_mostSteps));
  }
  return withSky(litColor(seen, normal, kUsualShares, sun, shade.light), seen, eye.place);
}
#endif

#if defined(PAGE_BLENDS) || defined(PAGE_OPERATORS)
// A panel is wide or high: the scene fits into either.
vec3 bodyColor(Panel panel, int scene, float amount) {
  Orbit eye = eyeAround(vec3(0.0, 0.9, 0.0));
  Seen seen = seenBy(eye, panel.at * max(1.0, 1.0 / panel.aspect), scene, amount);
  if (!seen.hit) return kSky;
  vec3 normal = normalAt(scene, amount, seen.place, 1e-3);
  vec3 sun = sunOf(60.0, 50.0);
  float shade = dot(normal, sun) > 0.0 ? shadeAlong(scene, amount, seen.place, sun, 0.02, 8.0, 12.0, 32).light : 0.0;
  return withSky(litColor(seen, normal, kUsualShares, sun, shade), seen, eye.place);
}
#endif

#ifdef PAGE_BLENDS
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 2, 1, panel);
  if (which == 0) return bodyColor(panel, kBlendScene, knob_share);
  return which == 1 ? bodyColor(panel, kSmoothScene, knob_width) : vec3(0.0);
}
#endif

#ifdef PAGE_OPERATORS
vec3 pageColor(vec2 pixel) {
  Panel panel;
  if (panelAt(pixel, vec2(0.0), vec2(0.66, 1.0), panel)) return bodyColor(panel, kHolesScene, knob_share);
  int which = gridPanel(pixel, vec2(0.66, 0.0), vec2(1.0), 1, 3, panel);
  if (which == 0) return bodyColor(panel, kUnionScene, 0.0);
  if (which == 1) return bodyColor(panel, kIntersectionScene, 0.0);
  return which == 2 ? bodyColor(panel, kDifferenceScene, 0.0) : vec3(0.0);
}
#endif

#ifdef PAGE_OCCLUSION
vec3 pageColor(vec2 pixel) {
  Panel panel;
  int which = gridPanel(pixel, vec2(0.0), vec2(1.0), 2, 1, panel);
  if (which < 0) return vec3(0.0);
  Orbit eye = eyeAround(vec3(0.0, 0.9, 0.0));
  Seen seen = seenBy(eye, panel.at, kHolesScene, 0.5);
  if (!seen.hit) return which == 0 ? kSky : vec3(0.0);
  vec3 normal = normalAt(kHolesScene, 0.5, seen.place, 1e-3);
  float open = opennessAt(kHolesScene, 0.5, seen.place, normal, knob_stride, int(knob_count), knob_intensity);
  if (which == 1) return vec3(1.0 - open, 0.0, 0.0);
  vec3 color = litColor(seen, normal, kUsualShares, sunOf(60.0, 50.0), 1.0);
  return withSky(color * open, seen, eye.place);
}
#endif
