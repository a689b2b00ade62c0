// The body of surface_kernels_*.cpp, each of which defines SKYDROP_SURFACE_KERNELS (the name of its table)
// first. Nothing here may call a function that is not forced inline (terrain/row_kernels.inl).

#include "elevation/bicubic.h"
#include "elevation/surface_kernels.h"
#include "skydrop/core/force_inline.h"

namespace skydrop::elevation {
namespace {

SKYDROP_INLINE double cubic(const double (&c)[4][2], int axis, double t) {
  return c[0][axis] + t * (c[1][axis] + t * (c[2][axis] + t * c[3][axis]));
}

// The largest whole number not above, within what 32 bits hold.
SKYDROP_INLINE std::int32_t wholeOf(double value) {
  value = value > -2e9 ? value : -2e9;
  value = value < 2e9 ? value : 2e9;
  const auto whole = static_cast<std::int32_t>(value);
  return whole - (static_cast<double>(whole) > value ? 1 : 0);
}

SKYDROP_INLINE float shareOf(double value) {
  value = value > 0 ? value : 0;
  return static_cast<float>(value < 1 ? value : 1);
}

void places(const ChartPiece& pieceOfCaller, double first, double step, int from, int past, SurfaceRow& row) {
  const ChartPiece piece = pieceOfCaller;
  for (int s = from; s < past; ++s) {
    const double t = first + s * step;
    const double column = cubic(piece.place, 0, t), line = cubic(piece.place, 1, t);
    row.column[s] = column;
    row.row[s] = line;
    const std::int32_t i = wholeOf(column), k = wholeOf(line);
    row.cellColumn[s] = i;
    row.cellRow[s] = k;
    row.across[s] = shareOf(column - i);
    row.down[s] = shareOf(line - k);
    row.eastColumn[s] = static_cast<float>(piece.east[0][0] + t * piece.east[1][0]);
    row.eastRow[s] = static_cast<float>(piece.east[0][1] + t * piece.east[1][1]);
    row.southColumn[s] = static_cast<float>(piece.south[0][0] + t * piece.south[1][0]);
    row.southRow[s] = static_cast<float>(piece.south[0][1] + t * piece.south[1][1]);
  }
}

SKYDROP_INLINE double beyond(double value, double first, double last) {
  const double before = value - first, after = value - last;
  return before < 0 ? before : after > 0 ? after : 0;
}

// 1 - weight is a product of smooth steps, one for each block: so it is smooth where two blocks are near.
void fade(const FadingBlock& blockOfCaller, int from, int past, SurfaceRow& row) {
  const FadingBlock block = blockOfCaller;
  const float perMetre = 1 / block.fadeM, slopePerMetre = 6 / (block.fadeM * block.fadeM);
  for (int s = from; s < past; ++s) {
    const float x = static_cast<float>(beyond(row.column[s], block.left, block.right)) * block.cellEastM;
    const float y = static_cast<float>(beyond(row.row[s], block.top, block.bottom)) * block.cellSouthM;
    const float share = __builtin_sqrtf(x * x + y * y) * perMetre;
    const float t = share < 1 ? share : 1;
    const float smooth = t * t * (3 - 2 * t);
    const float slope = (1 - t) * slopePerMetre;  // of the step by the distance, over the distance
    const float rest = row.rest[s];
    row.restColumn[s] = row.restColumn[s] * smooth + rest * (slope * x * block.cellEastM);
    row.restRow[s] = row.restRow[s] * smooth + rest * (slope * y * block.cellSouthM);
    row.rest[s] = rest * smooth;
  }
}

void surface(int from, int past, SurfaceRow& row) {
  constexpr int kPart = 64;
  alignas(64) float values[kPart][4], slopes[kPart][4];
  alignas(64) float weights[kPart][8];
  for (int first = from; first < past; first += kPart) {
    const int count = past - first < kPart ? past - first : kPart;
    for (int s = 0; s < count; ++s) {
      const CubicWeights<float> w = cubicWeights(row.down[first + s]);
      for (int k = 0; k < 4; ++k) {
        weights[s][k] = w.value[k];
        weights[s][4 + k] = w.slope[k];
      }
    }
    for (int s = 0; s < count; ++s) {
      const float* cells = row.cells[first + s];
      float value[4] = {0, 0, 0, 0}, slope[4] = {0, 0, 0, 0};
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) {
        const float v = weights[s][k], d = weights[s][4 + k];
#pragma GCC unroll 4
        for (int i = 0; i < 4; ++i) {
          const float cell = cells[k * kPageSide + i];
          value[i] += v * cell;
          slope[i] += d * cell;
        }
      }
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i) {
        values[s][i] = value[i];
        slopes[s][i] = slope[i];
      }
    }
    for (int s = 0; s < count; ++s) {
      const CubicWeights<float> w = cubicWeights(row.across[first + s]);
      float height = 0, across = 0, down = 0;
#pragma GCC unroll 4
      for (int i = 0; i < 4; ++i) {
        height += w.value[i] * values[s][i];
        across += w.slope[i] * values[s][i];
        down += w.value[i] * slopes[s][i];
      }
      row.height[first + s] = height;
      row.heightEast[first + s] = across * row.eastColumn[first + s] + down * row.eastRow[first + s];
      row.heightSouth[first + s] = across * row.southColumn[first + s] + down * row.southRow[first + s];
    }
  }
}

