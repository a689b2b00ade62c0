// From the noise tool into the sky.
#include "app/window/noise_sky.h"

#include <gtest/gtest.h>

#include "app/session/run_config.h"

namespace skydrop::app {
namespace {

noise::NoiseRecipe recipe() {
  noise::NoiseRecipe recipe;
  recipe.settings = {.octaves = 5, .frequency = 9, .amplitude = 0.8, .persistence = 0.4, .seed = 77};
  recipe.postProcess = noise::PostProcess{.cutoff = 0.44, .density = 0.93};
  return recipe;
}

TEST(NoiseSky, aTextureIsThePlaneOfItsScene) {
  // The flight that is started has the tool's noise and cut, and its window.
  CommandLine tool;
  tool.size = Size{800, 600};
  const CommandLine line = flightUnder(recipe(), false, tool);
  EXPECT_EQ(line.size->width, 800);
  const auto run = prepareRun(line);
  EXPECT_TRUE(effectsOf(*run).contains(scene::Effect::cloudPlanes));
  const auto value = [&](const char* name) {
    return run->table.at(std::string("cloudPlanes.layers.0.") + name).get();
  };
  EXPECT_EQ(value("octaves"), 5);
  EXPECT_EQ(value("frequency"), 9);
  EXPECT_EQ(value("amplitude"), 0.8);
  EXPECT_EQ(value("persistence"), 0.4);
  EXPECT_EQ(value("seed"), 77);
  EXPECT_EQ(value("cutoff"), 0.44);
  EXPECT_EQ(value("density"), 0.93);
}

TEST(NoiseSky, aVolumeIsTheDomeAndWhatItCannotTakeIsClamped) {
  noise::NoiseRecipe wild = recipe();
  wild.settings.octaves = 16;
  wild.postProcess->density = 0;
  const auto run = prepareRun(flightUnder(wild, true, {}));
  EXPECT_TRUE(effectsOf(*run).contains(scene::Effect::cloudDome));
  const core::Field& octaves = run->table.at("cloudDome.octaves");
  EXPECT_LE(octaves.get(), octaves.max);
  EXPECT_EQ(run->table.at("cloudDome.exponent").get(), run->table.at("cloudDome.exponent").min);
}

}  // namespace
}  // namespace skydrop::app
