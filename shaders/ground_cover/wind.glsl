// Grass in the wind: a function of the place and the moment.
uniform vec4 coverWind;  // velocity of the wind (m/s) towards east and south; how much plants give way

// CoverInstance::bend. Gusts are waves whose lengths divide a chunk: the same from every base.
vec4 coverBend(vec2 place, float heightM, float own) {
  float speed = length(coverWind.xy);
  vec2 along = coverWind.xy / max(speed, 1e-3);
  vec2 turns = place * (2.0 * kPi / kChunkMetres);
  float moment = frame.eye.w;
  float gust = sin(dot(turns, vec2(37.0, 14.0)) - 1.3 * moment) + sin(dot(turns, vec2(-11.0, 41.0)) - 1.9 * moment + 1.0) +
               sin(dot(turns, vec2(83.0, -59.0)) - 2.6 * moment + 4.0);
  float lean = min(0.035 * speed, 0.55) * (0.75 + 0.25 * gust);
  float swing = 2.0 * kPi * (moment * (1.1 + 0.7 * own) + own);
  float give = heightM * coverWind.z;
  return vec4(along * (lean * give), min(0.012 * speed, 0.10) * give, swing);
}
