#include "frame.glsl"
#include "sea_cut.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;

uniform mat4 toEye;
uniform mat3 normalToEye;

out vec3 relative;
out vec3 surfaceNormal;
out vec2 surfaceUv;

void main() {
  relative = (toEye * vec4(position, 1.0)).xyz;
  surfaceNormal = normalToEye * normal;
  surfaceUv = uv;
  gl_Position = frame.viewProjection * vec4(relative, 1.0);
  cutBelowSea(relative);
}
