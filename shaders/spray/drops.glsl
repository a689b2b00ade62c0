// Drops and clods: tufts of grains that are drawn out along their way.
#include "spray/particle.glsl"

struct Tuft {
  vec4 position;
  vec2 corner;
  vec4 look;  // opacity, turn, view distance along the axis, share of its life that is over
  vec2 shape;  // length over width, pixels of the width
  vec3 light;
};

// Of what scatters and lets light through: brighter before the light, and on the burst's side towards it, for the tufts
// of a burst shade each other. `own` [0, 1): of the tuft.
vec3 tuftLight(vec3 toEye, vec3 fromMiddle, float own) {
  float lobe = 0.64 / pow(1.36 + 1.2 * dot(toEye, frame.toSun.xyz), 1.5);  // asymmetry .6
  float facing = 0.5 + 0.5 * dot(directionOf(fromMiddle, burstUp.xyz), frame.toSun.xyz);
  vec3 sun = frame.sunLight.xyz * (burstShares.x * (0.05 + (0.22 + 0.26 * own) * facing + 0.10 * lobe));
  vec3 around = mix(frame.groundLight.xyz, frame.skyLight.xyz, 0.6) * burstShares.y + diffuseSun(burstShares.xyz) * 0.6;
  return burstAlbedo.xyz / kPi * (sun + around * (0.55 + 0.4 * own));
}

Tuft tuftCorner(int vertex) {
  Particle particle = particleOf(burstSeed.y + vertex / 6);
  vec2 corner = kCorners[vertex % 6];
  float distanceM = length(particle.middle);
  vec3 toEye = -particle.middle / max(distanceM, 1e-3);
  float speed = length(particle.velocity);
  vec3 along = directionOf(particle.velocity, vec3(0.0, 1.0, 0.0));
  vec3 side = directionOf(cross(along, toEye), vec3(1.0, 0.0, 0.0));
  vec3 onPicture = cross(toEye, side);
  // Fast ones are longer; seen from ahead they are not.
  float seenAlong = abs(dot(along, onPicture));
  float stretch = 1.0 + (burstSize.w - 1.0) * seenAlong * saturate(speed / 6.0);
  float pixelM = distanceM * frame.depthToSea.w;
  float radiusM = max(particle.radiusM, 0.75 * pixelM);
  vec3 place = particle.middle + (side * corner.x + onPicture * (corner.y * stretch)) * radiusM;
  float thin = particle.radiusM / radiusM;
  float fade = smoothstep(1.0, 0.7, particle.age) * nearFade(distanceM) * thin * thin;
  Tuft tuft;
  tuft.position = clipOf(place, particle.opacity * fade);
  tuft.corner = corner;
  tuft.look = vec4(particle.opacity * fade, particle.turn, tuft.position.w, particle.age);
  tuft.shape = vec2(stretch, 2.0 * radiusM / max(pixelM, 1e-6));
  vec3 added = airBefore(particle.middle);
  tuft.light = tuftLight(toEye, particle.middle - burstPlace.xyz - burstUp.xyz * particle.radiusM, particle.turn) * airLeftOf(particle.middle, added) + added;
  return tuft;
}
