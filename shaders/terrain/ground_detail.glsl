// The ground from a few metres (render::GroundDetail): included with GROUND_DETAIL alone.
#include "shared/ground_detail.glsl"

layout(binding = 6) uniform sampler2DArray groundRelief;  // squares of the materials: slopes, tint, height
uniform vec4 groundDetail;                                // contrast, relief, reach, metres a texel

const float kTileMetres = 7.5;        // as terrain::kReliefTileM
const float kSteepest = 2.0;          // as terrain::kReliefSteepest
const int kPiecesPerChunk = 256;      // 3.75 m each
const float kWideReach = 0.35;        // of larger squares, in proportion
const float kLeastShare = 0.04;       // of a second material or plane, below which it is not looked at

// What the detail adds: a slope in space, and shares by which albedo and open sky differ from the mean.
struct Detail {
  vec3 slope;
  float tint;
  float height;
};

// Of one material at a place of a plane, metres from where the lattice of pieces has the cell `base`.
vec4 materialAt(vec2 place, ivec2 base, float layer, float scale, float level, uint salt) {
  vec2 scaled = place * (float(kPiecesPerChunk) / (kChunkMetres * scale));
  vec2 whole = floor(scaled);
  DetailPieces pieces = detailPieces(uvec2(base + ivec2(whole)), scaled - whole, salt);
  vec2 at = place / (kTileMetres * scale);
  int count = pieces.weights.z > 0.0 ? 3 : pieces.weights.y > 0.0 ? 2 : 1;
  uint bits = pieces.first;
  float weight = pieces.weights.x;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < count; ++i) {
    vec4 texel = textureLod(groundRelief, vec3(at + pieceOffset(bits), layer), level);
    sum += (texel * kReliefBytes - kReliefZero) * weight;
    bits = i == 0 ? pieces.second : pieces.third;
    weight = i == 0 ? pieces.weights.y : pieces.weights.z;
  }
  return sum;
}

// `scale`: of the squares, 1 for their own size, a power of two. Nothing is fetched where a pixel covers too much: loops
// that end at once are skipped even where a software renderer runs both sides of a branch.
Detail groundDetailAt(LandSight sight, LandSurface land, float distanceM, float facing, float scale) {
  float footprint = detailFootprint(distanceM, frame.depthToSea.w, facing);
  float share = detailShare(footprint / (scale > 1.0 ? kWideReach * scale : 1.0), groundDetail.z) * (1.0 - land.wooded * sight.treeShare);
  DetailPick pick = detailPickOf(land);
  float level = max(detailLevel(footprint, groundDetail.w * scale) - 0.4, 0.0);
  uint salt = uint(scale);
  Detail detail = Detail(vec3(0.0), 0.0, 0.0);
#ifdef RICH_LAND
  DetailPlanes planes = detailPlanes(sight.normal);
  int planeCount = share <= 0.0 ? 0 : planes.share > kLeastShare ? 2 : 1;
  int materials = pick.share > kLeastShare ? 2 : 1;
  float planeShare = planes.share > kLeastShare ? planes.share : 0.0;
  float second = materials == 2 ? pick.share : 0.0;
  for (int p = 0; p < planeCount; ++p) {
    float axis = p == 0 ? planes.first : planes.second;
    vec2 place = axis == 1.0 ? sight.place
                             : vec2(axis == 0.0 ? sight.place.y : sight.place.x, sight.heightM);
    ivec2 chunk = axis == 1.0 ? baseChunk : ivec2(axis == 0.0 ? baseChunk.y : baseChunk.x, 0);
    vec4 sum = vec4(0.0);
    for (int m = 0; m < materials; ++m) {
      sum += materialAt(place, chunk * kPiecesPerChunk, m == 0 ? pick.first : pick.second, 1.0, level,
                        salt + uint(axis) * 64u) *
             (m == 0 ? 1.0 - second : second);
    }
    float weight = p == 0 ? 1.0 - planeShare : planeShare;
    vec3 slope = axis == 1.0 ? vec3(sum.x, 0.0, sum.y)
                 : axis == 0.0 ? vec3(0.0, sum.y, sum.x) : vec3(sum.x, sum.y, 0.0);
    detail.slope += slope * weight;
    detail.tint += sum.z * weight;
    detail.height += sum.w * weight;
  }
#else
  int planeCount = share <= 0.0 ? 0 : 1;
  for (int p = 0; p < planeCount; ++p) {
    vec4 sum = materialAt(sight.place, baseChunk * int(float(kPiecesPerChunk) / scale), pick.first, scale, level, salt);
    detail.slope = vec3(sum.x, 0.0, sum.y);
    detail.tint = sum.z;
    detail.height = sum.w;
  }
#endif
  detail.slope *= share * groundDetail.y * kSteepest;
  detail.tint *= share * groundDetail.x;
  detail.height *= share * groundDetail.y;
  return detail;
}

LandSurface withDetail(LandSurface land, Detail detail) {
  land.albedo *= 1.0 + max(detail.tint, -0.9);
  land.open *= clamp(1.0 + 0.6 * detail.height, 0.0, 1.5);
  return land;
}

// Faults where a place is, in cells of a chunk.
vec2 faultsAt(LandSight sight, float bend) {
  uvec2 cell;
  vec2 inside;
  latticeOf(sight.place, 1, cell, inside);
  return rockFaults(cell, inside, bend);
}
