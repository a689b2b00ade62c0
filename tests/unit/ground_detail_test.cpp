// The ground close by: the squares of its materials, where they are laid, and layers of rock.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/vec4.hpp>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared_ground_detail.h"
#include "skydrop/terrain/ground_relief.h"
#include "support/margin.h"

namespace skydrop::terrain {
namespace {

namespace shared = core::shared::f32;

constexpr int kPiecesPerChunk = 256;  // as in shaders/terrain/ground_detail.glsl
constexpr double kChunkM = 960;

const GroundRelief& relief() {
  static const GroundRelief made = makeGroundRelief(256);
  return made;
}

int wrapped(int i, int side) { return (i % side + side) % side; }

// As a GPU filters it: slopes, tint and height at a place in squares of a level.
glm::dvec4 filtered(int material, double u, double v, int level) {
  const GroundRelief::Level& l =
      relief().levels[static_cast<std::size_t>(material)][static_cast<std::size_t>(level)];
  const double x = u * l.texels - 0.5, y = v * l.texels - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  glm::dvec4 sum(0);
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = (i ? x - x0 : 1 - x + x0) * (j ? y - y0 : 1 - y + y0);
      const std::size_t at =
          4 * (static_cast<std::size_t>(wrapped(y0 + j, l.texels)) * l.texels + wrapped(x0 + i, l.texels));
      for (int c = 0; c < 4; ++c) sum[c] += weight * (l.bytes[at + c] - 128.0) / 127;
    }
  }
  return sum;
}

// What the shader makes of a material at a place (m from the corner of a chunk), a pixel covering footprintM.
glm::dvec4 detailAt(int material, std::int32_t chunkX, std::int32_t chunkZ, const glm::dvec2& place,
                    double footprintM) {
  const auto inFloat = glm::vec2(place) * static_cast<float>(kPiecesPerChunk / kChunkM);
  const glm::vec2 whole = glm::floor(inFloat);
  const shared::Uvec2 cell(static_cast<std::uint32_t>(chunkX) * kPiecesPerChunk +
                               static_cast<std::uint32_t>(static_cast<int>(whole.x)),
                           static_cast<std::uint32_t>(chunkZ) * kPiecesPerChunk +
                               static_cast<std::uint32_t>(static_cast<int>(whole.y)));
  const shared::DetailPieces pieces = shared::detailPieces(cell, inFloat - whole, 1);
  const double level = shared::detailMip(
      shared::groundPictureLevel(static_cast<float>(footprintM), static_cast<float>(kReliefTileM / 256)));
  const int low = static_cast<int>(level), high = std::min(low + 1, 8);
  glm::dvec4 sum(0);
  const std::array<std::uint32_t, 3> bits{pieces.first, pieces.second, pieces.third};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec2 at =
        place / kReliefTileM + glm::dvec2(shared::pieceOffset(bits[static_cast<std::size_t>(i)]));
    const double part = level - low;
    sum += (filtered(material, at.x, at.y, low) * (1 - part) + filtered(material, at.x, at.y, high) * part) *
           static_cast<double>(pieces.weights[i]);
  }
  return sum;
}

TEST(GroundDetail, squaresHaveNoMeanAtAnyLevel) {
  // Slopes, tint and height of every level of every material have the mean 0, so the land keeps its colour:
  // within half a byte's step (1/254).
  for (int m = 0; m < kGroundMaterials; ++m) {
    ASSERT_EQ(relief().levels[static_cast<std::size_t>(m)].size(), 9u);
    for (const GroundRelief::Level& level : relief().levels[static_cast<std::size_t>(m)]) {
      glm::dvec4 sum(0);
      for (std::size_t i = 0; i < level.bytes.size(); ++i)
        sum[static_cast<int>(i % 4)] += (level.bytes[i] - 128.0) / 127;
      for (int c = 0; c < 4; ++c) {
        const double mean = sum[c] / (static_cast<double>(level.bytes.size()) / 4);
        ASSERT_LE(std::abs(mean), 1.0 / 254) << m << " channel " << c << " level of " << level.texels;
      }
    }
  }
}

TEST(GroundDetail, squaresRepeatWithoutAnEdge) {
  // Neighbours across the border of a square differ no more than those inside it.
  for (int m = 0; m < kGroundMaterials; ++m) {
    const GroundRelief::Level& level = relief().levels[static_cast<std::size_t>(m)][0];
    const auto step = [&](int from) {
      double sum = 0;
      for (int y = 0; y < level.texels; ++y) {
        const auto at = [&](int x) {
          return level.bytes[4 * (static_cast<std::size_t>(y) * level.texels + wrapped(x, level.texels)) + 2];
        };
        sum += std::abs(at(from) - at(from + 1));
      }
      return sum;
    };
    double inside = 0;
    for (int x = 0; x < 64; ++x) inside += step(3 * x) / 64;
    EXPECT_LT(step(level.texels - 1), 1.6 * inside) << m;
  }
}

