// The camera in the world as the command line places it: pictures of the program against each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "skydrop/core/image.h"
#include "support/image_compare.h"
#include "support/process.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

struct Picture {
  core::Image image;
  std::string err;
};

class WorldCamera : public testing::Test {
 protected:
  // What the program draws with these words; skips the test without OpenGL.
  Picture picture(std::vector<std::string> words) {
    const char* backend = std::getenv("SKYDROP_TEST_BACKEND");
    const std::string file = (folder_.path() / "picture.png").string();
    words.insert(words.begin(), {"render", "--scene", "terrain", "--size", "160x90", "--out", file,
                                 "--backend", backend ? backend : "egl"});
    const ProcessResult result = runSkydrop(words);
    if (result.exitCode == 3) {
      [&] { GTEST_SKIP() << result.err; }();
      return {};
    }
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return {core::readPng(file), result.err};
  }

  static bool areEqual(const core::Image& a, const core::Image& b) {
    const ImageDifference difference = compareImages(a, b);
    return difference.sameSize && difference.largest == 0;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(WorldCamera, compassDegreesAndAPoseSeeTheSame) {
  // Heading 130 is yaw 40; every angle is taken over.
  const Picture pose = picture({"--pose=6500,1000,-1800,40,-6,20"});
  if (IsSkipped()) return;
  const Picture camera =
      picture({"--camera=6500,1000,-1800", "--heading", "130", "--pitch=-6", "--roll", "20"});
  EXPECT_TRUE(areEqual(pose.image, camera.image));
  EXPECT_EQ(camera.err, "");
}

TEST_F(WorldCamera, theHudStaysOutUnlessItIsAskedFor) {
  // Without a word the picture is that of --no-hud and of the setting; --hud and view.hud=true bring the HUD
  // back.
  const std::string pose = "--pose=6500,1000,-1800,340,-6,0";
  const Picture plain = picture({pose});
  if (IsSkipped()) return;
  EXPECT_TRUE(areEqual(plain.image, picture({pose, "--no-hud"}).image));
  EXPECT_TRUE(areEqual(plain.image, picture({pose, "--set", "view.hud=false"}).image));
  const Picture asked = picture({pose, "--hud"});
  EXPECT_FALSE(areEqual(plain.image, asked.image));
  EXPECT_TRUE(areEqual(asked.image, picture({pose, "--set", "view.hud=true"}).image));
  // From the aircraft it is there without a word.
  EXPECT_FALSE(areEqual(picture({}).image, picture({"--no-hud"}).image));
}

TEST_F(WorldCamera, aCameraUnderLandIsSaidOnceAndDraws) {
  const Picture below = picture({"--camera=6500,-40,-1800", "--above-ground"});
  if (IsSkipped()) return;
  EXPECT_NE(below.err.find("40.0 m under the land"), std::string::npos) << below.err;
  EXPECT_EQ(std::count(below.err.begin(), below.err.end(), '\n'), 1) << below.err;
  EXPECT_NE(picture({"--pose=6500,-900,-1800,0,0,0"}).err.find("under the land"), std::string::npos);
}

}  // namespace
}  // namespace skydrop::test
