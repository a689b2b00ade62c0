// Flights among trees: what of them is recorded, and that pictures' settings change no bit of a flight.
#include "app/obstacle_flight.h"

namespace skydrop::app {
namespace {

class TreeFlight : public ObstacleFlight {
 protected:
  CommandLine lineOf(const std::vector<std::string>& set) const override {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = "woodland";
    line.set = {"effects.clouds=false"};
    line.set.insert(line.set.end(), set.begin(), set.end());
    return line;
  }
  int steps() const override { return 900; }
  // Nose down from the start: into whatever is below.
  game::Controls controlsAt(int step) const override {
    game::Controls controls;
    controls.pitch = step < 240 ? -0.5 : 0;
    return controls;
  }
};

TEST_F(TreeFlight, treesAreInTheWayOnlyWhereTheSettingsSaySo) {
  expectInTheWayUnless("Flew into a tree", "effects.vegetation=false",
                       {"woods.obstacles=false", "woods.density=0"});
}

TEST_F(TreeFlight, whatIsDrawnOfThemDecidesNothing) {
  EXPECT_EQ(fly(lineOf({})).hash, fly(lineOf({"vegetation.meshM=20", "vegetation.farM=100"})).hash);
}

TEST_F(TreeFlight, replaysRepeatEveryBit) {
  const std::string setting = "woods.density=0.7";
  expectTheSameOfItsReplay(setting, fly(lineOf({setting})).reason);
}

}  // namespace
}  // namespace skydrop::app