TEST(GroundDetail, squaresOfOtherSizesAreTheSameGround) {
  // 128 texels show what 256 do at half the size: the tint of the coarse one and of the second level of the
  // fine one are correlated by .8 and more.
  const GroundRelief coarse = makeGroundRelief(128);
  for (int m = 0; m < kGroundMaterials; ++m) {
    const auto& a = coarse.levels[static_cast<std::size_t>(m)][0].bytes;
    const auto& b = relief().levels[static_cast<std::size_t>(m)][1].bytes;
    ASSERT_EQ(a.size(), b.size());
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 2; i < a.size(); i += 4) {
      const double x = a[i] - 128.0, y = b[i] - 128.0;
      ab += x * y, aa += x * x, bb += y * y;
    }
    EXPECT_GT(ab / std::sqrt(aa * bb), m == static_cast<int>(GroundMaterial::snow) ? 0.6 : 0.75) << m;
  }
}

TEST(GroundDetail, K01_patternStaysPutFarOut) {
  // The same ground seen from two bases a chunk apart, near the origin and 1e9 m out: what is laid is the
  // same within a hundredth of the material's contrast (the eighth of a texel that a float is off by at 3
  // km).
  core::RandomStream random{5, 0};
  double worst = 0;
  for (const std::int32_t far : {0, 1041666, -1041666}) {  // 1e9 m / 960 m
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec2 place(random.nextUnit() * 1900, random.nextUnit() * 1900);
      const int material = i % kGroundMaterials;
      const glm::dvec4 here = detailAt(material, far, far, place, 0.1);
      const glm::dvec4 there =
          detailAt(material, far + 1, far - 2, place - glm::dvec2(kChunkM, -2 * kChunkM), 0.1);
      worst = std::max(worst, std::abs(here.z - there.z));
    }
  }
  EXPECT_TRUE(test::holds("K01", worst, test::atMost(0.02), "of the albedo"));
  // And it is another pattern out there.
  EXPECT_GT(std::abs(detailAt(2, 0, 0, {3, 5}, 0.1).z - detailAt(2, 1041666, 0, {3, 5}, 0.1).z), 0.01);
}

TEST(GroundDetail, K02_noPatternIsSeenToRepeat) {
  // Squares side by side are correlated wholly a square further; laid in pieces the ground is not: the
  // greatest correlation at whole squares, up to eight of them along both axes, is that of chance.
  double worst = 0;
  for (int m = 0; m < kGroundMaterials; ++m) {
    constexpr int kSide = 72;
    constexpr double kStepM = 0.9;
    for (const glm::dvec2 shift : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1), glm::dvec2(2, 0),
                                   glm::dvec2(4, -1), glm::dvec2(8, 0)}) {
      double ab = 0, aa = 0, bb = 0;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const glm::dvec2 at(100 + x * kStepM, 200 + y * kStepM);
          const double a = detailAt(m, 4, 9, at, 0.06).z,
                       b = detailAt(m, 4, 9, at + shift * kReliefTileM, 0.06).z;
          ab += a * b, aa += a * a, bb += b * b;
        }
      }
      worst = std::max(worst, std::abs(ab) / std::sqrt(aa * bb));
    }
  }
  EXPECT_TRUE(test::holds("K02", worst, test::atMost(0.2), "of 1"));
}

TEST(GroundDetail, K03_detailDoesNotShimmer) {
  // Between frames a pixel comes to cover ground half a pixel aside: from 3 cm a pixel to where the detail
  // ends the mean of the ground stays within 1 %, and that of a single pixel changes by a share of the
  // contrast that does not grow with the distance.
  double meanMoved = 0, pixelMoved = 0;
  for (int m = 0; m < kGroundMaterials; ++m) {
    for (const double footprint : {0.03, 0.06, 0.12, 0.24, 0.48}) {
      double before = 0, after = 0, moved = 0;
      constexpr int kSide = 48;
      for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
          const glm::dvec2 at(40 + x * footprint, 70 + y * footprint);
          const double a = detailAt(m, 1, 2, at, footprint).z;
          const double b = detailAt(m, 1, 2, at + glm::dvec2(0.5 * footprint, 0), footprint).z;
          before += a, after += b, moved += std::abs(a - b);
        }
      }
      meanMoved = std::max(meanMoved, std::abs(before - after) / (kSide * kSide));
      pixelMoved = std::max(pixelMoved, moved / (kSide * kSide));
    }
  }
  EXPECT_TRUE(test::holds("K03", meanMoved, test::atMost(0.01), "of the albedo"));
  EXPECT_LT(pixelMoved, 0.16);
  std::printf("[ detail ] half a pixel aside: mean %.4f, a pixel %.3f of the albedo\n", meanMoved,
              pixelMoved);
}

