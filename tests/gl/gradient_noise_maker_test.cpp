// The compute shader's gradient noise against the processor's.
#include "skydrop/render/noise/gradient_noise_maker.h"

#include <algorithm>
#include <cmath>

#include "support/gl_test.h"

namespace skydrop::render {
namespace {

using noise::NoiseSettings;
using noise::NoiseSize;

class GradientNoiseMakerGLTest : public test::GLTest {
 protected:
  std::vector<float> made(const NoiseSettings& settings, const NoiseSize& size, int slices) {
    GradientNoiseMaker maker(context(), settings, size);
    while (!maker.done()) maker.make(slices);
    return maker.read();
  }
};

std::vector<float> byProcessor(const NoiseSettings& settings, const NoiseSize& size) {
  const noise::NoiseGenerator generator(settings, size);
  const std::size_t layer = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  std::vector<float> values(layer * static_cast<std::size_t>(size.layers()));
  for (int z = 0; z < size.layers(); ++z)
    generator.fillRows(z, 0, std::span(values).subspan(static_cast<std::size_t>(z) * layer, layer));
  return values;
}

TEST_F(GradientNoiseMakerGLTest, valuesAreTheProcessors) {
  // A plane, a volume, more cells than texels, and the finest lattice of all. A fused multiply-add saves a
  // rounding of sums below 4: within 1e-6. A software renderer has none, and gives the same bits.
  const auto check = [&](const NoiseSettings& settings, const NoiseSize& size) {
    const std::vector<float> gpu = made(settings, size, 64), cpu = byProcessor(settings, size);
    float apart = 0;
    for (std::size_t i = 0; i < cpu.size(); ++i) apart = std::max(apart, std::abs(gpu[i] - cpu[i]));
    EXPECT_LE(apart, context().isSoftware() ? 0.0f : 1e-6f)
        << settings.octaves << " octaves, width " << size.width;
  };
  check({.seed = 3}, {128, 64, 0});
  check({.octaves = 4, .frequency = 5, .seed = 4294967295}, {32, 16, 8});
  check({.octaves = 9, .frequency = 7, .amplitude = 1, .persistence = 0.8}, {16, 16, 16});
  check({.octaves = 16, .frequency = 511, .persistence = 1}, {32, 32, 0});
}

TEST_F(GradientNoiseMakerGLTest, piecesOfAnySizeMakeTheSameTexture) {
  EXPECT_EQ(made({}, {32, 64, 0}, 5), made({}, {32, 64, 0}, 64));
  EXPECT_EQ(made({}, {16, 16, 8}, 3), made({}, {16, 16, 8}, 8));
  GradientNoiseMaker maker(context(), {}, {16, 16, 8});
  maker.make(2);
  EXPECT_FALSE(maker.done());
  EXPECT_DOUBLE_EQ(maker.progress(), 0.25);
}

}  // namespace
}  // namespace skydrop::render
