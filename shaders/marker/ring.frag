#include "marker/marker.glsl"

out vec4 color;

void main() { color = ringAt(pixelRay(), pixelDepth()); }
