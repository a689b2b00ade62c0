#include "app/measure/cost_history.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace skydrop::app {
namespace {

using Kind = ui::CostKind;

const ui::CostRow& row(const CostHistory& history, std::string_view name) {
  return *std::ranges::find(history.rows(), name, &ui::CostRow::name);
}

TEST(CostHistory, aRowHasMedianQuantileAndShareOfTheNewestFrames) {
  // Of 1, 2 ... 480 ms the newest 240: 241 to 480, of which half do not exceed 360 and 99 of a hundred 478.
  CostHistory history;
  for (int frame = 1; frame <= 480; ++frame) {
    history.add(Kind::pass, "clouds", frame);
    history.add(Kind::pass, "sky", 3.0 * frame);
    history.endFrame();
  }
  ASSERT_EQ(history.rows().size(), 2u);
  const ui::CostRow& clouds = row(history, "clouds");
  EXPECT_EQ(clouds.medianMs, 360);
  EXPECT_EQ(clouds.p99Ms, 478);
  EXPECT_DOUBLE_EQ(clouds.share, 0.25);
  ASSERT_EQ(clouds.ms.size(), CostHistory::kKept);
  EXPECT_EQ(clouds.ms.front(), 241);
  EXPECT_EQ(clouds.ms.back(), 480);
  EXPECT_TRUE(std::ranges::is_sorted(clouds.ms));
}

TEST(CostHistory, aMeterThatCountsUpGivesWhatItGainedInEachFrame) {
  // The first reading says nothing of a frame; neither does one that went back.
  CostHistory history;
  double total = 100;
  for (int frame = 0; frame < 60; ++frame) {
    history.addTotal(Kind::simulation, "aircraft", total);
    history.addTotal(Kind::simulation, "still", 7);
    history.endFrame();
    total += 0.5;
  }
  ASSERT_EQ(history.rows().size(), 1u) << "what took nothing has no row";
  const ui::CostRow& aircraft = row(history, "aircraft");
  EXPECT_EQ(aircraft.ms.front(), 0);
  EXPECT_EQ(aircraft.ms.back(), 0.5f);
  EXPECT_EQ(aircraft.medianMs, 0.5);
}

TEST(CostHistory, aPartThatIsNotNamedTookNothing) {
  CostHistory history;
  for (int frame = 0; frame < 30; ++frame) {
    if (frame < 10) history.add(Kind::pass, "clouds", 9);
    history.add(Kind::update, "clouds", 1);  // another part of the same name
    history.endFrame();
  }
  ASSERT_EQ(history.rows().size(), 2u);
  EXPECT_EQ(history.rows()[0].medianMs, 0);
  EXPECT_EQ(history.rows()[0].p99Ms, 9);
  EXPECT_EQ(history.rows()[1].medianMs, 1);
}

}  // namespace
}  // namespace skydrop::app
