#include "clouds/dome.glsl"

in vec3 ray;
in float rim;
out vec4 color;

void main() { color = domeLight(normalize(ray), rim); }
