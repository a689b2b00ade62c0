#include "precipitation/drops.glsl"
#include "precipitation/drops_seen.glsl"

in vec2 aside;
in float depth;
flat in vec2 halfSize;
flat in vec4 dropLight;
out vec4 color;

void main() { color = vec4(dropLight.xyz, 1.0) * (dropLight.w * coverOf(aside, halfSize) * shareSeen(depth)); }
