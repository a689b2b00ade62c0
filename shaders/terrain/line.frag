// The mesh as lines, or normals as strokes: one plain colour.
#include "frame.glsl"

uniform vec3 lineAlbedo;
out vec4 color;

void main() { color = vec4(shadeLambert(lineAlbedo, vec3(0.0, 1.0, 0.0), kOpenSky), 1.0); }
