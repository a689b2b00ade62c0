// The scene's light at a pixel of the picture. Compiled with STRETCHED where the scene has fewer pixels than the
// picture: bilinear between their centres, edges continued (src/render/frame/stretch.h is the same in C++).
#ifdef STRETCHED
uniform vec2 pictureSize;  // pixels

vec3 sceneLight(sampler2D scene, ivec2 pixel) {
  vec2 texel = 1.0 / vec2(textureSize(scene, 0));
  vec2 at = clamp((vec2(pixel) + 0.5) / pictureSize, 0.5 * texel, 1.0 - 0.5 * texel);
  return textureLod(scene, at, 0.0).rgb;
}
#else
vec3 sceneLight(sampler2D scene, ivec2 pixel) { return texelFetch(scene, pixel, 0).rgb; }
#endif
