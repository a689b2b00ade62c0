#include "clouds/plane_place.glsl"

layout(location = 0) in vec2 place;

out vec3 relative;

void main() {
  relative = planePoint(place);
  gl_Position = frame.viewProjection * vec4(relative, 1.0);
}
