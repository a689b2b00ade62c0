#include "skydrop/core/cpu_meter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace skydrop::core {
namespace {

// Keeps the calling thread's processor busy for so long, by the thread's own time.
void work(double ms) {
  const CpuClock clock;
  while (clock.ms() < ms) {
  }
}

TEST(CpuClock, countsTheWorkOfItsThreadAndOfNoOther) {
  // Work on this thread counts, waiting for another one that works does not. Tolerance: starting a thread and
  // waking up after it take well under 5 ms of processor time.
  const CpuClock clock;
  work(20);
  EXPECT_GE(clock.ms(), 20);
  const double before = clock.ms();
  std::thread([] { work(20); }).join();
  EXPECT_LT(clock.ms() - before, 5);
}

TEST(CpuMeter, measuresOnlyWhatItIsAskedFor) {
  CpuMeter meter;
  const auto round = [&] {
    meter.measure([] { work(2); });
    meter.measure([] { work(3); });
    meter.endRound();
  };
  round();
  EXPECT_EQ(meter.ms(), 0);
  EXPECT_EQ(meter.rounds(), 0u);
  EXPECT_EQ(meter.meanMs(), 0);
  meter.setMeasuring(true);
  round();
  round();
  meter.setMeasuring(false);
  round();
  EXPECT_EQ(meter.rounds(), 2u);
  EXPECT_GE(meter.meanMs(), 5);
  EXPECT_EQ(meter.ms(), 2 * meter.meanMs());
}

}  // namespace
}  // namespace skydrop::core
