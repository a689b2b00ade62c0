// What mountains leave of the sun in the layer. LAND_SHADE: in frames in which they may take some of it.
#ifdef LAND_SHADE
#include "shadow/land_shade_volume.glsl"
#else
float sunOverLand(vec3 relative) { return 1.0; }
#endif
