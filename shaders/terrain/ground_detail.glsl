// The ground from a few metres (render::GroundDetail): included with GROUND_DETAIL alone.
#include "shared/ground_detail.glsl"

layout(binding = 6) uniform sampler2DArray groundRelief;  // squares of the materials: slopes, tint, height
uniform vec4 groundDetail;                                // contrast, relief, reach, metres a texel

const float kTileMetres = 7.5;        // as terrain::kReliefTileM
const float kSteepest = 2.0;          // as terrain::kReliefSteepest
const int kPiecesPerChunk = 256;      // 3.75 m each
const float kWideScale = 8.0;         // of larger squares; as render::GroundDetail::kWideScale, as the next
const float kWideReach = 0.35;        // how far they are seen, in proportion
const float kLeastShare = 0.04;       // of a second material or plane, below which it is not looked at

// What the detail adds: a slope in space, and shares by which albedo and open sky differ from the mean.
struct Detail {
  vec3 slope;
  float tint;
  float height;
};

// Where a place is in the squares that are laid there.
struct LaidPieces {
  DetailPieces pieces;
  vec2 at;    // texture coordinates, before a piece is moved
  int count;  // of pieces that count, 1 to 3
};

// At a place of a plane, metres from where the lattice of pieces has the cell `base`. `scale`: of the squares, 1 for their own
// size, a power of two.
LaidPieces laidPieces(vec2 place, ivec2 base, float scale, uint salt) {
  vec2 scaled = place * (float(kPiecesPerChunk) / (kChunkMetres * scale));
  vec2 whole = floor(scaled);
  LaidPieces laid;
  laid.pieces = detailPieces(uvec2(base + ivec2(whole)), scaled - whole, salt);
  laid.at = place / (kTileMetres * scale);
  laid.count = laid.pieces.weights.z > 0.0 ? 3 : laid.pieces.weights.y > 0.0 ? 2 : 1;
  return laid;
}

// One piece of them, times its weight.
vec4 pieceAt(LaidPieces laid, int number, float layer, float level) {
  uint bits = number == 0 ? laid.pieces.first : number == 1 ? laid.pieces.second : laid.pieces.third;
  vec3 weights = laid.pieces.weights;
  float weight = number == 0 ? weights.x : number == 1 ? weights.y : weights.z;
  vec4 texel = textureLod(groundRelief, vec3(laid.at + pieceOffset(bits), layer), level);
  return (texel * kReliefBytes - kReliefZero) * weight;
}

float reliefLevel(float footprint, float scale) {
  return detailMip(max(groundPictureLevel(footprint, groundDetail.w * scale) - 0.4, 0.0));
}

Detail detailOf(vec3 slope, float tint, float height, float share) {
  return Detail(slope * (share * groundDetail.y * kSteepest), tint * (share * groundDetail.x), height * (share * groundDetail.y));
}

// Loops are asked at their end: a software renderer goes through one that has ended for all pixels at hand once more, and
// runs both sides of a branch.
#ifdef RICH_LAND
Detail groundDetailAt(LandSight sight, LandSurface land, float distanceM) {
  float footprint = detailFootprint(distanceM, frame.depthToSea.w, sight.facing);
  float share = detailShare(footprint, groundDetail.z) * (1.0 - land.wooded * sight.treeShare);
  DetailPick pick = detailPickOf(land);
  float level = reliefLevel(footprint, 1.0);
  DetailPlanes planes = detailPlanes(sight.normal);
  int planeCount = share > 0.0 && planes.share > kLeastShare ? 2 : 1;
  int materials = share > 0.0 && pick.share > kLeastShare ? 2 : 1;
  float planeShare = planes.share > kLeastShare ? planes.share : 0.0;
  float second = pick.share > kLeastShare ? pick.share : 0.0;
  vec3 slopes = vec3(0.0);
  vec2 rest = vec2(0.0);
  int p = 0;
  do {
    float axis = p == 0 ? planes.first : planes.second;
    vec2 place = axis == 1.0 ? sight.place
                             : vec2(axis == 0.0 ? sight.place.y : sight.place.x, sight.heightM);
    ivec2 chunk = axis == 1.0 ? baseChunk : ivec2(axis == 0.0 ? baseChunk.y : baseChunk.x, 0);
    LaidPieces laid = laidPieces(place, chunk * kPiecesPerChunk, 1.0, 1u + uint(axis) * 64u);
    int looks = share > 0.0 ? laid.count * materials : 1;
    vec4 sum = vec4(0.0);
    int i = 0;
    do {
      bool isFirst = i < laid.count;
      sum += pieceAt(laid, isFirst ? i : i - laid.count, isFirst ? pick.first : pick.second, level) *
             (isFirst ? 1.0 - second : second);
      ++i;
    } while (i < looks);
    float weight = p == 0 ? 1.0 - planeShare : planeShare;
    vec3 slope = axis == 1.0 ? vec3(sum.x, 0.0, sum.y)
                 : axis == 0.0 ? vec3(0.0, sum.y, sum.x) : vec3(sum.x, sum.y, 0.0);
    slopes += slope * weight;
    rest += sum.zw * weight;
    ++p;
  } while (p < planeCount);
  return detailOf(slopes, rest.x, rest.y, share);
}
#else
// Squares of their own size and squares eight times as large, which are seen farther.
struct PlainDetail {
  Detail fine, wide;
};

PlainDetail groundDetailAt(LandSight sight, LandSurface land, float distanceM) {
  float footprint = detailFootprint(distanceM, frame.depthToSea.w, sight.facing);
  float ground = 1.0 - land.wooded * sight.treeShare;
  float fineShare = detailShare(footprint, groundDetail.z) * ground;
  float wideShare = detailShare(footprint / (kWideReach * kWideScale), groundDetail.z) * ground;
  float layer = detailPickOf(land).first;
  LaidPieces fine = laidPieces(sight.place, baseChunk * kPiecesPerChunk, 1.0, 1u);
  LaidPieces wide = laidPieces(sight.place, baseChunk * (kPiecesPerChunk / int(kWideScale)), kWideScale, uint(kWideScale));
  int fineCount = fineShare > 0.0 ? fine.count : 0;
  int count = fineCount + (wideShare > 0.0 ? wide.count : 0);
  float fineLevel = reliefLevel(footprint, 1.0), wideLevel = reliefLevel(footprint, kWideScale);
  vec4 fineSum = vec4(0.0), wideSum = vec4(0.0);
  int i = 0;
  do {
    bool isFine = i < fineCount;
    LaidPieces laid = fine;
    if (!isFine) laid = wide;
    vec4 piece = pieceAt(laid, isFine ? i : i - fineCount, layer, isFine ? fineLevel : wideLevel);
    fineSum += isFine ? piece : vec4(0.0);
    wideSum += isFine ? vec4(0.0) : piece;
    ++i;
  } while (i < count);
  return PlainDetail(detailOf(vec3(fineSum.x, 0.0, fineSum.y), fineSum.z, fineSum.w, fineShare),
                     detailOf(vec3(wideSum.x, 0.0, wideSum.y), wideSum.z, wideSum.w, wideShare));
}
#endif

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
