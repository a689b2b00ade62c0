// Something on the ground as it is drawn: written by ground_cover/place.comp, one to a cell, read by
// vertex shaders, whose instances are numbers of them in a list of each kind.
struct CoverInstance {
  vec4 foot;    // relative to the eye; height (m)
  vec4 form;    // radius (m), turn (rad), kind, its bits: 24 of them as a number
  vec4 normal;  // of the ground; share of fine detail, [0, 1]
  vec4 sun;     // radiance of a white side that faces the sun, as it reaches the eye; from green to straw
  vec4 above;   // by the light from above; its own tint
  vec4 below;   // by the light from below; share that is grown
  vec4 air;     // light of the air before it; distance (m)
  vec4 albedo;  // of the ground there; the colour of a patch of flowers, [0, 1)
  vec4 bend;    // how far the wind has moved its top (m, east and south); how far tips tremble (m); where they are (rad)
};

// Tufts with fine blades, tufts, flowers, reeds, stones of few pixels, stones, boulders close by.
const int kCoverLists = 7;
