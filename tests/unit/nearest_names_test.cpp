#include "skydrop/core/nearest_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace skydrop::core {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr KnownName kKnown[] = {
    {"aircraft.rollSpeed"},
    {"aircraft.mass", "weight"},
    {"package.mass", "weight"},
    {"package.freeFallSpeed"},
    {"clouds.scale"},
    {"clouds.anisotropy", "HG, g"},
    {"clouds.extinction", "SIGMA"},
    {"clouds.windSpeed"},
    {"clouds.windDirection"},
    {"clouds.march.sunSamples"},
    {"render.sun.elevationDegrees", "sun height"},
    {"render.sun.azimuthDegrees"},
    {"render.camera.fovDegrees", "field of view"},
    {"terrain.mountainHeight"},
    {"terrain.mountainWavelength"},
};

std::string first(std::string_view wanted) { return nearestNames(wanted, kKnown, 1).at(0); }

TEST(NearestNames, partsOfThePathDecideBeforeLetters) {
  // "sun.elevation" has fewer letters to change on its way to "clouds.extinction" than to the row it means.
  EXPECT_THAT(nearestNames("sun.elevation", kKnown, 2),
              ElementsAre("render.sun.elevationDegrees", "render.sun.azimuthDegrees"));
  EXPECT_EQ(first("elevation"), "render.sun.elevationDegrees") << "the beginning of a part";
  EXPECT_EQ(first("camera.fov"), "render.camera.fovDegrees");
  EXPECT_EQ(first("package.mas"), "package.mass") << "the group tells two equal names apart";
  EXPECT_EQ(first("aircraft.mas"), "aircraft.mass");
  EXPECT_EQ(first("Clouds.WINDSPEED"), "clouds.windSpeed") << "capitals do not count";
  EXPECT_THAT(nearestNames("clouds.wind", kKnown, 2),
              ElementsAre("clouds.windSpeed", "clouds.windDirection"));
  EXPECT_EQ(first("samples"), "clouds.march.sunSamples") << "a word within a part";
  EXPECT_THAT(nearestNames("terrain.mountains", kKnown, 2),
              ElementsAre("terrain.mountainHeight", "terrain.mountainWavelength"))
      << "a word within a part, misspelt";
  EXPECT_EQ(first("speed.roll"), "aircraft.rollSpeed");
}

TEST(NearestNames, aFewWrongLettersAreForgiven) {
  for (const auto& [wrong, right] :
       {std::pair("aircraft.rolSpeed", "aircraft.rollSpeed"),
        std::pair("clouds.extnction", "clouds.extinction"), std::pair("cluods.scale", "clouds.scale"),
        std::pair("render.sun.azimutDegrees", "render.sun.azimuthDegrees")}) {
    EXPECT_EQ(first(wrong), right) << wrong;
  }
}

TEST(NearestNames, otherNamesOfTheLastPartCount) {
  EXPECT_EQ(first("HG"), "clouds.anisotropy");
  EXPECT_EQ(first("clouds.sigma"), "clouds.extinction");
  EXPECT_EQ(first("package.weight"), "package.mass");
  EXPECT_EQ(first("fieldOfView"), "render.camera.fovDegrees") << "an alias of several words";
}

TEST(NearestNames, threeAreNamedAndNoMoreThanThereAre) {
  EXPECT_EQ(nearestText("clouds.wnd", kKnown),
            "; the nearest are 'clouds.windSpeed', 'clouds.windDirection' and 'clouds.scale'");
  EXPECT_EQ(nearestText("b", std::array{KnownName{"a"}, KnownName{"b"}}), "; the nearest are 'b' and 'a'");
  EXPECT_EQ(nearestText("b", std::array{KnownName{"a"}}), "; the nearest is 'a'");
  EXPECT_EQ(nearestText("b", std::span<const KnownName>()), "");
  EXPECT_THAT(nearestNames("a", {}), IsEmpty());
}

TEST(NearestNames, anyTextIsAnswered) {
  // Nothing, dots alone, and a text of a megabyte: without waiting for the product of the lengths.
  for (const std::string& text :
       {std::string(), std::string("..."), std::string(1 << 20, 'x'), std::string(300, '.')})
    EXPECT_EQ(nearestNames(text, kKnown).size(), 3u);
}

}  // namespace
}  // namespace skydrop::core
