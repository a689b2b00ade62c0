// A tree as it is drawn: written by vegetation/place.comp, read as attributes of instances.
struct TreeInstance {
  vec4 foot;     // relative to the eye; height (m)
  vec4 form;     // radius (m), cosine and sine of the turn, share that is drawn as a mesh
  vec4 sun;      // radiance of a side that faces the sun, as it reaches the eye; kind, and half of the snow on it
  vec4 above;    // radiance by the light from above; density of the wood around
  vec4 below;    // by the light from below; phase of its swaying, in turns
  vec4 air;      // light of the air before it; share of it that is drawn at all
  vec4 bend;     // how far the wind has moved its top (m, east and south); how far twigs swing (m) and where they are (rad)
};

const int kInstanceKinds = 4;  // meshes of the three kinds, then impostors of all
