#include "frame.glsl"
#include "models/scene_depth.glsl"
#include "markers/marker.glsl"

in vec3 relative;
in vec2 onBeam;
out vec4 color;

void main() {
  discardIfHidden();
  color = markerGlow(beamShare(onBeam.x, onBeam.y, length(relative)), relative);
}