TEST(GroundDetail, K04_meanColourStays) {
  // Over 60 x 60 m the albedo with detail is that without within 1 %, of each material, near by and where it
  // fades.
  double worst = 0;
  for (int m = 0; m < kGroundMaterials; ++m) {
    for (const double footprint : {0.03, 0.2, 0.5}) {
      double sum = 0;
      constexpr int kSide = 160;
      for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
          sum += detailAt(m, 7, -3, {300 + 0.373 * x, 500 + 0.373 * y}, footprint).z;
      worst = std::max(worst, std::abs(sum) / (kSide * kSide));
    }
  }
  EXPECT_TRUE(test::holds("K04", worst, test::atMost(0.01), "of the albedo"));
}

TEST(GroundDetail, fadesWhereAPixelCoversHalfAMetre) {
  // Whole up to .5 m, gone from .9 m on, at any reach in proportion; none at reach 0.
  EXPECT_EQ(shared::detailShare(0.49f, 1), 1);
  EXPECT_EQ(shared::detailShare(0.91f, 1), 0);
  EXPECT_EQ(shared::detailShare(0.91f, 2), 1);
  EXPECT_EQ(shared::detailShare(1e-3f, 0), 0);
  for (float f = 0.4f; f < 0.95f; f += 0.01f)
    ASSERT_GE(shared::detailShare(f, 1), shared::detailShare(f + 0.01f, 1));
}

TEST(GroundDetail, twoMaterialsThatCountMostArePicked) {
  // Against sorting, for random shares.
  core::RandomStream random{9, 0};
  for (int i = 0; i < 20000; ++i) {
    std::array<float, 6> w;
    for (float& x : w) x = static_cast<float>(random.nextUnit());
    const shared::DetailPick pick = shared::detailPick(w[0], w[1], w[2], w[3], w[4], w[5]);
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};
    std::ranges::sort(
        order, [&](int a, int b) { return w[static_cast<std::size_t>(a)] > w[static_cast<std::size_t>(b)]; });
    ASSERT_EQ(pick.first, static_cast<float>(order[0]));
    ASSERT_EQ(pick.second, static_cast<float>(order[1]));
    const float first = w[static_cast<std::size_t>(order[0])], second = w[static_cast<std::size_t>(order[1])];
    ASSERT_NEAR(pick.share, second / (first + second), 1e-6f);
  }
}

TEST(GroundDetail, planesTurnWithoutAJump) {
  // A step of a thousandth of the normal never changes what is looked at by more than a twentieth: not where
  // the axes change places, either.
  core::RandomStream random{10, 0};
  const auto weightsOf = [](const glm::vec3& n) {
    const shared::DetailPlanes planes = shared::detailPlanes(n);
    glm::vec3 weights(0);
    weights[static_cast<int>(planes.first)] += 1 - planes.share;
    weights[static_cast<int>(planes.second)] += planes.share;
    return weights;
  };
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 n =
        glm::normalize(glm::vec3(random.nextUnit() - 0.5, random.nextUnit(), random.nextUnit() - 0.5));
    const glm::vec3 away = glm::abs(n) - glm::vec3(0.57735f);
    if (std::max({std::abs(away.x), std::abs(away.y), std::abs(away.z)}) < 0.02f)
      continue;  // all three alike
    const glm::vec3 m =
        glm::normalize(n + 0.001f * glm::vec3(random.nextUnit() - 0.5, random.nextUnit() - 0.5, 0.3));
    ASSERT_LT(glm::length(weightsOf(n) - weightsOf(m)), 0.09f) << n.x << " " << n.y << " " << n.z;
  }
  EXPECT_EQ(shared::detailPlanes({0, 1, 0}).first, 1);
  EXPECT_EQ(shared::detailPlanes({0.6f, 0.8f, 0}).share, shared::detailPlanes({-0.6f, 0.8f, 0}).share);
}

