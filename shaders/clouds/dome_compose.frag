#include "clouds/sheet_layer.glsl"

out vec4 color;

void main() { color = sheetLayerAtPixel(gl_FragCoord.xy); }
