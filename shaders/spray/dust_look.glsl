// How dust looks: eroded by noise, lit from the sun's side, glowing towards it.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "spray/seen.glsl"

uniform vec4 burstAlbedo;
uniform vec4 burstShares;

float puffNoise(vec2 place) {
  vec2 cell = floor(place);
  return latticeNoise(uvec2(ivec2(cell)), place - cell).x;
}

// Opacity at a place of the puff, [-1, 1]: ragged, and more so towards the rim.
float puffCover(vec2 corner, float turn) {
  float square = dot(corner, corner);
  vec2 at = corner * 1.4 + vec2(37.0, 91.0) * (1.0 + 100.0 * turn);
  float noise = puffNoise(at) + 0.5 * puffNoise(at * 2.3);
  return smoothstep(0.0, 0.85, 1.0 - square + 0.75 * noise * (0.35 + square)) * saturate(3.0 * (1.0 - square));
}

// Irradiance of what scatters evenly, and a lobe towards the light (Henyey and Greenstein, asymmetry .5).
vec3 puffLight(vec2 corner, vec3 relative) {
  vec3 toEye = -normalize(relative);
  vec3 right = normalize(cross(abs(toEye.y) < 0.99 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), toEye));
  vec3 up = cross(toEye, right);
  vec3 normal = normalize(right * corner.x + up * corner.y + toEye * 0.6);
  float wrap = 0.5 + 0.5 * dot(normal, frame.toSun.xyz);
  float lobe = 0.75 / pow(1.25 + dot(toEye, frame.toSun.xyz), 1.5);
  vec3 sun = frame.sunLight.xyz * (burstShares.x * (0.15 + 0.55 * wrap * wrap + 0.12 * lobe));
  float raised = 0.5 + 0.5 * normal.y;
  vec3 around = mix(frame.groundLight.xyz, frame.skyLight.xyz, raised) * burstShares.y + diffuseSun(burstShares.xyz) * raised;
  return burstAlbedo.xyz / kPi * (sun + around);
}

vec4 puffSeen(vec2 corner, vec4 look, vec3 relative, vec3 airLeft, vec3 airAdded) {
  float opacity = look.x * puffCover(corner, look.y) * shareBefore(look.z, look.w) * throughClouds(length(relative));
  return seenParticle(puffLight(corner, relative), airLeft, airAdded, opacity);
}
