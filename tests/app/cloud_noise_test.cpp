#include "app/session/cloud_noise.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "skydrop/clouds/noise_cache.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using clouds::NoiseTexture;
using Maker = CloudNoise::Maker;

// A cache of the test's own. What it takes too long to make stands in for itself: a shape of zeros.
class CloudNoiseTest : public testing::Test {
 protected:
  void keep(NoiseTexture texture, const core::TextureData& made) const {
    clouds::saveNoise(folder_.path(), texture, CloudNoise::kSeed, made);
  }
  void keepEmptyShape() const { keep(NoiseTexture::shape, clouds::emptyNoise(NoiseTexture::shape)); }
  std::filesystem::path file(NoiseTexture texture) const {
    return clouds::noiseCacheFile(folder_.path(), texture, CloudNoise::kSeed);
  }
  clouds::CacheState stateOf(NoiseTexture texture) const {
    return clouds::loadNoise(folder_.path(), texture, CloudNoise::kSeed).state;
  }
  NoiseStore store() const { return NoiseStore(folder_.path()); }

  const test::TemporaryFolder folder_;
};

double secondsOf(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST_F(CloudNoiseTest, theFirstRunMakesWhatIsMissingAndTheSecondReadsIt) {
  keepEmptyShape();
  CloudNoise first(store(), Maker::processor);
  const auto noise = first.wait();
  ASSERT_TRUE(noise);
  EXPECT_EQ(first.get(), noise);
  EXPECT_EQ(first.progress(), 1);
  EXPECT_TRUE(first.takeMessages().empty());
  EXPECT_EQ(noise->detail, test::sharedNoise()->detail);
  EXPECT_EQ(noise->weather, test::sharedNoise()->weather);
  EXPECT_EQ(stateOf(NoiseTexture::detail), clouds::CacheState::good);
  EXPECT_EQ(stateOf(NoiseTexture::weather), clouds::CacheState::good);
  // Read, not made: what was put there meanwhile comes back.
  keep(NoiseTexture::detail, clouds::emptyNoise(NoiseTexture::detail));
  CloudNoise second(store(), Maker::processor);
  EXPECT_NE(second.wait()->detail, noise->detail);
  EXPECT_EQ(second.wait()->weather, noise->weather);
}

TEST_F(CloudNoiseTest, aDamagedFileIsSaidInOneLineAndMadeAgain) {
  test::copySharedNoise(folder_.path());
  std::filesystem::resize_file(file(NoiseTexture::detail), 1000);
  CloudNoise noise(store(), Maker::processor);
  EXPECT_EQ(noise.wait()->detail, test::sharedNoise()->detail);
  const std::vector<std::string> messages = noise.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0], file(NoiseTexture::detail).string() + ": damaged; it is made again");
  EXPECT_TRUE(noise.takeMessages().empty()) << "once";
  EXPECT_EQ(stateOf(NoiseTexture::detail), clouds::CacheState::good);
  EXPECT_EQ(noise.get()->base, test::sharedNoise()->base) << "the others were read";
}

TEST_F(CloudNoiseTest, aCacheThatCannotBeWrittenIsSaidOnceAndTheNoiseIsThere) {
  // Detail and weather are missing, and where their folder should be there is a file: one line for both.
  keepEmptyShape();
  const std::filesystem::path blocked = folder_.path() / "blocked";
  std::ofstream(blocked) << "a file";
  CloudNoise noise(NoiseStore(blocked / "cache"), Maker::processor);
  ASSERT_TRUE(noise.wait());
  const std::vector<std::string> messages = noise.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_NE(messages[0].find((blocked / "cache").string()), std::string::npos) << messages[0];
  EXPECT_NE(messages[0].find("again at every start"), std::string::npos) << messages[0];
  EXPECT_EQ(messages[0].find('\n'), std::string::npos);
}

TEST_F(CloudNoiseTest, quittingWhileItIsMadeIsPrompt) {
  // An empty cache: the shape alone takes more than a second. It stops within 200 ms, a tenth of what a
  // player takes for a hang, and a slice of 11 ms is what it needs; nothing half made is kept.
  for (const Maker maker : {Maker::processor, Maker::graphics}) {
    auto noise = std::make_unique<CloudNoise>(store(), maker);
    if (maker == Maker::processor) {
      while (noise->progress() == 0) std::this_thread::yield();
    }
    EXPECT_FALSE(noise->get());
    EXPECT_LT(secondsOf([&] { noise.reset(); }), 0.2);
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  }
}

TEST_F(CloudNoiseTest, progressGrowsWhileTheCallerGoesOn) {
  // Nothing blocks the thread that asks, and it sees the share grow.
  CloudNoise noise(store(), Maker::processor);
  double last = noise.progress();
  int steps = 0;
  EXPECT_LT(secondsOf([&] { static_cast<void>(noise.get()), static_cast<void>(noise.progress()); }), 0.05);
  while (steps < 3) {
    const double now = noise.progress();
    ASSERT_GE(now, last);
    ASSERT_LE(now, 1);
    steps += now > last ? 1 : 0;
    last = now;
    std::this_thread::yield();
  }
}

}  // namespace
}  // namespace skydrop::app
