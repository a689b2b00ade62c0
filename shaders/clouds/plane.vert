#include "clouds/plane_place.glsl"

layout(location = 0) in vec2 place;
layout(location = 1) in float alpha;

out vec3 relative;
out vec2 texturePlace;
out vec2 weatherPlace;
out vec2 finePlace;
out float rim;

void main() {
  relative = planePoint(place);
  texturePlace = texturePlaceOf(relative.xz);
  weatherPlace = weatherPlaceOf(relative.xz);
  finePlace = finePlaceOf(relative.xz);
  rim = alpha;
  gl_Position = frame.viewProjection * vec4(relative, 1.0);
}
