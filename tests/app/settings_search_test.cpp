// What is looked for under another name is found: by the menu's search, and by what a refusal suggests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "app/settings/settings.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "ui/row_filter.h"

namespace skydrop::app {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

class SettingsSearch : public testing::Test {
 protected:
  std::vector<std::string> found(const char* words) const {
    std::vector<std::string> paths;
    const ui::RowFilter filter(words, false);
    for (const core::Field& field : table_.fields())
      if (filter.matches(field, "")) paths.push_back(field.path);
    return paths;
  }
  std::string refusal(const char* path) const {
    return test::refusalOf<core::RangeError>([&] { table_.at(path); });
  }

  Settings settings_;
  core::SettingsTable table_{settings_};
};

TEST_F(SettingsSearch, theThesisNamesOfItsFourteenParametersAreFound) {
  for (const auto& [name, path] :
       {std::pair("Roll Factor", "aircraft.rollFactor"),
        std::pair("Stabilizing Roll", "aircraft.stabilizingRoll"),
        std::pair("Pitch Speed", "aircraft.pitchSpeed"), std::pair("Yaw Speed", "aircraft.yawSpeed"),
        std::pair("Roll Speed", "aircraft.rollSpeed"), std::pair("maxThrottle", "aircraft.maxThrottle"),
        std::pair("inducedYawFactor", "aircraft.inducedYawFactor"),
        std::pair("Density Threshold", "clouds.layers.0.densityThreshold"),
        std::pair("Scale", "clouds.layers.0.scale"), std::pair("HG", "clouds.layers.0.anisotropy"),
        std::pair("SIGMA", "clouds.layers.0.extinction"),
        std::pair("Higher Scale", "clouds.layers.0.higherScale"),
        std::pair("Weather Scale", "clouds.layers.0.weatherScale"),
        std::pair("Cloud Height", "clouds.layers.0.cloudHeight")}) {
    EXPECT_THAT(found(name), Contains(path)) << name;
  }
  EXPECT_THAT(found("hg"), testing::ElementsAre("clouds.layers.0.anisotropy"));
}

TEST_F(SettingsSearch, whatOthersCallARowIsFound) {
  for (const auto& [name, path] :
       {std::pair("fov", "render.camera.fovDegrees"), std::pair("AA", "render.picture.smoothModels"),
        std::pair("antialiasing", "render.picture.smoothModels"), std::pair("LOD", "streaming.pixelError"),
        std::pair("absorption", "clouds.layers.0.extinction"),
        std::pair("brightness", "render.picture.exposureStops"), std::pair("wind", "wind.speed"),
        std::pair("windSpeed", "wind.speed"), std::pair("fog", "render.atmosphere.visibilityM"),
        std::pair("FPS", "view.frameCapHz"), std::pair("joystick", "input.gamepad.deadZone"),
        std::pair("draw distance", "streaming.farDistanceM"),
        std::pair("Henyey", "clouds.layers.0.anisotropy"),
        std::pair("time of day", "render.sun.elevationDegrees"), std::pair("thrust", "aircraft.maxThrottle"),
        std::pair("sea level", "terrain.landBias")}) {
    EXPECT_THAT(found(name), Contains(path)) << name;
  }
}

TEST_F(SettingsSearch, anUnknownPathIsAnsweredWithTheRowsThatWereMeant) {
  for (const auto& [wrong, right] :
       {std::pair("sun.elevation", "are 'render.sun.elevationDegrees'"),
        std::pair("clouds.HG", "are 'clouds.layers.0.anisotropy'"),
        std::pair("SIGMA", "are 'clouds.layers.0.extinction'"),
        std::pair("camera.fov", "are 'render.camera.fovDegrees'"),
        std::pair("FOV", "are 'render.camera.fovDegrees'"),
        std::pair("exposure", "are 'render.picture.exposureStops'"),
        std::pair("aircraft.rollspeed", "are 'aircraft.rollSpeed'"),
        std::pair("clouds.wind", "are 'wind.speed', 'wind.direction'"),
        std::pair("maxSegmentOpticalDepth", "are 'clouds.march.maxSegmentOpticalDepth'"),
        std::pair("gamepad.deadzone", "are 'input.gamepad.deadZone'")}) {
    EXPECT_THAT(refusal(wrong), HasSubstr(right));
  }
}

TEST_F(SettingsSearch, anAliasSetsNothing) {
  // They are for people who look for a row; files and flags have one name for each.
  EXPECT_EQ(table_.find("clouds.HG"), nullptr);
  EXPECT_THROW(core::setField(table_, "clouds.SIGMA=0.1"), core::RangeError);
}

}  // namespace
}  // namespace skydrop::app
