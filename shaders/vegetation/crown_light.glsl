// What a crown itself and the wood around it leave of the sky's (x) and the sun's light (y) at a height (share of the
// tree's) in a wood of a density: dark below, where the others' tops hide the sun.
vec2 crownLight(float open, float height, float density) {
  float sunny = mix(1.0, smoothstep(-0.1, 0.8, height), 0.7 * density);
  return vec2(open * mix(1.0, 0.35 + 0.65 * smoothstep(0.0, 0.9, height), density), sunny * mix(0.55, 1.0, open));
}
