// The strip that is in view, in the land's colours: included with GRASS_STRIP alone.
#include "shared/grass_strip.glsl"

uniform vec4 stripFrame;  // xy: its middle, metres from the base; zw: unit, the way one lands
uniform vec2 stripHalf;   // half its length and width, m

LandSurface mown(LandSurface land, LandSight sight, LandNoise noise) {
  vec2 d = sight.place - stripFrame.xy;
  vec2 local = vec2(dot(d, stripFrame.zw), d.y * stripFrame.z - d.x * stripFrame.w);
  return mownLand(land, local, stripHalf, sight.footprint, noise);
}
