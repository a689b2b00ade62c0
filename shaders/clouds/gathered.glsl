// What a ray has gathered, per illuminance of each source.
struct Gathered {
  float sun;
  float sky;
  float ground;
  float transmittance;
  float weight;    // sums: opacity, and distance times opacity
  float distance;
};
