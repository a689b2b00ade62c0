// Dust, mist and smoke: soft balls, each with a side towards the light.
#include "spray/particle.glsl"

struct Puff {
  vec4 position;
  vec2 corner;
  vec4 look;  // opacity, turn, view distance along the axis, softness (m)
  vec3 place;
};

Puff puffCorner(int vertex) {
  Particle particle = particleOf(burstSeed.y + vertex / 6);
  vec2 corner = kCorners[vertex % 6];
  float distanceM = length(particle.middle);
  vec3 toEye = -particle.middle / max(distanceM, 1e-3);
  vec3 right = normalize(cross(abs(toEye.y) < 0.99 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), toEye));
  vec3 up = cross(toEye, right);
  // It lies on the ground rather than in it.
  vec3 middle = particle.middle + burstUp.xyz * (0.45 * particle.radiusM);
  Puff puff;
  puff.corner = corner;
  puff.place = middle + (right * corner.x + up * corner.y) * particle.radiusM;
  float fade = smoothstep(0.0, 0.06, particle.age) * pow(1.0 - particle.age, 1.3) * nearFade(distanceM);
  puff.position = clipOf(puff.place, particle.opacity * fade);
  puff.look = vec4(particle.opacity * fade, particle.turn, puff.position.w, 0.8 * particle.radiusM);
  return puff;
}
