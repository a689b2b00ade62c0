// Gradient-noise textures: what they hold, that they tile, and what is refused.
#include "skydrop/noise/noise_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <vector>

#include "noise/noise_rows.h"
#include "skydrop/core/error.h"
#include "skydrop/core/shared.h"
#include "support/refusal.h"

namespace skydrop::noise {
namespace {

namespace shared = core::shared::f32;

std::vector<float> valuesOf(const NoiseSettings& settings, const NoiseSize& size) {
  const NoiseGenerator generator(settings, size);
  const std::size_t layer = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  std::vector<float> values(layer * static_cast<std::size_t>(size.layers()));
  for (int z = 0; z < size.layers(); ++z) {
    generator.fillRows(z, 0, std::span(values).subspan(static_cast<std::size_t>(z) * layer, layer));
  }
  return values;
}

// FNV-1a of the texels.
std::uint64_t digestOf(const core::TextureData& texture) {
  std::uint64_t digest = 0xcbf29ce484222325u;
  for (const std::byte byte : texture.texels)
    digest = (digest ^ std::to_integer<std::uint64_t>(byte)) * 0x100000001b3u;
  return digest;
}

// Mean steps between neighbours along an axis: over the border, and beside it on both sides.
struct Steps {
  double border = 0, beside = 0;
};

Steps stepsAlong(const std::vector<float>& values, std::size_t count, std::size_t stride) {
  Steps sum;
  for (std::size_t block = 0; block < values.size(); block += stride * count) {
    for (std::size_t first = block; first < block + stride; ++first) {
      const std::size_t last = first + (count - 1) * stride;
      sum.border += std::abs(values[first] - values[last]);
      sum.beside += std::abs(values[first + stride] - values[first]) / 2;
      sum.beside += std::abs(values[last] - values[last - stride]) / 2;
    }
  }
  return sum;
}

TEST(NoiseGenerator, tilesForAnyWholeFrequency) {
  // The step over each border is as long in the mean as those beside it, also of frequencies that do not
  // divide the side.
  for (const std::int64_t frequency : {1, 3, 5, 6, 7, 13}) {
    const NoiseSettings settings{.octaves = 3, .frequency = frequency, .seed = 2};
    for (const NoiseSize size : {NoiseSize{512, 512, 0}, NoiseSize{64, 128, 128}}) {
      const std::vector<float> values = valuesOf(settings, size);
      std::size_t stride = 1;
      for (const int side : {size.width, size.height, size.layers()}) {
        if (side == 1) continue;
        const Steps steps = stepsAlong(values, static_cast<std::size_t>(side), stride);
        stride *= static_cast<std::size_t>(side);
        EXPECT_NEAR(steps.border / steps.beside, 1.0, 0.15) << frequency << " cells, side " << side;
      }
    }
  }
}

TEST(NoiseGenerator, theLastCellEndsWhereTheFirstBegins) {
  // At the end of a period the noise has the values of its beginning, along each axis and for any number of
  // cells.
  for (const std::uint32_t cells : {1u, 3u, 6u, 512u, 16777216u}) {
    const std::uint32_t last = cells - 1;
    for (const float v : {0.0f, 0.25f, 0.75f}) {
      // The same sums in another order: within a few roundings of values below 1.5.
      constexpr double kRoundings = 4e-7;
      EXPECT_NEAR(shared::gradientNoise2({last, 0}, {1, v}, cells, 9),
                  shared::gradientNoise2({0, 0}, {0, v}, cells, 9), kRoundings);
      EXPECT_NEAR(shared::gradientNoise2({0, last}, {v, 1}, cells, 9),
                  shared::gradientNoise2({0, 0}, {v, 0}, cells, 9), kRoundings);
      EXPECT_NEAR(shared::gradientNoise3({last, 0, 0}, {1, v, 0.5f}, cells, 9),
                  shared::gradientNoise3({0, 0, 0}, {0, v, 0.5f}, cells, 9), kRoundings);
      EXPECT_NEAR(shared::gradientNoise3({0, last, 0}, {v, 1, 0.5f}, cells, 9),
                  shared::gradientNoise3({0, 0, 0}, {v, 0, 0.5f}, cells, 9), kRoundings);
      EXPECT_NEAR(shared::gradientNoise3({0, 0, last}, {v, 0.5f, 1}, cells, 9),
                  shared::gradientNoise3({0, 0, 0}, {v, 0.5f, 0}, cells, 9), kRoundings);
    }
  }
}

TEST(NoiseGenerator, placesOfTexelsAreExact) {
  // Cell and position inside it are those of 64-bit arithmetic, up to the finest lattice of the largest
  // texture.
  for (const std::uint32_t size : {1u, 2u, 64u, 8192u, 16384u}) {
    for (const std::uint32_t cells : {1u, 6u, 511u, 4096u, 12345678u, 1u << 24}) {
      for (const std::uint32_t texel : {0u, size / 3, size / 2, size - 1}) {
        const std::uint64_t exact = (2ull * texel + 1) * cells;
        const glm::u32vec2 found = shared::cellOfTexel(texel, size, cells);
        EXPECT_EQ(found.x, exact / (2ull * size)) << texel << " of " << size << ", " << cells << " cells";
        EXPECT_EQ(found.y, exact % (2ull * size)) << texel << " of " << size << ", " << cells << " cells";
      }
    }
  }
}

TEST(NoiseGenerator, valuesLieAroundOneHalf) {
  // One octave of unit weight: mean .5, and half of the deviation that follows from the definition. Of a fade
  // f, a = integral of (1 - f)^2 and b = integral of (u (1 - f))^2 over a cell, gradients of length sqrt(2)
  // give the variance 8 a b in a plane and 16 a^2 b in space.
  double a = 0, b = 0;
  for (int i = 0; i < 1000; ++i) {
    const double u = (i + 0.5) / 1000, rest = 1 - core::shared::f64::smoothStep5(u);
    a += rest * rest / 1000;
    b += u * u * rest * rest / 1000;
  }
  const NoiseSettings one{.octaves = 1, .frequency = 64, .amplitude = 1, .seed = 4};
  const auto check = [&](const NoiseSize& size, double deviation) {
    const std::vector<float> values = valuesOf(one, size);
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double square = 0;
    for (const float value : values) {
      EXPECT_TRUE(value >= 0 && value <= 1);
      square += (value - mean) * (value - mean);
    }
    EXPECT_NEAR(mean, 0.5, 0.005);  // of 4096 cells and more
    EXPECT_NEAR(std::sqrt(square / n) * 2, deviation, 0.01);
  };
  check({512, 512, 0}, std::sqrt(8 * a * b));
  check({128, 128, 128}, std::sqrt(16 * a * a * b));
}

TEST(NoiseGenerator, octavesWeighByPersistence) {
  // Two octaves are the sum of each alone, the second of twice the frequency and half the weight.
  const NoiseSize size{64, 64, 0};
  const NoiseSettings both{.octaves = 2, .frequency = 5, .amplitude = 0.5, .persistence = 0.5, .seed = 8};
  NoiseSettings first = both;
  first.octaves = 1;
  const std::vector<float> sum = valuesOf(both, size), one = valuesOf(first, size);
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) {
      const glm::u32vec2 cx = shared::cellOfTexel(x, 64, 10), cy = shared::cellOfTexel(y, 64, 10);
      const float second = shared::gradientNoise2(
          {cx.x, cy.x}, {static_cast<float>(cx.y) / 128, static_cast<float>(cy.y) / 128}, 10,
          shared::octaveSalt(8, 1, 2));
      ASSERT_NEAR(sum[y * 64 + x], one[y * 64 + x] + 0.5 * 0.25 * second,
                  2e-7);  // roundings of values below 1
    }
  }
}

