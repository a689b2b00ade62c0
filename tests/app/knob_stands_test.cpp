#include "app/window/knob_stands.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/settings/settings.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using testing::HasSubstr;

accuracy::PointResult point(const std::string& label, const std::string& set, double error, double ms) {
  accuracy::PointResult result;
  result.label = label;
  result.set = {set};
  result.errors = {error};
  result.ms = {ms};
  return result;
}

accuracy::Results tiers() {
  accuracy::CaseResult of;
  of.study = "clouds-tiers", of.name = "from below";
  of.metrics = {{"relativeRmse", "relative RMSE", "1", 0}};
  of.points = {point("low", "clouds.tier=low", 0.3, 50), point("medium", "clouds.tier=medium", -0.1, 220),
               point("slow", "clouds.tier=ultra", 0.2, 900), point("high", "clouds.tier=high", 0.05, 550)};
  accuracy::Results results;
  results.cases = {of};
  results.cases.push_back(of);
  results.cases.back().name = "far";
  return results;
}

ui::KnobStand standAt(clouds::CloudTier tier) {
  Settings settings;
  settings.clouds.tier = tier;
  const auto stands = knobStands(tiers(), core::SettingsTable(settings));
  EXPECT_EQ(stands.size(), 1u) << "one of each study";
  return stands.front();
}

TEST(KnobStands, sayWhereThePresentValueIsAndWhatTheNextBetterCosts) {
  const ui::KnobStand stand = standAt(clouds::CloudTier::medium);
  EXPECT_EQ(stand.title, "clouds.tier (from below)");
  EXPECT_EQ(stand.text, "medium: relative RMSE 0.1 for 220 ms; the next better, high, costs 2.5 times");
  ASSERT_EQ(stand.points.size(), 4u);
  EXPECT_EQ(stand.points[1].ms, 220);
  EXPECT_EQ(stand.points[1].error, 0.1);
  EXPECT_EQ(stand.present, 1);
  EXPECT_TRUE(stand.points[2].onFront);
  EXPECT_FALSE(stand.points[3].onFront) << "slow";
}

TEST(KnobStands, sayWhereNothingIsBetterAndWhereSomethingIsForLess) {
  EXPECT_THAT(standAt(clouds::CloudTier::high).text, HasSubstr("the best that was measured"));
  EXPECT_THAT(standAt(clouds::CloudTier::ultra).text, HasSubstr("medium is better and costs no more"));
  const ui::KnobStand none = standAt(clouds::CloudTier::reference);
  EXPECT_EQ(none.present, -1);
  EXPECT_THAT(none.text, HasSubstr("not among those that were measured"));
}

TEST(KnobStands, studiesThatTurnNoSettingHaveNone) {
  accuracy::Results results = tiers();
  for (accuracy::CaseResult& of : results.cases) of.points[0].set = {"method=closedForm"};
  Settings settings;
  EXPECT_TRUE(knobStands(results, core::SettingsTable(settings)).empty());
}

TEST(KnobStands, whereNothingWasMeasuredOrItCannotBeReadALineTells) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(readMeasuredFronts({}).note, HasSubstr("no cache folder"));
  EXPECT_THAT(readMeasuredFronts(folder.path()).note,
              HasSubstr("run skydrop accuracy --quick --out " + folder.path().string()));
  folder.write("results.jsonl", "no JSON\n{}\n");
  EXPECT_THAT(readMeasuredFronts(folder.path()).note, HasSubstr("results.jsonl"));
}

}  // namespace
}  // namespace skydrop::app
