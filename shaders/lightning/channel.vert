#include "lightning/channel_place.glsl"

layout(location = 0) in vec4 pieceFrom;
layout(location = 1) in vec4 pieceTo;
out vec2 pixels;
flat out float pixelsLong;
flat out vec3 radiance;
flat out float spread;
flat out float distanceM;
flat out float most;

void main() {
  PieceCorner corner = cornerOf(pieceFrom, pieceTo, gl_VertexID);
  pixels = corner.pixels;
  pixelsLong = corner.pixelsLong;
  radiance = corner.radiance;
  spread = corner.spread;
  distanceM = corner.distanceM;
  most = corner.most;
  gl_Position = corner.clip;
}
