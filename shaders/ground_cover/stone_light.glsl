// Light of a stone: grey with something of the ground, darker at its foot.
struct StoneLight {
  vec3 sun, above, below, air;
};

// grain: from -1 to 1; tint: its own; overGroundM: height above its foot.
vec3 stoneLit(StoneLight light, vec3 ground, vec3 normal, float grain, float tint, float overGroundM) {
  vec3 grey = mix(vec3(0.13, 0.122, 0.112), vec3(0.31, 0.29, 0.255), tint);
  vec3 albedo = mix(grey, ground, 0.25) * (1.0 + 0.28 * grain);
  float open = 0.6 + 0.4 * smoothstep(-0.05, 0.18, overGroundM);  // the ground hides the sky from its foot
  vec3 lit = light.sun * max(dot(normal, frame.toSun.xyz), 0.0) + mix(light.below, light.above, 0.5 + 0.5 * normal.y) * open;
  return albedo * lit + light.air;
}
