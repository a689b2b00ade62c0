// Drawn over the land with dual-source blending: color + what is there * passed. KEEPS_MIRROR: what the water mirrors is
// kept for render::WaterReflectionPass.
#include "terrain/sea.glsl"

layout(location = 0, index = 0) out vec4 color;
layout(location = 0, index = 1) out vec4 passed;
#ifdef KEEPS_MIRROR
layout(early_fragment_tests) in;
layout(binding = 1, rgba16f) uniform writeonly image2D keptMirror;
#endif

void main() {
  SeaLight light = seaAsSeen(seaSightOf(gl_FragCoord.xyz));
  color = vec4(light.own, 1.0);
  passed = vec4(light.passed, 0.0);
#ifdef KEEPS_MIRROR
  imageStore(keptMirror, ivec2(gl_FragCoord.xy), light.mirror);
#endif
}
