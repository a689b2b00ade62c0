// The ground below trees that stand (render::StandingWoods): included with STANDING_WOODS alone.
uniform vec4 standingReach;     // painted woods come in between x and y; single shadows up to z (m); their depth
uniform float standingDensity;  // share of the trees that there are

// How much of the woods stands at a distance: the rest is painted.
float standingShare(float distanceM) { return 1.0 - smoothstep(standingReach.x, standingReach.y, distanceM); }

// Needles, moss and fallen leaves instead of crowns seen from above.
vec3 floorAlbedo(vec3 albedo, float wooded, float leafy, LandNoise noise) {
  vec3 litter = mix(vec3(0.024, 0.032, 0.013), vec3(0.044, 0.055, 0.020), leafy) *
                (1.0 + 0.35 * noise.tuft + 0.45 * noise.clod + 0.4 * noise.grain);
  return mix(albedo, litter, wooded);
}

// What trees leave of the sun at a place, [0, 1], by the lattice on which they stand: their crowns at three heights, moved
// along the sun's rays. Beyond the reach of single shadows, what they leave in the mean. The loop is asked at
// its end: a software renderer goes through one that has ended for all pixels at hand once more.
float sunPastTrees(vec2 place, float distanceM, float density) {
  const float kSlices = 3.0, kCrownM = 15.0;
  vec2 aside = frame.toSun.xz / max(frame.toSun.y, 0.18);
  float single = 1.0 - smoothstep(0.6 * standingReach.z, standingReach.z, distanceM);
  int slices = single > 0.0 && density > 0.05 ? 3 : 1;
  float hidden = 0.0;
  int i = 0;
  do {
    float up = (float(i) + 0.6) / kSlices;
    uvec2 cell;
    vec2 inside;
    latticeOf(place + aside * (up * kCrownM), int(kChunkMetres / kTreeMetres), cell, inside);
    Crowns crowns = crownsAt(cell, inside);
    float stands = smoothRise(-0.05, 0.05, density * 1.1 - 0.05 - crowns.tree);
    hidden = max(hidden, stands * smoothstep(0.30 + 0.45 * up, 0.50 + 0.45 * up, crowns.height));
    ++i;
  } while (i < slices);
  return 1.0 - standingReach.w * standingDensity * mix(0.45 * density, 0.75 * hidden, single);
}
