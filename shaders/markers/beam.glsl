// The beam's strip, upright and turned towards the eye.
uniform vec3 middle;
uniform vec3 across;
uniform float heightM;
uniform float halfWidthM;
uniform float leastHalfWidthRad;

vec3 beamVertex(vec3 position) {
  vec3 onAxis = middle + vec3(0.0, position.y * heightM, 0.0);
  return onAxis + across * (position.x * max(halfWidthM, length(onAxis) * leastHalfWidthRad));
}
