// The compute shader's noise textures against the processor's.
#include "skydrop/render/clouds/noise_maker.h"

#include "support/gl_test.h"

namespace skydrop::render {
namespace {

using clouds::NoiseTexture;

class NoiseMakerGLTest : public test::GLTest {
 protected:
  // In pieces of `slices`, as a window makes it.
  core::TextureData made(NoiseTexture texture, std::uint32_t seed, int slices) {
    NoiseMaker maker(context(), texture, seed);
    while (!maker.done()) maker.make(slices);
    return maker.read();
  }
};

TEST_F(NoiseMakerGLTest, texturesAreTheProcessorsWithinOneStep) {
  for (const NoiseTexture texture : {NoiseTexture::detail, NoiseTexture::weather}) {
    const auto difference = clouds::noiseDifference(made(texture, 5, 100), clouds::makeNoise(texture, 5));
    EXPECT_LE(difference.largest, 1) << clouds::noiseLayout(texture).name;
    EXPECT_LT(difference.mean, 0.01) << clouds::noiseLayout(texture).name;
  }
}

TEST_F(NoiseMakerGLTest, slicesOfTheShapeAreTheProcessorsWithinOneStep) {
  // Six slices: the whole takes seconds on a software renderer (`skydrop noise --check` compares all of it).
  NoiseMaker maker(context(), NoiseTexture::shape, 0);
  maker.make(2);
  maker.make(4);
  EXPECT_FALSE(maker.done());
  EXPECT_DOUBLE_EQ(maker.progress(), 6.0 / 128);
  const std::size_t bytes = 6 * clouds::noiseLayout(NoiseTexture::shape).sliceBytes();
  core::TextureData gpu(core::TexelFormat::rgba8, 128, 128, 6), cpu = gpu;
  maker.read(std::span(gpu.texels).first(bytes));
  clouds::fillNoise(NoiseTexture::shape, 0, 0, cpu.texels);
  const auto difference = clouds::noiseDifference(gpu, cpu);
  EXPECT_LE(difference.largest, 1);
  EXPECT_LT(difference.mean, 0.01);
}

TEST_F(NoiseMakerGLTest, piecesOfAnySizeMakeTheSameTexture) {
  EXPECT_EQ(made(NoiseTexture::detail, 1, 3), made(NoiseTexture::detail, 1, 32));
  EXPECT_EQ(made(NoiseTexture::weather, 1, 101), made(NoiseTexture::weather, 1, 512));
}

}  // namespace
}  // namespace skydrop::render
