// How far a texel of the reduced picture speaks for a ray: by the opacity of the air before what they end at, which should
// be within `apart` of each other.
float likeness(float one, float other, float apart) {
  float away = (one - other) / apart;
  return 1.0 / (1.0 + away * away);
}
