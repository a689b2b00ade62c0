// The land's normal at every other sample of the chunk below the eye: 100 x 100 of them.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/land_material.glsl"
#include "terrain/surface.glsl"
#include "terrain/noise.glsl"
#include "terrain/land.glsl"

in vec2 ndc;
out vec4 color;
void main() { color = vec4(normalAt(landTexel(floor(gl_FragCoord.xy) * 8.0, 10.0), vec2(0.0)), 1.0); }
