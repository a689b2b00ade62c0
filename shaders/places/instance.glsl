// A building or a piece of a hedge as it is drawn: written by places/place_*.comp, read as attributes of instances.
struct PlaceInstance {
  vec4 foot;   // where walls begin, relative to the eye; how far they go on below (m)
  vec4 form;   // width, length, walls, roof (m); of a hedge width, length, height, rise along it
  vec4 turn;   // the ridge's way (x, z), length of the ridge, use
  vec4 sun;    // irradiance over pi of a side that faces the sun, as it reaches the eye; its bits as a number below 2^24
  vec4 above;  // by the light from above; share that is drawn
  vec4 below;  // by the light from below; share of windows that are lit
  vec4 air;    // light of the air before it; what air leaves of light
};

const int kPlaceLists = 2;  // buildings, hedges
