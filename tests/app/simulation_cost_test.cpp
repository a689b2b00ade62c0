// What the simulation says it costs.
#include <gtest/gtest.h>

#include <memory>

#include "app/measure/bill.h"
#include "app/session/run_config.h"

namespace skydrop::app {
namespace {

// The autopilot over the land of the scene `terrain`.
struct Flight {
  explicit Flight(std::vector<std::string> set = {}) : run(runOf(std::move(set))) {
    simulation = std::make_unique<Simulation>(run->setup, run->settings, run->table);
  }
  static std::unique_ptr<RunConfig> runOf(std::vector<std::string> set) {
    CommandLine line;
    line.verb = Verb::simulate;
    line.scene.emplace("terrain");
    line.set = std::move(set);
    line.autopilot = true;
    return prepareRun(line);
  }
  core::FrameStatistics statistics() const {
    core::FrameStatistics statistics;
    simulation->writeTo(statistics);
    return statistics;
  }

  std::unique_ptr<RunConfig> run;
  std::unique_ptr<Simulation> simulation;
};

TEST(SimulationCost, measuringChangesNoState) {
  // A flight that is measured now and then has the state of one that never is, after every step.
  Flight plain, measured;
  for (int step = 0; step < 600; ++step) {
    measured.simulation->setMeasuring(step % 100 < 50);
    const game::Controls controls{.drop = step % 240 == 0};
    plain.simulation->step(controls);
    measured.simulation->step(controls);
    ASSERT_EQ(measured.simulation->world().stateHash(), plain.simulation->world().stateHash()) << step;
  }
  core::FrameStatistics statistics = measured.statistics();
  EXPECT_GT(billRow(statistics, "aircraft").simulationMs, 0);
}

TEST(SimulationCost, effectsPayForTheirPartOfASecondAndTheFrameForTheRest) {
  Flight flight;
  EXPECT_TRUE(flight.statistics().bill.empty()) << "nobody has asked";
  flight.simulation->setMeasuring(true);
  for (int step = 0; step < 240; ++step) flight.simulation->step({});
  core::FrameStatistics statistics = flight.statistics();
  for (const char* part : {"aircraft", "targets", "frame"}) {
    EXPECT_GT(billRow(statistics, part).simulationMs, 0) << part;
    EXPECT_LT(billRow(statistics, part).simulationMs, 1000) << part << ": slower than it flies";
  }
  EXPECT_EQ(statistics.bill.size(), 3u);
}

TEST(SimulationCost, whatIsOffPaysNothing) {
  Flight flight({"effects.targets=false"});
  flight.simulation->setMeasuring(true);
  for (int step = 0; step < 120; ++step) flight.simulation->step({});
  core::FrameStatistics statistics = flight.statistics();
  EXPECT_EQ(billRow(statistics, "targets").simulationMs, 0);
  EXPECT_GT(billRow(statistics, "aircraft").simulationMs, 0);
}

TEST(Bill, aFrameIsPaidByPassesUpdatesAndTwoSteps) {
  core::FrameStatistics statistics;
  billRow(statistics, "sky").ms = 3;
  billRow(statistics, "hud").updateMs = 0.5;
  billRow(statistics, "aircraft").simulationMs = 6;
  billRow(statistics, "sky").ms += 1;
  EXPECT_EQ(statistics.bill.size(), 3u);
  EXPECT_DOUBLE_EQ(paidMs(statistics), 4 + 0.5 + 0.1);
}

}  // namespace
}  // namespace skydrop::app
