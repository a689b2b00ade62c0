// The light in clouds that was traced, as it is kept in assets/judged_clouds.
#include <gtest/gtest.h>

#include <string>

#include "app/studies/light_scenes.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
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

}  // namespace
}  // namespace skydrop::app