TEST(NoiseGenerator, rowsAreTheSameHoweverTheyAreAskedFor) {
  const NoiseSettings settings{.octaves = 5, .frequency = 3, .seed = 11};
  const NoiseSize size{32, 16, 8};
  const NoiseGenerator generator(settings, size);
  const std::vector<float> whole = valuesOf(settings, size);
  std::vector<float> some(3 * 32);
  generator.fillRows(5, 9, some);
  EXPECT_TRUE(std::equal(some.begin(), some.end(), whole.begin() + 5 * 32 * 16 + 9 * 32));
}

TEST(NoiseGenerator, kernelsOfEveryInstructionSetGiveTheBitsOfThePlainDefinition) {
  // Coarse and fine lattices, more cells than texels, one cell, sides of one texel, aliased and vanishing
  // octaves. (Sets that the processor lacks are left out.)
  const NoiseSettings many[] = {{.octaves = 7, .frequency = 3, .seed = 5},
                                {.octaves = 2, .frequency = 1, .amplitude = 4, .persistence = 1},
                                {.octaves = 16, .frequency = 511, .persistence = 0.9, .seed = 4294967295}};
  const NoiseSize sizes[] = {{64, 32, 0}, {16, 8, 4}, {1, 1, 0}, {8, 1, 2}, {1, 64, 0}, {2, 2, 16}};
  for (const NoiseSettings& settings : many) {
    for (const NoiseSize& size : sizes) {
      const NoiseGenerator generator(settings, size);
      std::vector<float> values(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
      for (const InstructionSet set : core::kInstructionSets) {
        const OctaveKernels* kernels = octaveKernels(set);
        if (kernels == nullptr) continue;
        const NoiseRows rows(settings, size, *kernels);
        for (int z = 0; z < size.layers(); ++z) {
          rows.fill(z, 0, values);
          for (std::size_t i = 0; i < values.size(); ++i) {
            const int x = static_cast<int>(i) % size.width, y = static_cast<int>(i) / size.width;
            ASSERT_EQ(values[i], generator.valueAt(x, y, z))
                << "set " << static_cast<int>(set) << ", frequency " << settings.frequency << ", width "
                << size.width << " at " << x << ", " << y << ", " << z;
          }
        }
      }
    }
  }
}

TEST(NoiseGenerator, theSameOnEveryMachine) {
  // The digest changes when the definition does, whatever the processor and the compiler.
  const core::TextureData plane = make2d({.seed = 1}, 128, 128, {.format = core::TexelFormat::r32f});
  const core::TextureData volume = make3d({.seed = 1}, 32, 32, 32, {.format = core::TexelFormat::r32f});
  EXPECT_EQ(digestOf(plane), 48679191606853471u);
  EXPECT_EQ(digestOf(volume), 11975247971779051567u);
}

TEST(NoiseGenerator, seedsAndOctavesHaveNothingInCommon) {
  // The correlation of two seeds is that of independent noise: a few parts in a hundred of 16 x 16 cells.
  const NoiseSize size{128, 128, 0};
  const std::vector<float> a = valuesOf({.octaves = 1, .frequency = 16, .seed = 0}, size);
  for (const std::int64_t seed : {std::int64_t{1}, std::int64_t{2}, std::int64_t{4294967295}}) {
    const std::vector<float> b = valuesOf({.octaves = 1, .frequency = 16, .seed = seed}, size);
    double ab = 0, aa = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      ab += (a[i] - 0.5) * (b[i] - 0.5);
      aa += (a[i] - 0.5) * (a[i] - 0.5);
    }
    EXPECT_LT(std::abs(ab / aa), 0.2) << seed;
  }
}

