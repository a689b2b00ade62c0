// The scene's light at a pixel of the picture (src/render/frame/stretch.h is the same in C++). Compiled with STRETCHED where
// the scene has fewer pixels than the picture: bilinear between their centres, edges continued. With SUPERSAMPLED where it
// has more: the light that is shown as the mean of what they show.
#if defined(STRETCHED) || defined(SUPERSAMPLED)
uniform vec2 pictureSize;  // pixels

vec3 lightBetween(sampler2D scene, vec2 pixel) {
  vec2 texel = 1.0 / vec2(textureSize(scene, 0));
  return textureLod(scene, clamp(pixel / pictureSize, 0.5 * texel, 1.0 - 0.5 * texel), 0.0).rgb;
}
#endif
#ifdef STRETCHED
vec3 sceneLight(sampler2D scene, ivec2 pixel) { return lightBetween(scene, vec2(pixel) + 0.5); }
#elif defined(SUPERSAMPLED)
uniform int samplesAcross;  // of a pixel, a side

vec3 sceneLight(sampler2D scene, ivec2 pixel) {
  vec3 curve = vec3(0.0);
  for (int i = 0; i < samplesAcross * samplesAcross; ++i) {
    vec2 inPixel = (vec2(i % samplesAcross, i / samplesAcross) + 0.5) / float(samplesAcross);
    curve += toneCurve(max(lightBetween(scene, vec2(pixel) + inPixel), vec3(0.0)));
  }
  return lightOfToneCurve(curve / float(samplesAcross * samplesAcross));
}
#else
vec3 sceneLight(sampler2D scene, ivec2 pixel) { return texelFetch(scene, pixel, 0).rgb; }
#endif
