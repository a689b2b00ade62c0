#include "app/window/frame_pacer.h"

#include <gtest/gtest.h>

namespace skydrop::app {
namespace {

using namespace std::chrono_literals;
using Time = FrameSchedule::TimePoint;

TEST(FrameSchedule, timesLieOnOneGridHoweverLateTheWakes) {
  // 1000 frames at 60 Hz, each ended up to 3 ms after its time: no delay adds up.
  constexpr auto kPeriod = 16666667ns;
  FrameSchedule schedule;
  const Time begin = schedule.next(Time(1h), kPeriod);
  Time due = begin;
  for (int i = 1; i <= 1000; ++i) {
    due = schedule.next(due + (i * 37 % 3000) * 1us, kPeriod);
    ASSERT_EQ(due, begin + i * kPeriod) << i;
  }
}

TEST(FrameSchedule, aFrameThatMissedItsTimeIsNotFollowedByABurst) {
  // A stall of a second begins a new grid; a little delay keeps the old one.
  FrameSchedule schedule;
  const Time first = schedule.next(Time(1h), 10ms);
  EXPECT_EQ(schedule.next(first + 14ms, 10ms), first + 10ms) << "at once, on the grid";
  const Time stalled = first + 1s;
  EXPECT_EQ(schedule.next(stalled, 10ms), stalled);
  EXPECT_EQ(schedule.next(stalled + 1ms, 10ms), stalled + 10ms);
}

TEST(FrameSchedule, withoutACapTheNextFrameBeginsAtOnce) {
  FrameSchedule schedule;
  EXPECT_EQ(schedule.next(Time(5s), 0s), Time(5s));
  EXPECT_EQ(schedule.next(Time(5s) + 1ns, 0s), Time(5s) + 1ns);
  EXPECT_EQ(schedule.next(Time(6s), 10ms), Time(6s)) << "a cap that was just set begins now";
}

TEST(FramePacer, noFrameBeginsBeforeItsTime) {
  // 30 frames at 250 Hz take 29 periods at least, and none follows its forerunner by less than the sleep's
  // error.
  FramePacer pacer;
  pacer.wait(250);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 29; ++i) pacer.wait(250);
  // Begun up to a spin after the grid's first time: 50 us are far more than one clock reading.
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 29 * 4ms - 50us);
}

}  // namespace
}  // namespace skydrop::app