TEST(NoiseGenerator, isLegalAtItsLimits) {
  // The finest lattice has 2^24 cells, 2^10 to a texel; sides of one texel; no weight at all.
  NoiseSettings finest{.octaves = 16, .frequency = 512, .amplitude = 4, .persistence = 1};
  for (const NoiseSize size : {NoiseSize{64, 64, 0}, NoiseSize{16, 8, 4}, NoiseSize{1, 1, 0},
                               NoiseSize{1, 1, 1}, NoiseSize{8, 1, 2}, NoiseSize{1, 8192, 0}}) {
    for (const float value : valuesOf(finest, size)) ASSERT_TRUE(value >= 0 && value <= 1);
  }
  for (const float value : valuesOf({.amplitude = 0}, {32, 32, 32})) ASSERT_EQ(value, 0.5f);
  for (const float value : valuesOf({.octaves = 16, .persistence = 0}, {32, 32, 0}))
    ASSERT_TRUE(std::isfinite(value));
}

TEST(NoiseGenerator, postProcessIsItsFormula) {
  // Against doubles and the library's pow; the last bit of a float is all that may differ.
  for (const PostProcess cut : {PostProcess{0.3, 0.99}, PostProcess{0.7, 0.95}, PostProcess{0, 0.5},
                                PostProcess{0.5, 0}, PostProcess{0.5, 1}, PostProcess{1, 0.9}}) {
    std::vector<float> values;
    for (int i = 0; i <= 1000; ++i) values.push_back(static_cast<float>(i) / 1000);
    std::vector<float> made = values;
    applyPostProcess(cut, made);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double above = static_cast<double>(values[i]) - cut.cutoff;
      const double expected = above > 0 ? 1 - std::pow(cut.density, 255 * above) : 0;
      ASSERT_NEAR(made[i], expected, 6e-8)
          << values[i] << ", cutoff " << cut.cutoff << ", density " << cut.density;
    }
  }
}

