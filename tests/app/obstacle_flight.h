// Short flights into what stands on the land: what ends them, and what of that is recorded.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "app/session/run_config.h"
#include "app/session/simulation.h"
#include "support/temporary_folder.h"

namespace skydrop::app {

class ObstacleFlight : public ::testing::Test {
 protected:
  struct Flown {
    std::uint64_t hash = 0;
    std::string reason;  // of the first crash
  };

  // `set` on top of what the flights have in common.
  virtual CommandLine lineOf(const std::vector<std::string>& set) const = 0;
  virtual int steps() const = 0;
  virtual game::Controls controlsAt(int step) const = 0;

  Flown fly(const CommandLine& line) const {
    const auto run = prepareRun(line);
    Simulation simulation(run->setup, run->settings, run->table);
    Flown flown;
    for (int i = 0; i < steps() && !simulation.finished(); ++i) {
      simulation.step(controlsAt(i));
      if (flown.reason.empty()) flown.reason = simulation.world().now().aircraft.gear.endReason;
    }
    simulation.endRecording();
    EXPECT_FALSE(simulation.hasDiverged());
    flown.hash = simulation.world().stateHash();
    return flown;
  }

  // The same flight ends with the reason, or otherwise without the effect; and with each of the settings in
  // every bit as without it.
  void expectInTheWayUnless(const std::string& reason, const std::string& withoutEffect,
                            std::initializer_list<const char*> settings) const {
    EXPECT_EQ(fly(lineOf({})).reason, reason);
    const Flown none = fly(lineOf({withoutEffect}));
    EXPECT_NE(none.reason, reason);
    for (const char* set : settings) {
      const Flown flown = fly(lineOf({set}));
      EXPECT_EQ(flown.reason, none.reason) << set;
      EXPECT_EQ(flown.hash, none.hash) << set;
    }
  }

  // A log keeps the effect and its settings, which the scene may not have any more.
  void expectTheSameOfItsReplay(const std::string& setting, const std::string& reason) const {
    CommandLine line = lineOf({setting});
    line.record = folder_.path() / "flight.log";
    const Flown flown = fly(line);
    CommandLine replay;
    replay.verb = Verb::simulate;
    replay.replay = line.record;
    const Flown repeated = fly(replay);
    EXPECT_EQ(repeated.hash, flown.hash);
    EXPECT_EQ(repeated.reason, flown.reason);
    EXPECT_EQ(repeated.reason, reason);
  }

  test::TemporaryFolder folder_;
};

}  // namespace skydrop::app
