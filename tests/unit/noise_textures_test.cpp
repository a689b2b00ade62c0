#include "skydrop/clouds/noise_textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "skydrop/clouds/noise_cache.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/shared.h"
#include "support/instrumented.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::clouds {
namespace {

namespace shared = core::shared::f32;

// Kept in a cache: theDefinitionIsTheOneThatItsNumberNames makes them again and holds what lies there to it.
const core::TextureData& texture(NoiseTexture which) {
  static std::array<core::TextureData, 3> loaded;
  core::TextureData& kept = loaded[static_cast<std::size_t>(which)];
  if (kept.width == 0) kept = test::sharedTexture(which);
  return kept;
}

struct ChannelSpread {
  int least = 255, most = 0;
  double mean = 0, variance = 0;
};

ChannelSpread spreadOf(const core::TextureData& data, std::size_t channel) {
  ChannelSpread spread;
  double sum = 0, squares = 0;
  for (std::size_t i = channel; i < data.texels.size(); i += 4) {
    const int value = std::to_integer<int>(data.texels[i]);
    spread.least = std::min(spread.least, value);
    spread.most = std::max(spread.most, value);
    sum += value;
    squares += value * value;
  }
  const double count = static_cast<double>(data.texels.size() / 4);
  spread.mean = sum / count;
  spread.variance = squares / count - spread.mean * spread.mean;
  return spread;
}

TEST(NoiseTextures, everyFaceMeetsTheOppositeOne) {
  // The step over a border is like the steps inside: a texture that does not tile has a ratio of 5 and more.
  for (const NoiseTexture which : kNoiseTextures) {
    EXPECT_NEAR(seamRoughness(texture(which)), 1, 0.25) << noiseLayout(which).name;
  }
  core::TextureData cut = texture(NoiseTexture::weather);
  for (std::size_t i = 0; i < cut.texels.size(); ++i) {
    if (i / 4 % 512 >= 256) cut.texels[i] = ~cut.texels[i];  // the right half as a negative
  }
  EXPECT_GT(seamRoughness(cut), 5) << "the measure does not see a seam";
}

TEST(NoiseTextures, theSeamOfAnyTextureIsANumber) {
  // An axis of one texel has no border to cross; floats are compared as floats, and NaN counts for nothing.
  using core::TexelFormat;
  for (const auto& [width, height, depth] :
       {std::array{1, 1, 0}, {1, 4, 0}, {4, 1, 0}, {1, 1, 1}, {1, 1, 4}, {4, 4, 1}}) {
    core::TextureData texture(TexelFormat::rg8, width, height, depth);
    EXPECT_EQ(seamRoughness(texture), 0) << width << "x" << height << "x" << depth;
  }
  core::TextureData column(TexelFormat::r8, 1, 4, 0);
  for (std::size_t y = 0; y < 4; ++y) column.texels[y] = static_cast<std::byte>(y);
  EXPECT_DOUBLE_EQ(seamRoughness(column), 3)
      << "a ramp of four texels steps by one inside and by three over the border";
  core::TextureData ramp(TexelFormat::r32f, 4, 1, 0);
  const std::array<float, 4> values = {0, 0.5f, 1, 1.5f};
  std::memcpy(ramp.texels.data(), values.data(), sizeof values);
  EXPECT_DOUBLE_EQ(seamRoughness(ramp), 3);
  std::fill(ramp.texels.begin(), ramp.texels.end(), std::byte{0xff});  // NaN
  EXPECT_EQ(seamRoughness(ramp), 0);
}

TEST(NoiseTextures, everyChannelFillsItsBytes) {
  // Mean near the middle, a standard deviation of an eighth of the range or more, few texels at the ends.
  const std::array channels = {4u, 3u, 3u};
  for (const NoiseTexture which : kNoiseTextures) {
    for (std::size_t channel = 0; channel < channels[static_cast<std::size_t>(which)]; ++channel) {
      const ChannelSpread spread = spreadOf(texture(which), channel);
      const bool isPrecipitation = which == NoiseTexture::weather && channel == 1;
      EXPECT_GT(spread.variance, 32.0 * 32.0) << noiseLayout(which).name << channel;
      EXPECT_NEAR(spread.mean, isPrecipitation ? 40 : 128, 30) << noiseLayout(which).name << channel;
    }
  }
}

TEST(NoiseTextures, worleyNoiseIsItsDefinition) {
  // Against every feature point of the period and its copies around, in double.
  using core::shared::f64::Vec3;
  for (const std::uint32_t cells : {2u, 5u}) {
    for (int i = 0; i < 200; ++i) {
      const Vec3 place =
          Vec3(i * 0.377, i * 0.7177, i * 0.1357) - glm::floor(Vec3(i * 0.377, i * 0.7177, i * 0.1357));
      double nearest = 3;
      const int n = static_cast<int>(cells);
      for (int z = -1; z <= n; ++z) {
        for (int y = -1; y <= n; ++y) {
          for (int x = -1; x <= n; ++x) {
            const auto wrapped = [n](int cell) { return static_cast<std::uint32_t>((cell + n) % n); };
            const glm::u32vec3 bits = shared::pointBits(wrapped(x), wrapped(y), wrapped(z), 77u);
            const Vec3 feature = Vec3(x, y, z) + core::shared::f64::units(bits);
            nearest =
                std::min(nearest, glm::dot(feature - place * double(cells), feature - place * double(cells)));
          }
        }
      }
      // Exact in double; float's rounding of a distance of up to 5 cells.
      EXPECT_NEAR(core::shared::f64::worley3(place, cells, 77u), 1 - std::sqrt(nearest / 3), 1e-12);
      EXPECT_NEAR(shared::worley3(glm::vec3(place), cells, 77u), 1 - std::sqrt(nearest / 3), 2e-6);
    }
  }
}

TEST(NoiseTextures, slicesAreTheWhole) {
  for (const NoiseTexture which : kNoiseTextures) {
    const NoiseLayout& layout = noiseLayout(which);
    std::vector<std::byte> slices(2 * layout.sliceBytes());
    fillNoise(which, 0, 7, slices);
    EXPECT_TRUE(
        std::equal(slices.begin(), slices.end(),
                   texture(which).texels.begin() + static_cast<std::ptrdiff_t>(7 * layout.sliceBytes())));
  }
}

TEST(NoiseTextures, seedsGiveDifferentSkiesAndStopsAreHeard) {
  EXPECT_GT(noiseDifference(makeNoise(NoiseTexture::detail, 1), texture(NoiseTexture::detail)).mean, 20);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(makeNoise(NoiseTexture::shape, 0, stop.get_token()).width, 0);
}

class NoiseCacheTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::filesystem::path file() const { return noiseCacheFile(folder_.path(), NoiseTexture::detail, 3); }
  CachedNoise load() const { return loadNoise(folder_.path(), NoiseTexture::detail, 3); }
};

