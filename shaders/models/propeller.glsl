// Three blades that turn too fast to be seen: a veil, denser where the blades were last, with bright tips.
#include "models/light_shares.glsl"
#include "sky/sky.glsl"

// turn: angle from the first blade in turns; radius in radii of the propeller.
vec4 propellerOpacity(float turn, float radius) {
  float behind = fract(turn * 3.0);  // 0 at a blade, towards 1 where the next comes
  float smear = 0.55 + 0.45 * cos(2.0 * kPi * behind);
  float solidity = 0.30 * (1.0 - 0.55 * radius) * smoothstep(1.0, 0.985, radius) * smoothstep(0.2, 0.26, radius);
  float tip = smoothstep(0.875, 0.885, radius) * smoothstep(1.0, 0.985, radius);
  vec3 albedo = mix(vec3(0.02), vec3(0.85, 0.52, 0.02), tip);
  return vec4(albedo, solidity * smear + 0.04 * tip);
}
