#include "models/layer.glsl"

out vec4 color;

void main() {
  LayerPixel pixel = layerPixel(ivec2(gl_FragCoord.xy));
  if (pixel.color.a == 0.0) discard;
  color = pixel.color;
  gl_FragDepth = pixel.depth;
}