void add(int count, const SurfaceRow& row, LandRow& land) {
  for (int s = 0; s < count; ++s) {
    const float east = row.restColumn[s] * row.eastColumn[s] + row.restRow[s] * row.eastRow[s];
    const float south = row.restColumn[s] * row.southColumn[s] + row.restRow[s] * row.southRow[s];
    const float weight = 1 - row.rest[s], rest = land.rest[s], share = rest * weight;
    land.east[s] += (land.restEast[s] * weight - rest * east) * row.height[s] + share * row.heightEast[s];
    land.south[s] += (land.restSouth[s] * weight - rest * south) * row.height[s] + share * row.heightSouth[s];
    land.height[s] += share * row.height[s];
    land.restEast[s] = land.restEast[s] * row.rest[s] + rest * east;
    land.restSouth[s] = land.restSouth[s] * row.rest[s] + rest * south;
    land.rest[s] = rest * row.rest[s];
  }
}

void addAround(int count, const ChunkCoding& codingOfCaller, float raised,
               const std::uint16_t* __restrict heights, const std::uint16_t* __restrict normals,
               LandRow& land) {
  const ChunkCoding coding = codingOfCaller;
  for (int s = 0; s < count; ++s) {
    const float height = coding.lowest + static_cast<float>(heights[s]) * coding.step + raised;
    const float e0 = static_cast<float>((normals[s] & 0xff) - 128) * (1 / 127.0F);
    const float e1 = static_cast<float>((normals[s] >> 8) - 128) * (1 / 127.0F);
    const float x = 0.5F * (e0 + e1), z = 0.5F * (e0 - e1);
    const float upright = 1 - (x < 0 ? -x : x) - (z < 0 ? -z : z);
    // The code of a cliff has a level normal: half a step of the code above is as steep as it can tell.
    const float perUp = -1 / (upright > 0.5F / 127 ? upright : 0.5F / 127);
    land.east[s] += land.restEast[s] * height + land.rest[s] * (x * perUp);
    land.south[s] += land.restSouth[s] * height + land.rest[s] * (z * perUp);
    land.height[s] += land.rest[s] * height;
  }
}

void finish(int count, const ChunkCoding& codingOfCaller, const LandRow& land,
            std::uint16_t* __restrict heights, std::uint16_t* __restrict normals) {
  const ChunkCoding coding = codingOfCaller;
  const float perMetre = 1 / coding.step;
  for (int s = 0; s < count; ++s) {
    float code = (land.height[s] - coding.lowest) * perMetre + 0.5F;
    code = code > 0 ? code : 0;
    code = code < 65535 ? code : 65535;
    heights[s] = static_cast<std::uint16_t>(static_cast<std::int32_t>(code));
    const float x = -land.east[s], z = -land.south[s];
    const float scale = 127 / ((x < 0 ? -x : x) + 1 + (z < 0 ? -z : z));
    const auto low = static_cast<std::int32_t>((x + z) * scale + 128.5F);
    const auto high = static_cast<std::int32_t>((x - z) * scale + 128.5F);
    normals[s] = static_cast<std::uint16_t>(low | high << 8);
  }
}

}  // namespace

extern const SurfaceKernels SKYDROP_SURFACE_KERNELS;
const SurfaceKernels SKYDROP_SURFACE_KERNELS{places, fade, surface, add, addAround, finish};

}  // namespace skydrop::elevation
