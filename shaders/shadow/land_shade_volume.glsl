// What land leaves of the sun in the air (include/skydrop/render/shadows/land_shade_volume.h).
#include "frame.glsl"
#include "shadow/share_of_disc.glsl"

const int kShadeLevels = 3;

// A layer a level; s across the sun's rays, t along them. g: height above which land hides none of the sun, r: how much
// lower it hides all of it, as shares of limbScaleM.
layout(binding = 9) uniform sampler2DArray landLimbs;
uniform vec4 shadeAxes;                  // metres along (xy) and across (zw) for metres east and south
uniform vec4 shadeLevels[kShadeLevels];  // texture coordinates a metre; those of the eye; how far the level reaches (m)
uniform float limbScaleM;

// The finest level that reaches there, alone: what differs between levels is lost along a ray.
float sunOverLand(vec3 relative) {
  vec2 at = vec2(dot(shadeAxes.zw, relative.xz), dot(shadeAxes.xy, relative.xz));
  float away = max(abs(at.x), abs(at.y));
  int level = away < shadeLevels[0].w ? 0 : away < shadeLevels[1].w ? 1 : 2;
  vec4 place = shadeLevels[level];
  vec2 limbs = textureLod(landLimbs, vec3(at * place.x + place.yz, float(level)), 0.0).rg * limbScaleM;
  float halfWidth = max(0.5 * limbs.x, 0.05);
  float share = shareOfDisc((frame.eye.x + relative.y - limbs.y + halfWidth) / halfWidth);
  return away < shadeLevels[kShadeLevels - 1].w ? share : 1.0;
}
