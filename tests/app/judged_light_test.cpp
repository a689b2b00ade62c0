// The light in clouds that was traced, as it is kept in assets/judged_clouds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "app/studies/light_pictures.h"
#include "app/studies/light_scenes.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "support/instrumented.h"
#include "support/mutants.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

TEST(JudgedLight, eachSceneHasItsFileAndComesBackAsItWasWritten) {
  for (const LightScene& scene : lightScenes()) {
    const JudgedLight judged = readJudged(scene, judgedFile(scene));
    EXPECT_EQ(judged.views.size(), lightViews(scene).size()) << scene.name;
    EXPECT_EQ(judgedText(scene, judged), core::readTextFile(judgedFile(scene))) << scene.name;
  }
}

TEST(JudgedLight, thatOfAnotherSceneIsRefused) {
  const LightScene &one = lightScenes()[0], &other = lightScenes()[1];
  EXPECT_EQ(
      test::refusalOf<core::DataError>([&] { readJudged(one, judgedFile(other)); }),
      judgedFile(other).string() + ": digest: is of another scene: skydrop accuracy judge makes it again");
}

TEST(JudgedLight, mutantsAreReadOrRefusedInOneLine) {
  const test::TemporaryFolder folder;
  const LightScene& scene = lightScenes()[0];
  const std::string good = core::readTextFile(judgedFile(scene));
  int refused = 0, read = 0;
  test::forEachMutant(good, test::repetitions(200), [&](const std::string& mutant) {
    const std::string file = test::writePlainly(folder.path() / "judged.json", mutant);
    try {
      EXPECT_EQ(readJudged(scene, file).views.size(), lightViews(scene).size());
      ++read;
    } catch (const core::DataError& refusal) {
      EXPECT_TRUE(test::isOneLineAbout(refusal.what(), "judged.json")) << refusal.what();
      ++refused;
    }
  });
  EXPECT_GT(refused, read / 10);
}

TEST(LightPictures, octavesPathsAndVolumeAreBesideEachOther) {
  const LightScene& scene = lightScene("cumulus-40");
  const Size each{6, 3};
  std::vector<std::string> told;
  const auto tell = [&](std::string_view view) { told.emplace_back(view); };
  const core::Image image = lightPictures(scene, each, 32, nullptr, tell);
  const std::size_t views = lightViews(scene).size();
  EXPECT_EQ(told.size(), views);
  ASSERT_EQ(image.width, 3 * each.width);
  ASSERT_EQ(image.height, static_cast<int>(views) * each.height);
  // Of the pixels with cloud the volume is nearer to the paths than octaves are, in the mean.
  double octaves = 0, volume = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < each.width; ++x) {
      const int traced = image.pixel(x + each.width, y)[1];
      octaves += std::abs(image.pixel(x, y)[1] - traced);
      volume += std::abs(image.pixel(x + 2 * each.width, y)[1] - traced);
    }
  }
  EXPECT_GT(octaves, 1.5 * volume) << "differences of green: " << octaves << ", " << volume;
}

}  // namespace
}  // namespace skydrop::app
