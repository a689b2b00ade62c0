#include "skydrop/accuracy/budget_ladder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace skydrop::accuracy {
namespace {

using testing::ElementsAre;

PointResult point(const std::string& tier, const std::string& scale, double error, double ms) {
  PointResult result;
  result.label = tier + " at " + scale;
  result.set = {"clouds.tier=" + tier, "render.picture.scale=" + scale};
  result.errors = {error};
  result.ms = {ms};
  return result;
}

Results measured() {
  CaseResult of;
  of.study = "frame-budget", of.name = "below";
  of.points = {point("low", "0.5", 0.4, 10), point("high", "0.5", 0.3, 18), point("low", "1", 0.2, 30),
               point("medium", "1", 0.1, 50), point("high", "1", 0.05, 90)};
  Results results;
  results.cases = {of};
  return results;
}

std::vector<std::string> labels(const std::vector<BudgetRung>& ladder) {
  std::vector<std::string> all;
  for (const BudgetRung& rung : ladder) all.push_back(rung.label);
  return all;
}

TEST(BudgetLadder, isTheFrontByGrowingTimeAndFallingError) {
  Results results = measured();
  results.cases[0].points.push_back(point("medium", "0.5", 0.35, 60));  // dominated
  results.cases[0].points.push_back(point("low", "0.75", -0.2, 30));    // an error has a sign; the same again
  EXPECT_THAT(labels(budgetLadder(results)),
              ElementsAre("low at 0.5", "high at 0.5", "low at 1", "medium at 1", "high at 1"));
}

TEST(BudgetLadder, casesAreAveragedAndWhatOneLacksIsLeftOut) {
  Results results = measured();
  results.cases.push_back(results.cases[0]);
  results.cases[1].points[0].ms = {30};
  results.cases[1].points[0].errors = {0.3};
  results.cases[1].points[3].ms.clear();
  const auto ladder = budgetLadder(results);
  EXPECT_THAT(labels(ladder), ElementsAre("high at 0.5", "low at 1", "high at 1"));
  EXPECT_EQ(ladder[0].ms, 18);
  EXPECT_DOUBLE_EQ(ladder[0].error, 0.3);
}

TEST(BudgetLadder, stepsThatAreNotWorthAChangeAreOne) {
  Results results = measured();
  results.cases[0].points[1].ms = {10.5};
  EXPECT_EQ(budgetLadder(results).front().label, "high at 0.5") << "more exact in the same time";
}

TEST(BudgetLadder, aKnobThatOthersHoldIsTakenOut) {
  const auto scaled = budgetLadder(measured(), {"clouds.tier=low"});
  EXPECT_THAT(labels(scaled), ElementsAre("scale 0.5", "scale 1"));
  EXPECT_THAT(scaled[0].set, ElementsAre("render.picture.scale=0.5"));
  // A value that was not measured: those of the most exact point, whose times are the closest guess.
  EXPECT_THAT(labels(budgetLadder(measured(), {"clouds.tier=ultra"})), ElementsAre("scale 0.5", "scale 1"));
  const auto none = budgetLadder(measured(), {"clouds.tier=low", "render.picture.scale=1"});
  ASSERT_EQ(none.size(), 1u);
  EXPECT_TRUE(none[0].set.empty());
}

TEST(BudgetLadder, nothingThatWasMeasuredMakesNone) {
  EXPECT_TRUE(budgetLadder({}).empty());
  Results results = measured();
  for (PointResult& of : results.cases[0].points) of.ms = {0};
  EXPECT_TRUE(budgetLadder(results).empty());
}

}  // namespace
}  // namespace skydrop::accuracy
