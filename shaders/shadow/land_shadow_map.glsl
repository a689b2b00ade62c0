// What land leaves of the sun on land and sea (include/skydrop/render/shadows/land_shadow_map.h).
#include "frame.glsl"
#include "shadow/share_of_disc.glsl"

const int kShadeLevels = 3;
const float kShadeBlend = 0.15;  // share of a level's reach over which it gives way to the next

layout(binding = 13) uniform sampler2DArray landClearances;  // a layer a level; s across the sun's rays, t along them
uniform vec4 shadeAxes;                  // metres along (xy) and across (zw) for metres east and south
uniform vec4 shadeLevels[kShadeLevels];  // texture coordinates a metre; those of the eye; how far the level reaches (m)

// 0 .. 1; 0.5 where the middle of the sun's disc is at the edge.
float landClearance(vec2 acrossAndAlong, int level) {
  vec4 at = shadeLevels[level];
  return textureLod(landClearances, vec3(acrossAndAlong * at.x + at.yz, float(level)), 0.0).r;
}

// 1 within the reach of a level, 0 beyond it. Counted from the eye, not from the texture's edges, which move in steps.
float insideShadeLevel(float awayM, int level) {
  float reach = shadeLevels[level].w;
  return saturate((reach - awayM) / (kShadeBlend * reach));
}

// One level where it alone counts, none for the sky: a loop, because a software renderer leaves it where it has ended for
// all pixels at hand, but runs both sides of a branch.
float sunPastLand(vec3 relative) {
  vec2 at = vec2(dot(shadeAxes.zw, relative.xz), dot(shadeAxes.xy, relative.xz));
  float away = max(abs(at.x), abs(at.y));
  int finer = away < shadeLevels[0].w ? 0 : 1;
  float finerShare = insideShadeLevel(away, finer), shown = insideShadeLevel(away, kShadeLevels - 1);
  int first = finerShare > 0.0 ? finer : finer + 1;
  int end = shown <= 0.0 ? first : finerShare < 1.0 ? finer + 2 : finer + 1;
  float clearance = 1.0 - shown;
  for (int level = first; level < end; ++level) {
    float share = level == finer ? finerShare : 1.0 - finerShare;
    clearance += landClearance(at, level) * (share * shown);
  }
  return shareOfDisc(4.0 * clearance - 2.0);
}
