// Scene light to encoded 8-bit colour: the last shader that sees light.
#include "shared/tone_map.glsl"
#include "tone_map/dither.glsl"
#include "tone_map/guards.glsl"
#include "tone_map/stretched.glsl"

layout(binding = 0) uniform sampler2D sceneColor;
out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 light = sceneLight(sceneColor, pixel);
  vec3 encoded = withGuardMarks(srgbEncode(toneMap(max(light, vec3(0.0)))), light);
  color = vec4(encoded + ditherStep(uvec2(pixel)), 1.0);
}
