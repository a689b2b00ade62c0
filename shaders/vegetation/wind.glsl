// Trees in the wind: a function of the place and the moment.
uniform vec4 treeWind;  // velocity of the wind (m/s) towards east and south; how much trees give way

// TreeInstance::bend: bent by the mean wind, swaying in gusts with a period that grows with the tree (1 s at 6 m).
vec4 bentBy(float heightM, float phase) {
  float speed = length(treeWind.xy);
  vec2 along = treeWind.xy / max(speed, 1e-3);
  float swing = 2.0 * kPi * (frame.eye.w / (0.5 + 0.09 * heightM) + phase);
  float gust = 0.55 + 0.45 * sin(0.31 * swing + 9.0 * phase);
  float lean = min(0.0035 * speed, 0.07) * (0.7 + 0.5 * gust) + min(0.0030 * speed, 0.05) * gust * sin(swing);
  float aside = min(0.0012 * speed, 0.02) * sin(1.37 * swing + 2.0);
  float give = heightM * treeWind.z;
  return vec4((along * lean + vec2(-along.y, along.x) * aside) * give, 0.0024 * min(0.1 * speed, 1.0) * give, 3.1 * swing);
}
