#include "precipitation/splashes.glsl"

out vec2 aside;
out vec3 stage;

void main() {
  Splash splash = splashCorner(gl_VertexID);
  gl_Position = splash.position;
  aside = splash.aside;
  stage = splash.stage;
}
