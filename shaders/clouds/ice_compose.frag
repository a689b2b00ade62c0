#include "clouds/ice_ray.glsl"
#include "clouds/sheet_layer.glsl"

in vec2 ndc;
out vec4 color;

void main() {
  color = iceOverScene(sheetLayerAtPixel(gl_FragCoord.xy), (frame.ndcToRay * vec4(ndc, 1.0, 0.0)).xyz);
}
