// What mountains leave of the sun, and all of the sky, at the pixels of land and sea.
#include "terrain/land_shade.glsl"

out vec3 shares;

void main() { shares = sharesPastLand(ivec2(gl_FragCoord.xy)); }
