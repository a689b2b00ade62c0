// The guards' counters in the statistics of a flight.
#include <gtest/gtest.h>

#include <cmath>

#include "app/session/run_config.h"
#include "skydrop/core/guards.h"

namespace skydrop::app {
namespace {

TEST(GuardStatistics, everyGuardIsThereAndOneThatFiresIsCounted) {
  // A stick that sends no number for ten steps; the others stand there with none.
  core::resetGuardCounts();
  CommandLine line;
  line.verb = Verb::simulate;
  line.scene.emplace("terrain");
  const auto run = prepareRun(line);
  Simulation simulation(run->setup, run->settings, run->table);
  core::FrameStatistics before, after;
  simulation.writeTo(before);
  EXPECT_EQ(before.guards.size(), static_cast<std::size_t>(core::Guard::count_));
  EXPECT_EQ(before.guards.at("notFiniteControl"), 0);
  for (int step = 0; step < 10; ++step) simulation.step({.pitch = std::nan("")});
  simulation.writeTo(after);
  EXPECT_EQ(after.guards.at("notFiniteControl"), 10);
  EXPECT_EQ(after.guards.at("stiffStep"), 0);
}

}  // namespace
}  // namespace skydrop::app
