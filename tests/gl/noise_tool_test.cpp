// The noise tool without its window: what it shows, and that no frame waits for it.
#include "app/window/noise_tool.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <thread>

#include "skydrop/core/file.h"
#include "support/gl_test.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

constexpr Size kSize{640, 360};

class NoiseToolGLTest : public test::GLTest {
 protected:
  // Frames until the full texture is shown.
  static void settle(NoiseTool& tool) {
    for (int i = 0; i < 20000 && !tool.isSettled(); ++i) {
      tool.draw(kSize, 0);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_TRUE(tool.isSettled());
    tool.draw(kSize, 0);
    tool.draw(kSize, 0);
  }
};

TEST_F(NoiseToolGLTest, aChangeIsShownSmallFirstAndFramesGoOnMeanwhile) {
  // A volume that takes a second or more: every frame returns while it is made, the small one is there long
  // before it, and the settings that are newer take its place.
  NoiseTool tool(context(), kSize);
  tool.settings().kind = NoiseKind::volume;
  tool.settings().volumeSide = VolumeSide::side256;
  tool.settings().noise.octaves = 12;
  std::optional<int> small;
  int frames = 0;
  while (!small && frames < 20000) {
    tool.draw(kSize, 0);
    ++frames;
    if (tool.shownSide() == 32) small = frames;
    ASSERT_FALSE(tool.isSettled()) << "the small texture was left out";
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(small);
  tool.draw(kSize, 0);
  EXPECT_FALSE(tool.isSettled()) << "a frame has waited";
  tool.settings().volumeSide = VolumeSide::side64;
  tool.settings().noise.octaves = 2;
  settle(tool);
  EXPECT_EQ(tool.shownSide(), 64);
}

TEST_F(NoiseToolGLTest, picturesOfTextureAndVolumeFillTheirPlaces) {
  // Beside the panel: grey noise of many values, and clouds over sky where it is cut.
  NoiseTool tool(context(), kSize);
  const auto coloursBesidePanel = [&] {
    settle(tool);
    const core::Image picture = tool.renderer().readBack();
    std::set<std::uint32_t> colours;
    for (int y = 30; y < 330; ++y) {
      for (int x = 400; x < 600; ++x) {
        const std::uint8_t* p = picture.pixel(x, y);
        colours.insert(static_cast<std::uint32_t>(p[0] | p[1] << 8 | p[2] << 16));
      }
    }
    return colours;
  };
  const auto isGrey = [](std::uint32_t c) {
    return (c & 0xff) == (c >> 8 & 0xff) && (c & 0xff) == (c >> 16 & 0xff);
  };
  const std::set<std::uint32_t> plain = coloursBesidePanel();
  EXPECT_GT(plain.size(), 60u);
  EXPECT_GT(std::ranges::count_if(plain, isGrey), 60);
  tool.settings().cut = true;
  const std::set<std::uint32_t> clouds = coloursBesidePanel();
  EXPECT_TRUE(clouds.contains(92 | 142 << 8 | 196 << 16)) << "no clear sky";
  tool.settings().kind = NoiseKind::volume;
  EXPECT_GT(coloursBesidePanel().size(), 60u);
}

TEST_F(NoiseToolGLTest, whatIsSavedOpensAsItWas) {
  // Every format: the file is the generator's texture, and opening it sets what it was made from.
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "a.dds").string();
  const noise::NoiseSettings settings{
      .octaves = 3, .frequency = 5, .amplitude = 1, .persistence = 0.4, .seed = 12};
  for (const NoiseTexels texels : {NoiseTexels::alpha8, NoiseTexels::luminance8, NoiseTexels::luminance16,
                                   NoiseTexels::luminanceFloat}) {
    {
      NoiseTool tool(context(), kSize);
      tool.settings().noise = settings;
      tool.settings().cut = true;
      tool.settings().planeSide = PlaneSide::side128;
      tool.settings().texels = texels;
      tool.save(file);
      for (int i = 0; i < 20000 && tool.message().starts_with("Saving"); ++i) {
        tool.draw(kSize, 0);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      ASSERT_THAT(tool.message(), testing::StartsWith("Saved"));
    }
    const noise::MakeOptions options{.format = texelsOf(texels), .postProcess = noise::PostProcess()};
    EXPECT_EQ(core::readDds(file), noise::make2d(settings, 128, 128, options));
    NoiseTool other(context(), kSize);
    other.open(file);
    EXPECT_THAT(other.message(), testing::StartsWith("Opened"));
    EXPECT_EQ(other.settings().noise, settings);
    EXPECT_TRUE(other.settings().cut);
    EXPECT_EQ(other.shownSide(), 128);
  }
}

TEST_F(NoiseToolGLTest, aFileThatCannotBeOpenedOrWrittenIsOneLine) {
  const test::TemporaryFolder folder;
  NoiseTool tool(context(), kSize);
  settle(tool);
  tool.open(folder.write("broken.dds", "no DDS"));
  EXPECT_THAT(tool.message(), testing::HasSubstr("broken.dds: magic number: not a DDS file"));
  EXPECT_TRUE(tool.isSettled()) << "what was shown is gone";
  tool.save("/nonexistent/a.dds");
  for (int i = 0; i < 20000 && tool.message().starts_with("Saving"); ++i) {
    tool.draw(kSize, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_THAT(tool.message(), testing::HasSubstr("/nonexistent/a.dds: cannot write"));
}

TEST_F(NoiseToolGLTest, aFileWithoutARecipeIsShownUntilARowChanges) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "a.dds").string();
  core::writeDds(file, core::TextureData(core::TexelFormat::rgba8, 64, 32, 0), core::DdsHeader::legacy);
  NoiseTool tool(context(), kSize);
  tool.open(file);
  for (int i = 0; i < 3; ++i) tool.draw(kSize, 0);
  EXPECT_EQ(tool.shownSide(), 64);
  EXPECT_TRUE(tool.isSettled());
}

}  // namespace
}  // namespace skydrop::app