TEST(NoiseGenerator, texelsAreTheNearestStep) {
  const NoiseSettings settings{.octaves = 4, .frequency = 4};
  const std::vector<float> values = valuesOf(settings, {64, 32, 0});
  const auto made = [&](core::TexelFormat format) { return make2d(settings, 64, 32, {.format = format}); };
  const core::TextureData bytes = made(core::TexelFormat::a8), words = made(core::TexelFormat::r16),
                          floats = made(core::TexelFormat::r32f);
  EXPECT_EQ(bytes.texels, made(core::TexelFormat::r8).texels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint16_t word = 0;
    float exact = 0;
    std::memcpy(&word, words.texels.data() + i * 2, 2);
    std::memcpy(&exact, floats.texels.data() + i * 4, 4);
    ASSERT_EQ(exact, values[i]);
    // Half a step, and the rounding of the product.
    ASSERT_NEAR(std::to_integer<int>(bytes.texels[i]) / 255.0, values[i], 0.5001 / 255);
    ASSERT_NEAR(word / 65535.0, values[i], 0.51 / 65535);
  }
}

TEST(NoiseGenerator, stopsAndTellsHowFarItIs) {
  std::stop_source source;
  std::vector<double> told;
  const MakeOptions options{.stop = source.get_token(), .progress = [&](double share) {
                              told.push_back(share);
                              if (share >= 0.5) source.request_stop();
                            }};
  EXPECT_EQ(make3d({}, 32, 32, 32, options).width, 0);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_DOUBLE_EQ(told.back(), 0.5);
  told.clear();
  EXPECT_EQ(make3d({}, 32, 32, 32, {.progress = [&](double share) { told.push_back(share); }}).depth, 32);
  EXPECT_DOUBLE_EQ(told.front(), 0);
  EXPECT_DOUBLE_EQ(told.back(), 1);
}

std::string refusal(const NoiseSettings& settings, const NoiseSize& size, const MakeOptions& options = {}) {
  return test::refusalOf<core::RangeError>([&] { makeNoise(settings, size, options); });
}

TEST(NoiseGenerator, refusesAtTheDoor) {
  const NoiseSize good{64, 64, 0};
  EXPECT_EQ(refusal({.octaves = 0}, good), "octaves: 0 is out of range 1 to 16");
  EXPECT_EQ(refusal({.octaves = 17}, good), "octaves: 17 is out of range 1 to 16");
  EXPECT_EQ(refusal({.frequency = 0}, good), "frequency: 0 is out of range 1 to 512");
  EXPECT_EQ(refusal({.amplitude = std::nan("")}, good), "amplitude: nan is not a finite number");
  EXPECT_EQ(refusal({.persistence = 1.5}, good), "persistence: 1.5 is out of range 0 to 1");
  EXPECT_EQ(refusal({.seed = -1}, good), "seed: -1 is out of range 0 to 4294967295");
  EXPECT_EQ(refusal({}, {0, 64, 0}), "width: 0 is out of range 1 to 8192");
  EXPECT_EQ(refusal({}, {64, 3, 0}),
            "height: 3 is not a power of two, which exact tiling and mip levels need");
  EXPECT_EQ(refusal({}, {100000, 64, 0}), "width: 100000 is out of range 1 to 8192");
  EXPECT_EQ(refusal({}, {64, 64, -1}), "slices: -1 is out of range 1 to 1024");
  EXPECT_EQ(refusal({}, {1024, 1024, 1024}), "size: 1024 MiB of texels: more than 256 MiB");
  EXPECT_EQ(refusal({}, good, {.postProcess = PostProcess{.cutoff = 2}}), "cutoff: 2 is out of range 0 to 1");
  EXPECT_EQ(refusal({}, good, {.format = core::TexelFormat::rgba8}),
            "noise is made as a8, r8, r16 or r32f, not as rgba8");
  EXPECT_EQ(test::refusalOf<core::RangeError>([] { make3d({}, 8, 8, 0); }),
            "slices: 0 is out of range 1 to 1024");
}

}  // namespace
}  // namespace skydrop::noise
