// noise_scripts/ against the processor's noise: the same bytes.
#include <gtest/gtest.h>

#include <cstring>

#include "skydrop/clouds/noise_textures.h"
#include "skydrop/noise/noise_generator.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/python.h"
#include "support/temporary_folder.h"

namespace skydrop::clouds {
namespace {

TEST(NoiseScripts, makeTheTexturesOfTheProgram) {
  // Eight slices of the shape, and the other two whole, byte for byte: the arithmetic is IEEE's on both
  // sides.
  const std::string python = test::pythonWithNumpy();
  if (python.empty()) GTEST_SKIP() << "no python3 with numpy";
  const test::TemporaryFolder folder;
  const test::ProcessResult result =
      test::runProcess({python, test::sourceDir() + "/noise_scripts/make_noise.py", folder.path().string(),
                        "--seed", "9", "--slices", "60", "67"},
                       {"PYTHONDONTWRITEBYTECODE=1"}, 100);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  core::TextureData slices(core::TexelFormat::rgba8, 128, 128, 8);
  fillNoise(NoiseTexture::shape, 9, 60, slices.texels);
  EXPECT_EQ(core::readDds(folder.path() / "shape.dds"), slices);
  EXPECT_EQ(core::readDds(folder.path() / "detail.dds"), makeNoise(NoiseTexture::detail, 9));
  EXPECT_EQ(core::readDds(folder.path() / "weather.dds"), makeNoise(NoiseTexture::weather, 9));
}

// What make_gradient_noise.py writes to a file, with these words.
core::TextureData madeByScript(const std::vector<std::string>& words) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "noise.dds").string();
  std::vector<std::string> command = {test::pythonWithNumpy(),
                                      test::sourceDir() + "/noise_scripts/make_gradient_noise.py", file};
  command.insert(command.end(), words.begin(), words.end());
  const test::ProcessResult result = test::runProcess(command, {"PYTHONDONTWRITEBYTECODE=1"}, 100);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return result.exitCode == 0 ? core::readDds(file) : core::TextureData();
}

TEST(NoiseScripts, makeTheGradientNoiseOfTheProgram) {
  // A plane and a volume bit for bit, with lattices coarser and finer than the texels; cut to clouds within
  // the last bit, since the script raises to powers by numpy.
  if (test::pythonWithNumpy().empty()) GTEST_SKIP() << "no python3 with numpy";
  constexpr core::TexelFormat kFloats = core::TexelFormat::r32f;
  EXPECT_EQ(
      madeByScript({"--width", "128", "--height", "64", "--octaves", "9", "--frequency", "7", "--seed", "9"}),
      noise::make2d({.octaves = 9, .frequency = 7, .seed = 9}, 128, 64, {.format = kFloats}));
  EXPECT_EQ(
      madeByScript({"--width", "32", "--height", "16", "--slices", "8", "--octaves", "5", "--frequency", "3",
                    "--amplitude", "1", "--persistence", "0.8", "--seed", "4294967295"}),
      noise::make3d({.octaves = 5, .frequency = 3, .amplitude = 1, .persistence = 0.8, .seed = 4294967295},
                    32, 16, 8, {.format = kFloats}));
  const core::TextureData cut =
      madeByScript({"--width", "64", "--height", "64", "--cutoff", "0.45", "--density", "0.9"});
  const core::TextureData expected =
      noise::make2d({}, 64, 64, {.format = kFloats, .postProcess = noise::PostProcess{0.45, 0.9}});
  ASSERT_EQ(cut.texels.size(), expected.texels.size());
  for (std::size_t i = 0; i < cut.texels.size(); i += sizeof(float)) {
    float a = 0, b = 0;
    std::memcpy(&a, cut.texels.data() + i, sizeof a);
    std::memcpy(&b, expected.texels.data() + i, sizeof b);
    ASSERT_NEAR(a, b, 6e-8);
  }
}

}  // namespace
}  // namespace skydrop::clouds
