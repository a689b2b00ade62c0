// Two kept pictures side by side, in place of a frame's own.
#include "split/split.glsl"

out vec4 color;

void main() { color = vec4(splitPicture(ivec2(gl_FragCoord.xy)), 1.0); }
