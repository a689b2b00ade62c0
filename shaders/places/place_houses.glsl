// Which buildings a frame shows: one invocation a part.
#include "places/placing.glsl"

struct PlacedPart {
  vec4 foot;   // x, z from the map's corner; above the sea; how far walls go on below
  vec4 form;   // width, length, walls, roof
  vec4 turn;   // along x, z; ridge; exact height of the land below, -1e9: it stands at its own height
  uvec4 bits;  // its own; use
};
layout(std430, binding = 0) readonly buffer Parts { PlacedPart parts[]; };
uniform int partCount;

void placeHouse(int index) {
  int isPart = index < partCount ? 1 : 0;
  for (int part = 0; part < isPart; ++part) {
    PlacedPart of = parts[index];
    vec2 place = of.foot.xy + placeFrame.xy;
    vec2 ground = place - eyeFromBase.xz;
    int isNear = length(ground) < placeReach.y ? 1 : 0;
    for (int near = 0; near < isNear; ++near) {
      // On the land as it is drawn, as high over it as it stands over the exact one.
      float drawn = of.turn.w > -1e8 ? drawnHeight(place) - of.turn.w : 0.0;
      vec3 foot = vec3(ground.x, of.foot.z + max(drawn, -1e3) - eyeFromBase.y, ground.y);
      float distanceM = length(foot);
      float share = 1.0 - smoothstep(placeReach.x, placeReach.y, distanceM);
      vec3 middle = foot + vec3(0.0, 0.5 * of.form.z, 0.0);
      float radiusM = length(of.form.xy) * 0.5 + of.form.z + of.form.w;
      int shown = share > 0.0 && drawn > -1e5 && isInView(middle, radiusM) ? 1 : 0;
      for (int show = 0; show < shown; ++show) {
        PlaceInstance made;
        made.foot = vec4(foot, of.foot.w);
        made.form = of.form;
        made.turn = vec4(of.turn.xyz, float(of.bits.y));
        put(0u, lit(made, middle, of.bits.x, share));
      }
    }
  }
}