TEST_F(NoiseCacheTest, whatIsSavedIsLoaded) {
  EXPECT_EQ(load().state, CacheState::missing);
  saveNoise(folder_.path() / "new", NoiseTexture::detail, 3, texture(NoiseTexture::detail));
  const CachedNoise cached = loadNoise(folder_.path() / "new", NoiseTexture::detail, 3);
  EXPECT_EQ(cached.state, CacheState::good);
  EXPECT_EQ(cached.texture, texture(NoiseTexture::detail));
  EXPECT_EQ(loadNoise(folder_.path() / "new", NoiseTexture::detail, 4).state, CacheState::missing)
      << "another seed";
}

TEST_F(NoiseCacheTest, everyDamageIsNoticed) {
  saveNoise(folder_.path(), NoiseTexture::detail, 3, texture(NoiseTexture::detail));
  const std::vector<std::byte> good = core::readFile(file());
  for (std::size_t at = 0; at < good.size(); at += at < 200 ? 1 : 997) {
    std::vector<std::byte> bytes = good;
    bytes[at] ^= std::byte{0x10};
    core::writeFileAtomically(file(), bytes);
    // Some fields of the DDS header say nothing about the texels: then the texture is still whole.
    const CachedNoise cached = load();
    EXPECT_TRUE(cached.state == CacheState::damaged || cached.texture == texture(NoiseTexture::detail)) << at;
    const bool isTexel = at >= good.size() - texture(NoiseTexture::detail).texels.size();
    EXPECT_TRUE(!isTexel || cached.state == CacheState::damaged) << at;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{20}, std::size_t{100}, good.size() - 1}) {
    core::writeFileAtomically(file(), std::span(good).first(size));
    EXPECT_EQ(load().state, CacheState::damaged) << size;
  }
  core::writeFileAtomically(file(), core::encodeDds(texture(NoiseTexture::detail), core::DdsHeader::dx10));
  EXPECT_EQ(load().state, CacheState::damaged) << "a DDS file without the header";
}

TEST_F(NoiseCacheTest, aFolderThatCannotBeMadeIsAnError) {
  EXPECT_THROW(saveNoise("/proc/skydrop", NoiseTexture::detail, 3, texture(NoiseTexture::detail)),
               core::DataError);
}

TEST(NoiseCache, theDefinitionIsTheOneThatItsNumberNames) {
  // Whoever changes the noise raises kNoiseDefinition, or old caches would be taken for new ones. Under a
  // sanitizer without the shape, which is made by the same code as the detail and takes fifty times as long.
  EXPECT_EQ(kNoiseDefinition, 1u);
  for (const NoiseTexture which : kNoiseTextures) {
    if (test::kInstrumented && which == NoiseTexture::shape) continue;
    const core::TextureData made = makeNoise(which, 0);
    EXPECT_EQ(noiseDigest(made), kMadeByProcessor[static_cast<std::size_t>(which)])
        << noiseLayout(which).name;
    EXPECT_EQ(made, texture(which)) << noiseLayout(which).name;
  }
}

}  // namespace
}  // namespace skydrop::clouds
