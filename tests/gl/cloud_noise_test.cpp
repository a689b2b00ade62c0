// The clouds' noise as a graphics card makes it at the start of the program.
#include "app/session/cloud_noise.h"

#include "skydrop/clouds/noise_cache.h"
#include "support/gl_test.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using CloudNoiseGLTest = test::GLTest;

// Largest difference of two channels of the same size.
double largestDifference(std::span<const float> a, std::span<const float> b) {
  double largest = a.size() == b.size() ? 0 : 1e9;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(a[i]) - b[i]));
  }
  return largest;
}

std::span<const float> floatsOf(const std::vector<glm::vec3>& map) { return {&map[0].x, 3 * map.size()}; }

TEST_F(CloudNoiseGLTest, whatTheCardMakesIsTheProcessorsWithinOneStepAndIsKept) {
  // With an empty cache, an eighth of a texture a call; packed it differs by no more than a step of 8 bits.
  constexpr double kStep = 1.0 / 255;
  const test::TemporaryFolder folder;
  CloudNoise noise(NoiseStore(folder.path()), CloudNoise::Maker::graphics);
  int calls = 0;
  double last = 0;
  while (!noise.get()) {
    noise.makePart(context());
    calls += noise.progress() > last ? 1 : 0;
    last = noise.progress();
  }
  EXPECT_EQ(calls, 24) << "three textures in eight frames each";
  EXPECT_DOUBLE_EQ(noise.progress(), 1);
  EXPECT_TRUE(noise.takeMessages().empty());
  const auto made = noise.get(), right = test::sharedNoise();
  EXPECT_LE(largestDifference(made->detail, right->detail), kStep * 1.0001);
  EXPECT_LE(largestDifference(floatsOf(made->weather), floatsOf(right->weather)), kStep * 1.0001);
  EXPECT_LE(largestDifference(made->base, right->base), kStep * 1.0001);
  for (const clouds::NoiseTexture texture : clouds::kNoiseTextures) {
    EXPECT_EQ(clouds::loadNoise(folder.path(), texture, CloudNoise::kSeed).state, clouds::CacheState::good);
  }
  const CloudNoise again(NoiseStore(folder.path()), CloudNoise::Maker::graphics);
  EXPECT_EQ(again.wait()->base, made->base) << "from the cache, with nobody making parts";
}

}  // namespace
}  // namespace skydrop::app
