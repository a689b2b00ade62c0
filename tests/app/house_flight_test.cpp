// Flights among houses: that these end them, what of that is recorded, and that pictures' settings change no
// bit.
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <optional>

#include "app/obstacle_flight.h"
#include "skydrop/terrain/noise_height_source.h"
#include "skydrop/terrain/places.h"

namespace skydrop::app {
namespace {

// Where to start: level, low and free, 60 m before a building.
struct Approach {
  glm::dvec3 place{0};
  double headingDeg = 0;
};

std::optional<Approach> approachToAHouse() {
  const auto land = terrain::makeNoiseHeightSource({}, 1);
  const terrain::Places places(land, {});
  for (const auto& village : places.around({-3000, 3000}, 4000).villages) {
    for (const terrain::HousePart& part : village->parts) {
      if (!part.standsOnLand || part.shape.wallM < 5) continue;
      for (const double side : {1.0, -1.0}) {
        const glm::dvec2 way = part.along * side, from = glm::dvec2(part.foot.x, part.foot.z) - way * 60.0;
        const double height = part.foot.y + 3.5;
        bool isFree = true;
        for (double at = 0; at < 60 - part.shape.lengthM / 2 - 8 && isFree; at += 2) {
          const glm::dvec2 xz = from + way * at;
          isFree = land->height(xz) < height - 2.5 &&
                   !places.touching(std::array{glm::dvec3(xz.x, height, xz.y)}, 6.5);
        }
        if (isFree)
          return Approach{{from.x, height - land->height(from), from.y},
                          std::fmod(std::atan2(way.x, -way.y) * 180 / std::numbers::pi + 360, 360)};
      }
    }
  }
  return {};
}

class HouseFlight : public ObstacleFlight {
 protected:
  void SetUp() override {
    const auto approach = approachToAHouse();
    ASSERT_TRUE(approach);
    std::ofstream(scene()) << R"({"schema": 1, "description": "Towards a house.", "seed": 1,
      "effects": ["sky", "terrain", "aircraft", "places"],
      "start": {"position": [)"
                           << std::setprecision(17) << approach->place.x << ", " << approach->place.y << ", "
                           << approach->place.z << R"(], "heading": )" << approach->headingDeg
                           << R"(, "speed": 60}, "settings": {}})";
  }
  std::filesystem::path scene() const { return folder_.path() / "house.json"; }
  CommandLine lineOf(const std::vector<std::string>& set) const override {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = scene().string();
    line.set = set;
    return line;
  }
  int steps() const override { return 240; }
  game::Controls controlsAt(int) const override { return {}; }
};

TEST_F(HouseFlight, housesAreInTheWayOnlyWhereTheSettingsSaySo) {
  expectInTheWayUnless("Flew into a house", "effects.places=false",
                       {"villages.obstacles=false", "villages.density=0"});
}

TEST_F(HouseFlight, whatIsDrawnOfThemDecidesNothing) {
  EXPECT_EQ(fly(lineOf({})).hash, fly(lineOf({"places.houseM=300", "places.windows=0"})).hash);
}

TEST_F(HouseFlight, replaysRepeatEveryBit) {
  expectTheSameOfItsReplay("villages.fields=0.5", "Flew into a house");
}

}  // namespace
}  // namespace skydrop::app
