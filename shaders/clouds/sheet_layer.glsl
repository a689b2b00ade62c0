// A sheet's light and opacity, multiplied together, worked out for fewer pixels than the picture has
// (render::SheetLayer).
#include "frame.glsl"

layout(binding = 0) uniform sampler2D sheetLayer;

vec4 sheetLayerAtPixel(vec2 pixel) { return texture(sheetLayer, pixel * frame.viewport.zw); }
