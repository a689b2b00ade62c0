#include "clouds/plane_visible.glsl"
#include "clouds/sheet_layer.glsl"

in vec3 relative;
out vec4 color;

void main() { color = visibleLight(sheetLayerAtPixel(gl_FragCoord.xy), relative); }
