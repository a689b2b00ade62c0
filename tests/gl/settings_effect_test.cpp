// Every row of the weather does something over all that its slider covers, a tenth at a time: by what a ray
// sees of the clouds, and by where there is cloud. Other rows: tests/app/settings_effect_test.cpp.
#include <algorithm>
#include <glm/trigonometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/settings.h"
#include "skydrop/core/hash.h"
#include "support/cloud_rows.h"
#include "support/row_steps.h"
#include "support/shared_noise.h"

namespace skydrop::app {
namespace {

using core::StateHasher;

class CloudRowsEffectGLTest : public test::CloudRowsGLTest {
 protected:
  std::uint64_t observe() {
    StateHasher h;
    for (const render::View& view : {below(), inside(), above()}) {
      for (const glm::vec4& texel : sceneFrom(view))
        for (int c = 0; c < 3; ++c) h.add(static_cast<double>(texel[c]));
    }
    clouds::CloudField field(noise_, clouds_);
    field.setDrift(clouds::CloudField::drift(clouds_, snapshot_.simulatedSeconds));
    core::RandomStream random{1, 0};
    for (int i = 0; i < 20000; ++i) {
      const double x = 2 * random.nextUnit() - 1, y = random.nextUnit(), z = 2 * random.nextUnit() - 1;
      h.add(field.density({x * 20000, y * 6000, z * 20000}));
    }
    return h.value();
  }

  std::shared_ptr<const clouds::FoldedNoise> noise_ = test::sharedNoise();
};

TEST_F(CloudRowsEffectGLTest, everyTenthOfEveryRowOfTheWeatherMakesADifference) {
  if (test::backendFromEnvironment() == render::gl::Backend::osmesa) return;  // draws the same bits
  Settings settings;
  const core::SettingsTable table(settings);
  addSky();
  addClouds(noise_);
  snapshot_.simulatedSeconds = 100;
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    if (field.group != "clouds" || field.name == "tier") continue;
    ++rows;
    settings.clouds = clouds::CloudSettings();
    const auto look = [&] {
      clouds_ = settings.clouds;
      return observe();
    };
    for (const std::string& line : test::idleSteps(field, {}, look)) ADD_FAILURE() << line;
  }
  EXPECT_GE(rows, 15);
}

TEST_F(CloudRowsEffectGLTest, onlyTheTierOffDrawsNoClouds) {
  // The other tiers are told apart by their rows.
  addSky();
  addClouds(noise_);
  const std::vector<glm::vec4> background = withoutClouds(below());
  for (std::size_t tier = 1; tier < clouds::kCloudTierNames.size(); ++tier) {
    clouds_.tier = static_cast<clouds::CloudTier>(tier);
    EXPECT_GT(difference(sceneFrom(below()), background), 20) << tier;
  }
}

}  // namespace
}  // namespace skydrop::app
