#include "models/lamp_square.glsl"

out vec2 pixelsAside;
flat out int lamp;
flat out float shown;

void main() {
  lamp = gl_VertexID / 6;
  vec4 clip = clipOfLamp(lamp);
  pixelsAside = glowAside(gl_VertexID);
  shown = shownShare(clip);
  gl_Position = glowCorner(clip, pixelsAside, shown);
}
