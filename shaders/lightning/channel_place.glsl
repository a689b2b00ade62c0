// Where a piece of a channel lies in the picture: a rectangle of pixels around it. A piece is two places relative to the
// eye, with its share of the brightness, and how wide its glow is against the line (1: the line itself).
#include "frame.glsl"
#include "shared/flash.glsl"

uniform vec3 channelLight;   // intensity a metre, times exposure
uniform float lineSpread;    // of the line, pixels

const float kSpreadsDrawn = 3.5;
// Of the main channel: times all pieces, over the brightest scene, it is still a half float.
const float kMostOfPiece = 8.0;
const float kNearestM = 5.0;  // a channel is a few centimetres wide, and nobody looks closer

struct PieceCorner {
  vec4 clip;
  vec2 pixels;  // along the piece from its beginning, and aside
  float pixelsLong;
  vec3 radiance;  // in the middle of the line
  float spread;   // pixels
  float distanceM;
  float most;  // radiance that is shown: dimmer pieces look dimmer however bright all are
};

PieceCorner cornerOf(vec4 from, vec4 to, int vertex) {
  PieceCorner corner;
  vec4 a = frame.viewProjection * vec4(from.xyz, 1.0), b = frame.viewProjection * vec4(to.xyz, 1.0);
  // Of what lies behind the near plane nothing is drawn.
  float nearest = 2.0 * frame.eye.y;
  bool isSeen = max(a.w, b.w) > nearest;
  float step = isSeen ? (nearest - a.w) / (abs(b.w - a.w) > 1e-6 ? b.w - a.w : 1.0) : 0.0;
  vec4 cut = mix(a, b, clamp(step, 0.0, 1.0));
  if (a.w < nearest) a = cut;
  if (b.w < nearest) b = cut;
  a.w = max(a.w, nearest);
  b.w = max(b.w, nearest);
  vec2 atA = a.xy / a.w * 0.5 * frame.viewport.xy, atB = b.xy / b.w * 0.5 * frame.viewport.xy;
  vec2 way = atB - atA;
  float pixelsLong = length(way);
  vec2 along = pixelsLong > 1e-4 ? way / pixelsLong : vec2(1.0, 0.0);
  float spread = lineSpread * to.w, margin = kSpreadsDrawn * spread;
  // Two triangles.
  bool atEnd = vertex == 1 || vertex > 3;
  float side = vertex == 2 || vertex == 3 || vertex == 5 ? 1.0 : -1.0;
  corner.pixels = vec2(atEnd ? pixelsLong + margin : -margin, side * margin);
  corner.pixelsLong = pixelsLong;
  corner.spread = spread;
  vec4 end = atEnd ? b : a;
  vec2 aside = (corner.pixels.x - (atEnd ? pixelsLong : 0.0)) * along + corner.pixels.y * vec2(-along.y, along.x);
  corner.clip = isSeen ? vec4(end.xy + aside * 2.0 * frame.viewport.zw * end.w, end.zw) : vec4(0.0, 0.0, -1.0, 1.0);
  vec3 middle = 0.5 * (from.xyz + to.xyz);
  corner.distanceM = length(middle);
  corner.most = kMostOfPiece * from.w;
  float metresAPixel = max(corner.distanceM, kNearestM) * frame.depthToSea.w;
  corner.radiance = channelLight * (from.w / (metresAPixel * spread * sqrt(2.0 * kPi)));
#ifdef HAZE
  corner.radiance *= airTransmittance(middle.y, corner.distanceM);
#endif
  return corner;
}
