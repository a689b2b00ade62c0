#include "clouds/ice_shade.glsl"

out float depth;

void main() { depth = uprightIceDepth(gl_FragCoord.xy); }
