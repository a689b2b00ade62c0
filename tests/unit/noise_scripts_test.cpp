// noise_scripts/ against the processor's noise: the same bytes.
#include <gtest/gtest.h>

#include "skydrop/clouds/noise_textures.h"
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

}  // namespace
}  // namespace skydrop::clouds
