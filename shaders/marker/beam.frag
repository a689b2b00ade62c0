#include "marker/marker.glsl"

out vec4 color;

void main() { color = beamAt(pixelRay(), pixelDepth()); }
