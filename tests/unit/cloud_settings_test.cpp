#include "skydrop/clouds/cloud_settings.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "skydrop/core/settings_table.h"

namespace skydrop::clouds {
namespace {

TEST(CloudSettings, onlyHowLightScattersLeavesTheFieldOfALayer) {
  // Every row of the layer, turned to one end of its range: all others make another field, which is then made
  // again; these two must not, or a drag of their sliders would rebuild the occupancy at each frame.
  const std::set<std::string> scattering = {"anisotropy", "forwardShare"};
  CloudSettings changed;
  const core::SettingsTable table(changed);
  int rows = 0;
  for (const core::Field& field : table.fields()) {
    if (field.group != "layers.0") continue;
    ++rows;
    changed = CloudSettings();
    field.set(field.isDefault() && field.get() == field.max ? field.min : field.max);
    const bool same = isSameField(changed, CloudSettings(), 0);
    EXPECT_EQ(same, scattering.contains(field.name)) << field.path;
    EXPECT_EQ(field.takesEffect, same ? core::TakesEffect::live : core::TakesEffect::liveRebuild)
        << field.path << ": the tooltip says what a drag costs";
  }
  EXPECT_EQ(rows, 12);
}

TEST(CloudSettings, theFadeDistanceChangesTheFieldWhereItBoundsTheWeathersPeriod) {
  CloudSettings near, far;
  near.fadeDistance = 1000;
  far.fadeDistance = 60000;
  EXPECT_TRUE(isSameField(near, far, 0));  // 50 km is asked for
  near.layers[0].weatherScale = far.layers[0].weatherScale = 0.1;
  EXPECT_FALSE(isSameField(near, far, 0));
  // Beyond 24 km it does not bound it any more: what is nearer stays as it is.
  near.fadeDistance = 24000;
  EXPECT_TRUE(isSameField(near, far, 0));
  EXPECT_GE(weatherPeriod(far.layers[0], far.fadeDistance), 48000);
  EXPECT_EQ(core::SettingsTable(near).at("fadeDistance").takesEffect, core::TakesEffect::liveRebuild);
  near.march.stepM = 99;
  EXPECT_TRUE(isSameField(near, near, 0));
}

}  // namespace
}  // namespace skydrop::clouds
