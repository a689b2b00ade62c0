#include "precipitation/veil.glsl"

noperspective out vec4 depths;
noperspective out vec4 lightAndDistance;
noperspective out vec2 rayScaleAndReach;

void main() {
  vec2 place = gridPlace(gl_VertexID);
  Veil veil = veilTowards(place);
  depths = veil.depths;
  lightAndDistance = vec4(veil.light, veil.seenM);
  rayScaleAndReach = vec2(length((frame.ndcToRay * vec4(place, 1.0, 0.0)).xyz), veil.reachM);
  gl_Position = vec4(place, 0.5, 1.0);
}
