// Which pixels of the scene show the sea: those whose depth is that of its plane, and whose land lies below it. Included
// after terrain/surface.glsl.
layout(binding = 5) uniform sampler2D sceneDepth;

vec3 rayOf(ivec2 pixel) {
  vec2 ndc = (vec2(pixel) + 0.5) * frame.viewport.zw * 2.0 - 1.0;
  return (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz;
}

float sceneViewZ(ivec2 pixel) { return viewZOfDepth(texelFetch(sceneDepth, pixel, 0).r, frame.eye.y); }

bool isSeaAt(ivec2 pixel, float viewZ, vec3 ray) {
  float seaViewZ = eyeFromBase.y / max(-ray.y, 1e-7);
  return ray.y < 0.0 && abs(viewZ - seaViewZ) < 2e-3 * seaViewZ && landViewZ(pixel) > seaViewZ;
}
