#include "places/place_houses.glsl"

layout(local_size_x = 32) in;

void main() { placeHouse(int(gl_GlobalInvocationID.x)); }
