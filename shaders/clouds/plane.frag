#include "clouds/plane.glsl"
#include "clouds/plane_visible.glsl"

in vec3 relative;
in vec2 texturePlace;
in vec2 weatherPlace;
in vec2 finePlace;
in float rim;
in vec3 airLeft;
out vec4 color;

void main() { color = visibleLight(planeLight(relative, texturePlace, weatherPlace, finePlace, rim, airLeft), relative); }
