// The parameters of the clouds in a scene with weather: each acts on its low layer, over all that its slider
// covers.
#include <glm/trigonometric.hpp>
#include <string>

#include "app/settings/settings.h"
#include "skydrop/core/hash.h"
#include "support/cloud_layers.h"
#include "support/row_steps.h"
#include "support/shared_noise.h"

namespace skydrop::render {
namespace {

class LayerLookGLTest : public test::CloudLayersGLTest {
 protected:
  std::uint64_t observe() {
    core::StateHasher h;
    for (const View& view : {below(), inside(), above()}) {
      for (const glm::vec4& texel : sceneFrom(view))
        for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    }
    return h.value();
  }
};

TEST_F(LayerLookGLTest, everyTenthOfEveryParameterChangesThePictureOfAWeather) {
  app::Settings settings;
  const core::SettingsTable table(settings);
  addSky();
  addClouds(test::sharedNoise());
  snapshot_.simulatedSeconds = 100;
  setWeather({kCumulus});
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    if (!field.group.starts_with("clouds.layers.")) continue;
    ++rows;
    settings.clouds = clouds::CloudSettings();
    settings.clouds.march.lightCells = clouds::LightCells::coarse;  // quick to solve
    settings.clouds.light = clouds::CloudLight::octaves;
    settings.clouds.march.resolution = clouds::MarchResolution::full;
    const auto look = [&] {
      clouds_ = settings.clouds;
      snapshot_.weather.lowLook = game::lookOf(settings.clouds.layers[0]);
      return observe();
    };
    for (const std::string& line : test::idleSteps(field, {}, look)) ADD_FAILURE() << line;
    settings.clouds.light = clouds::CloudLight::volume;
    for (const std::string& line : test::idleSteps(field, {}, look, test::fewRowSteps(field)))
      ADD_FAILURE() << line << " (volume)";
  }
  EXPECT_EQ(rows, 12);  // the seven of the thesis, and five
}

}  // namespace
}  // namespace skydrop::render