TEST(GroundDetail, piecesMeetWithoutAJump) {
  // Across the borders of triangles and cells the weight of each piece is continuous, and squares have the
  // sum 1.
  core::RandomStream random{12, 0};
  const auto weightOf = [](const shared::DetailPieces& p, std::uint32_t bits) {
    return p.first == bits    ? p.weights.x
           : p.second == bits ? p.weights.y
           : p.third == bits  ? p.weights.z
                              : 0.0f;
  };
  const auto at = [](const glm::vec2& place) {
    const glm::vec2 whole = glm::floor(place);
    return shared::detailPieces(glm::uvec2(glm::ivec2(whole)), place - whole, 3);
  };
  for (int i = 0; i < 20000; ++i) {
    const glm::vec2 place(random.nextUnit() * 50, random.nextUnit() * 50);
    const shared::DetailPieces a = at(place), b = at(place + glm::vec2(0.0005f, 0.0007f));
    ASSERT_NEAR(glm::dot(a.weights, a.weights), 1, 1e-5f);
    ASSERT_GE(a.weights.x, a.weights.y);
    ASSERT_GE(a.weights.y, a.weights.z);
    for (const std::uint32_t bits : {a.first, a.second, a.third})
      ASSERT_NEAR(weightOf(a, bits), weightOf(b, bits), 0.02f);
  }
}

TEST(GroundDetail, K05_rockLiesInLayersAndNotInStripes) {
  // A stack of rock as painted before repeats: its hardness is correlated with itself some tens of metres
  // higher. Beds of their own thickness are not, up to 200 m; they lie still where a pixel covers less than
  // they are thick, and are gone where it covers as much.
  const auto repeats = [](auto&& toneAt) {
    double most = 0;
    for (double up = 20; up < 200; up += 0.5) {
      double ab = 0, aa = 0, bb = 0;
      for (double h = 0; h < 1500; h += 0.7) {
        const double a = toneAt(h), b = toneAt(h + up);
        ab += a * b, aa += a * a, bb += b * b;
      }
      most = std::max(most, ab / std::sqrt(aa * bb));
    }
    return most;
  };
  const double before =
      repeats([](double h) { return shared::rockStrata(static_cast<float>(h), 0, 0.05f).x; });
  const shared::LandNoise none{};
  const double now = repeats([&](double h) {
    return shared::rockLayers(static_cast<float>(h), {0, 100}, none, 0.05f).tone;
  });
  std::printf("[ rock ] most alike %.2f before, %.2f now\n", before, now);
  EXPECT_GT(before, 0.6);
  EXPECT_TRUE(test::holds("K05", now, test::atMost(0.5), "of 1"));
  for (float h = -300; h < 3000; h += 1.7f) {
    ASSERT_EQ(shared::rockBeds(h, 7.3f, 6, 4).x, 0);
    ASSERT_LE(std::abs(shared::rockBeds(h, 7.3f, 6, 0.01f).x), 1);
  }
}

TEST(GroundDetail, bedsHaveTheirSlope) {
  // The slope of a bed is the derivative of its hardness: within 2 % of its greatest.
  namespace exact = core::shared::f64;
  for (double h = -50; h < 400; h += 0.0137) {
    const double d = 1e-6;
    const double slope =
        (exact::rockBeds(h + d, 7.3, 6, 0.1).x - exact::rockBeds(h - d, 7.3, 6, 0.1).x) / (2 * d);
    ASSERT_NEAR(exact::rockBeds(h, 7.3, 6, 0.1).y, slope, 0.08) << h;
  }
}

TEST(GroundDetail, faultsMoveBedsAndKeepTheirPlace) {
  // Blocks are moved by up to 16 m, change at faults alone, and lie where they are from any base.
  core::RandomStream random{14, 0};
  int moved = 0;
  for (int i = 0; i < 20000; ++i) {
    const shared::Uvec2 cell(static_cast<std::uint32_t>(random.nextUnit() * 1000), 77);
    const glm::vec2 inside(random.nextUnit(), random.nextUnit());
    const shared::Vec2 a = shared::rockFaults(cell, inside, 0),
                       b = shared::rockFaults(cell, inside + glm::vec2(0.001f, 0), 0);
    ASSERT_LE(std::abs(a.x), 16.01f);
    ASSERT_GE(a.y, 0);
    if (a.x != b.x) {
      ++moved;
      ASSERT_LT(std::min(a.y, b.y), 4.0f);
    }
    const shared::Vec2 west = shared::rockFaults(cell - shared::Uvec2(1, 0), inside + glm::vec2(1, 0), 0);
    if (a.y > 0.01f) {
      ASSERT_EQ(west.x, a.x);
    }
  }
  EXPECT_GT(moved, 20);
}

}  // namespace
}  // namespace skydrop::terrain
