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
    EXPECT_EQ(isSameField(changed, CloudSettings(), 0), scattering.contains(field.name)) << field.path;
  }
  EXPECT_EQ(rows, 12);
}

TEST(CloudSettings, theFadeDistanceChangesTheFieldWhereItBoundsTheWeathersPeriod) {
  CloudSettings near, far;
  near.fadeDistance = 1000;
  far.fadeDistance = 60000;
  EXPECT_FALSE(isSameField(near, far, 0));
  near.march.stepM = 99;
  EXPECT_TRUE(isSameField(near, near, 0));
}

}  // namespace
}  // namespace skydrop::clouds
