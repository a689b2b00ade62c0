// Where clouds are so far away that they are drawn coarsely.
#include "clouds/uniforms.glsl"

// How much of the detail is left at a distance: none in the far field, and it fades before that begins.
float detailLeft(float distanceM) { return clamp((clouds.farField.x - distanceM) / (0.1 * clouds.farField.x), 0.0, 1.0); }
