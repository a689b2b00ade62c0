// Flights among trees: what of them is recorded, and that pictures' settings change no bit of a flight.
#include <gtest/gtest.h>

#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

class TreeFlight : public ::testing::Test {
 protected:
  static CommandLine lineOf(const std::vector<std::string>& set) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene = "woodland";
    line.set = {"effects.clouds=false"};
    line.set.insert(line.set.end(), set.begin(), set.end());
    return line;
  }
  struct Flown {
    std::uint64_t hash = 0;
    std::string reason;  // of the first crash
  };
  // Nose down from the start: into whatever is below.
  static Flown fly(const CommandLine& line) {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    Flown flown;
    for (int i = 0; i < 900 && !simulation.finished(); ++i) {
      game::Controls controls;
      controls.pitch = i < 240 ? -0.5 : 0;
      simulation.step(controls);
      if (flown.reason.empty()) flown.reason = simulation.world().now().aircraft.gear.endReason;
    }
    simulation.endRecording();
    EXPECT_FALSE(simulation.hasDiverged());
    flown.hash = simulation.world().stateHash();
    return flown;
  }

  test::TemporaryFolder folder_;
};

TEST_F(TreeFlight, treesAreInTheWayOnlyWhereTheSettingsSaySo) {
  // The same dive ends in a tree, or on the ground where trees are no obstacles, there are none, or the
  // effect is off.
  EXPECT_EQ(fly(lineOf({})).reason, "Flew into a tree");
  const Flown none = fly(lineOf({"effects.vegetation=false"}));
  EXPECT_NE(none.reason, "Flew into a tree");
  for (const char* set : {"woods.obstacles=false", "woods.density=0"}) {
    const Flown flown = fly(lineOf({set}));
    EXPECT_EQ(flown.reason, none.reason) << set;
    EXPECT_EQ(flown.hash, none.hash) << set;
  }
}

TEST_F(TreeFlight, whatIsDrawnOfThemDecidesNothing) {
  EXPECT_EQ(fly(lineOf({})).hash, fly(lineOf({"vegetation.meshM=20", "vegetation.farM=100"})).hash);
}

TEST_F(TreeFlight, replaysRepeatEveryBit) {
  // A log keeps the effect and the density, which the scene may not have any more.
  CommandLine line = lineOf({"woods.density=0.7"});
  line.record = folder_.path() / "flight.log";
  const Flown flown = fly(line);
  CommandLine replay;
  replay.verb = Verb::simulate;
  replay.replay = line.record;
  const Flown repeated = fly(replay);
  EXPECT_EQ(repeated.hash, flown.hash);
  EXPECT_EQ(repeated.reason, flown.reason);
}

}  // namespace
}  // namespace skydrop::app
