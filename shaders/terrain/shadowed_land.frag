// The land once more where it may be in shadow: drawn over the same pixels, lit by what is left of the sun.
#include "frame.glsl"
#include "shared/lattice_noise.glsl"
#include "shared/land_material.glsl"
#include "shadow/cast_shadows.glsl"
#include "terrain/surface.glsl"
#include "terrain/noise.glsl"
#include "terrain/land.glsl"

out vec4 color;

void main() {
  color = vec4(landAsSeen(landPlace(ivec2(gl_FragCoord.xy))), 1.0);
}
