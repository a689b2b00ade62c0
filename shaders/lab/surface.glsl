// A scene of the laboratory as a picture: found by sphere tracing unless told otherwise, lit by Phong's light.
#include "lab/frame.glsl"
#include "shared/lab/light.glsl"

const float kZoom = 1.8;
const vec3 kSky = vec3(0.1, 0.16, 0.26);
const PhongShares kUsualShares = PhongShares(0.15, 0.75, 0.3, 24.0);

vec3 sunOf(float azimuthDegrees, float elevationDegrees) {
  return -make_orbit(vec3(0.0), radiansOf(azimuthDegrees), radiansOf(elevationDegrees), 1.0).ahead;
}

Orbit eyeAround(vec3 middle) {
  return make_orbit(middle, radiansOf(knob_view_azimuthDegrees), radiansOf(knob_view_elevationDegrees),
                    knob_view_distance);
}

// A floor with squares of one unit, so that distances can be read; what stands on it is plain.
vec3 surfaceColor(vec3 place) {
  if (place.y > 1e-2) return vec3(0.75, 0.4, 0.2);
  vec2 square = floor(place.xz);
  return mod(square.x + square.y, 2.0) < 0.5 ? vec3(0.36) : vec3(0.28);
}

// Where the eye's ray ends; hit is false in the sky.
struct Seen {
  vec3 place;
  vec3 direction;
  bool hit;
  int steps;
};

Seen seenBy(Orbit eye, vec2 at, int scene, float amount) {
  Seen seen;
  seen.direction = orbitRay(eye, at, kZoom);
  March march = marchAlong(kSphereTracing, scene, amount, eye.place, seen.direction, make_marchLimits(1.0, 1e-3, 14.0), 80);
  seen.place = eye.place + seen.direction * march.t;
  seen.hit = march.state == kHit;
  seen.steps = march.steps;
  return seen;
}

// Fades into the sky, so that the end of the floor is no edge.
vec3 withSky(vec3 color, Seen seen, vec3 eye) {
  return mix(color, kSky, smoothstep(6.0, 14.0, length(seen.place - eye)));
}

vec3 litColor(Seen seen, vec3 normal, PhongShares shares, vec3 toSun, float shade) {
  vec2 light = phongLight(shares, normal, toSun, -seen.direction) * shade;
  return surfaceColor(seen.place) * (shares.ambient + light.x) + vec3(light.y);
}
