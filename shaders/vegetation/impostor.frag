#include "vegetation/impostor_look.glsl"

in vec2 inView;
in vec2 surfaceLight;
flat in vec2 views;
flat in vec2 turn;
flat in vec3 lightSun, lightAbove, lightBelow, lightAir;
flat in vec4 fade;
out vec4 color;

void main() {
  float dither = ditherOf(gl_FragCoord.xy, fade.z);
  vec2 chosen = vec2(ditherOf(gl_FragCoord.yx + 17.0, fade.z), ditherOf(gl_FragCoord.xy + 41.0, fade.z));
  vec4 seen = impostorColor(atlasTexel(inView, views, fade.w, chosen), manyTexels(inView),
                            TreeLight(lightSun, lightAbove, lightBelow, lightAir), surfaceLight, turn);
  if (seen.a < 0.0 || dither < fade.x || dither >= fade.y) discard;
  color = vec4(seen.rgb, 1.0);
}
