#ifdef LAYERS
// What a ray has gathered: the light of each place is that of its own layers.
struct Gathered {
  vec3 light;
  float transmittance;
  float weight;    // sums: opacity, and distance times opacity
  float distance;
};

Gathered nothingGathered() { return Gathered(vec3(0.0), 1.0, 0.0, 0.0); }
#else
// What a ray has gathered, per illuminance of each source.
struct Gathered {
  float sun;
  float sky;
  float ground;
  float transmittance;
  float weight;    // sums: opacity, and distance times opacity
  float distance;
};

Gathered nothingGathered() { return Gathered(0.0, 0.0, 0.0, 1.0, 0.0, 0.0); }
#endif
