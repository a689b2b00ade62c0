// A frame budget in a run: what it may turn, how it goes over the player's settings and back, and which
// fronts it goes by.
#include "app/session/frame_budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/settings/cloud_tier.h"
#include "app/types/version.h"
#include "skydrop/accuracy/result_file.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/mutants.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

accuracy::PointResult point(const std::string& tier, const std::string& scale, double error, double ms) {
  accuracy::PointResult result;
  result.label = "scale " + scale + ", clouds " + tier;
  result.set = {"render.picture.scale=" + scale, "clouds.tier=" + tier};
  result.errors = {error};
  result.ms = {ms};
  return result;
}

BudgetFrontKey key() { return {"fair", "{}", "a renderer", {640, 360}}; }

accuracy::Results measured() {
  accuracy::CaseResult of;
  of.study = "frame-budget", of.name = "below";
  of.title = "A budget", of.method = "Measured.", of.timed = "frame", of.timeUnit = "ms a frame";
  of.clock = "a clock", of.machine = key().machine();
  of.metrics = {{"relativeRmse", "relative RMSE", "1", 0}};
  of.references = {{"reference", {}, ""}};
  of.points = {point("low", "0.5", 0.4, 10), point("high", "0.5", 0.3, 20), point("low", "1", 0.2, 30),
               point("medium", "1", 0.1, 50), point("high", "1", 0.05, 90)};
  accuracy::Results results;
  results.program = programName();
  results.digest = "0";
  results.allCases = 1;
  results.cases = {of};
  return results;
}

BudgetFronts fronts() {
  BudgetFronts fronts;
  fronts.results = measured();
  fronts.file = "fronts.jsonl";
  fronts.source = "as measured on this machine";
  fronts.measured = true;
  return fronts;
}

std::unique_ptr<RunConfig> flight(std::vector<std::string> set = {}, const std::string& scene = "fair") {
  CommandLine line;
  line.verb = Verb::render;  // reads nothing of the player's
  line.scene = scene;
  line.set = std::move(set);
  return prepareRun(line);
}

std::unique_ptr<RunConfig> flightWithin(const std::string& ms, std::vector<std::string> set = {},
                                        const std::string& scene = "fair") {
  set.push_back("view.frameBudgetMs=" + ms);
  return flight(std::move(set), scene);
}

core::BudgetStatistics statisticsOf(const FrameBudget& budget) {
  core::BudgetStatistics statistics;
  budget.writeTo(statistics);
  return statistics;
}

std::vector<double> valuesOf(const RunConfig& run) {
  std::vector<double> values;
  for (const core::Field& field : run.table.fields()) values.push_back(field.get());
  return values;
}

double valueOf(const GovernedRows& rows, const std::string& path) {
  const auto row = std::ranges::find(rows, path, [](const auto& each) { return each.first; });
  return row == rows.end() ? -1 : row->second;
}

TEST(GovernedRows, aTierBringsItsRowsAndOthersGoOverThemWhateverTheOrder) {
  const GovernedRows rows = governedRows({"clouds.march.coarseTolerance=10", "clouds.tier=low"}, "f");
  EXPECT_EQ(valueOf(rows, "clouds.tier"), static_cast<double>(clouds::CloudTier::low));
  EXPECT_EQ(valueOf(rows, "clouds.march.coarseTolerance"), 10);
  EXPECT_EQ(valueOf(rows, "clouds.march.stepM"), 24) << "of assets/clouds/low.json";
  EXPECT_EQ(valueOf(rows, "render.picture.scale"), -1);
}

TEST(GovernedRows, onlyRowsOfThePictureMayBeTurned) {
  // A file of the cache may say anything: it reaches neither the simulation nor what is made anew for a
  // change.
  int allowed = 0;
  Settings settings;
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) {
    if (!mayGovern(field)) continue;
    ++allowed;
    EXPECT_FALSE(decidesSimulation(field.path)) << field.path;
    EXPECT_NE(field.takesEffect, core::TakesEffect::restart) << field.path;
    EXPECT_NE(field.takesEffect, core::TakesEffect::rebuild) << field.path;
    EXPECT_TRUE(field.path.starts_with("clouds.") || field.path.starts_with("render.")) << field.path;
  }
  EXPECT_GT(allowed, 10);
  const auto refusal = [](const std::string& one) {
    return test::refusalOf<core::DataError>([&] { governedRows({one}, "fronts.jsonl"); });
  };
  for (const char* one : {"wind.speed=3", "aircraft.mass=1", "effects.clouds=false", "clouds.tier=off",
                          "clouds.layers.0.coverage=0", "view.frameBudgetMs=5", "render.picture.scale=7",
                          "clouds.march.stepM=nan", "no.such=1", "", "clouds.tier"}) {
    EXPECT_TRUE(test::isOneLineAbout(refusal(one), "fronts.jsonl")) << one << ": " << refusal(one);
  }
}

TEST(Govern, rowsGoOverAllOthersAndBackToWhatTheyWere) {
  const auto run = flight({"clouds.tier=medium"});
  const std::vector<double> before = valuesOf(*run);
  EXPECT_FALSE(govern(*run, governedRows({"clouds.tier=low", "render.picture.scale=0.5"}, "f")).empty());
  EXPECT_EQ(run->settings.clouds.tier, clouds::CloudTier::low);
  EXPECT_EQ(run->settings.clouds.march.stepM, 24);
  EXPECT_EQ(run->settings.render.scale, 0.5);
  Settings own = ungoverned(*run);
  EXPECT_EQ(own.clouds.tier, clouds::CloudTier::medium);
  EXPECT_EQ(own.clouds.march.stepM, 20);
  const SettingsChange fewer = govern(*run, governedRows({"render.picture.scale=0.7"}, "f"));
  EXPECT_TRUE(fewer.touches("clouds.march")) << "given up, so they go back";
  EXPECT_EQ(run->settings.clouds.march.stepM, 20);
  govern(*run, {});
  EXPECT_EQ(valuesOf(*run), before);
}

TEST(Govern, theyAreNobodysChoice) {
  // The player's layer and file have nothing of them, a quality that is picked leaves them in force, and what
  // is beneath them follows the pick.
  const test::TemporaryFolder folder;
  CommandLine line;
  line.verb = Verb::render;
  line.userDir = folder.path();
  const auto run = prepareRun(line);
  govern(*run, governedRows({"clouds.tier=ultra", "render.picture.scale=0.5"}, "f"));
  EXPECT_EQ(run->player.render.scale, 1);
  run->table.at("quality").set(static_cast<double>(Quality::low));
  takeMenuChanges(*run, {"quality"});
  EXPECT_EQ(run->settings.clouds.tier, clouds::CloudTier::ultra);
  EXPECT_EQ(run->settings.render.scale, 0.5);
  run->userSettings.save(run->playerTable, run->bindings);
  const std::string kept = core::readTextFile(folder.path() / "settings.json");
  EXPECT_THAT(kept, HasSubstr("quality"));
  EXPECT_THAT(kept, Not(HasSubstr("scale")));
  EXPECT_THAT(kept, Not(HasSubstr("tier")));
  govern(*run, {});
  EXPECT_EQ(run->settings.clouds.tier, clouds::CloudTier::low);
  EXPECT_EQ(run->settings.render.scale, 1);
}

TEST(FrameBudget, aTightOneTakesTheCheapestAndAWideOneTheBest) {
  const auto tight = flightWithin("1"), wide = flightWithin("1000"), middle = flightWithin("33");
  EXPECT_EQ(statisticsOf(FrameBudget(fronts(), *tight)).choice, "scale 0.5, clouds low");
  EXPECT_EQ(statisticsOf(FrameBudget(fronts(), *wide)).choice, "scale 1, clouds high");
  EXPECT_EQ(statisticsOf(FrameBudget(fronts(), *middle)).choice, "scale 1, clouds low");
}

TEST(FrameBudget, followsTheFramesAndSaysWhatAndWhy) {
  const auto run = flightWithin("33");
  FrameBudget budget(fronts(), *run);
  govern(*run, budget.rows());
  EXPECT_EQ(run->settings.clouds.tier, clouds::CloudTier::low);
  int frames = 0;
  while (!budget.note({60, 60}) && frames < 100) ++frames;
  EXPECT_LT(frames, 20);
  const SettingsChange change = govern(*run, budget.rows());
  EXPECT_EQ(run->settings.render.scale, 0.5);
  EXPECT_TRUE(change.touches("render.picture.scale"));
  EXPECT_FALSE(
      std::ranges::any_of(change.paths(), [](const std::string& path) { return decidesSimulation(path); }));
  for (int i = 0; i < 40; ++i) budget.note({20, 20});
  EXPECT_EQ(
      budget.text(),
      "Frame budget: 20.0 of 33 ms: scale 0.5, clouds low; the next better, scale 0.5, clouds high, would "
      "need 40 ms (as measured on this machine)");
  EXPECT_EQ(statisticsOf(budget).changes, 1);
}

TEST(FrameBudget, whatTheCommandLineSetsIsNotTurned) {
  const auto run = flightWithin("1", {"clouds.tier=high"});
  const FrameBudget budget(fronts(), *run);
  EXPECT_EQ(valueOf(budget.rows(), "clouds.tier"), -1);
  EXPECT_EQ(valueOf(budget.rows(), "render.picture.scale"), 0.5);
  const auto both = flightWithin("1", {"clouds.march.stepM=30", "render.picture.scale=1"});
  const FrameBudget none(fronts(), *both);
  EXPECT_TRUE(none.rows().empty());
  EXPECT_THAT(none.text(), HasSubstr("set by hand"));
}

TEST(FrameBudget, itSwitchesNoCloudsOn) {
  for (const auto& run :
       {flightWithin("1000", {}, "terrain"), flightWithin("1000", {"effects.clouds=false"})})
    EXPECT_EQ(valueOf(FrameBudget(fronts(), *run).rows(), "clouds.tier"), -1);
}

TEST(FrameBudget, aRowThatIsSetByHandIsLetGoWithItsKnob) {
  const auto run = flightWithin("33");
  FrameBudget budget(fronts(), *run);
  govern(*run, budget.rows());
  EXPECT_THAT(budget.knobsOf({"view.vsync"}), ElementsAre());
  EXPECT_THAT(budget.knobsOf({"clouds.march.stepM"}), ElementsAre("clouds"));
  budget.letGo({"clouds"}, *run);
  EXPECT_EQ(valueOf(budget.rows(), "clouds.tier"), -1);
  EXPECT_EQ(valueOf(budget.rows(), "render.picture.scale"), 1) << "low in all pixels takes 30 of 33 ms";
  EXPECT_FALSE(govern(*run, budget.rows()).touches("render.picture.scale"));
  EXPECT_EQ(run->settings.clouds.tier, clouds::CloudTier::high) << "as it is without a budget";
}

TEST(BudgetFronts, thoseOfThisMachineAreKeptAndFoundAgain) {
  const test::TemporaryFolder cache;
  const auto file = keepBudgetFronts(measured(), key(), cache.path());
  const BudgetFronts found = findBudgetFronts(key(), cache.path());
  EXPECT_TRUE(found.measured);
  EXPECT_EQ(found.warning, "");
  EXPECT_EQ(found.file, file.string());
  EXPECT_EQ(accuracy::resultText(found.results), accuracy::resultText(measured()));
}

TEST(BudgetFronts, othersAreOfAnotherKey) {
  const auto name = [](const BudgetFrontKey& of) { return of.file("cache"); };
  BudgetFrontKey other = key();
  other.size.width = 641;
  EXPECT_NE(name(other), name(key()));
  other = key(), other.renderer = "another";
  EXPECT_NE(name(other), name(key()));
  other = key(), other.sceneText = "{ }";
  EXPECT_NE(name(other), name(key()));
  other = key(), other.scene = "../../fair";
  EXPECT_EQ(name(other).parent_path(), name(key()).parent_path()) << "a scene's name leads nowhere else";
}

TEST(BudgetFronts, whereNoneWereMeasuredShippedOnesAreUsedAndSaySo) {
  const test::TemporaryFolder cache;
  for (const std::filesystem::path& folder : {cache.path(), std::filesystem::path()}) {
    const BudgetFronts found = findBudgetFronts(key(), folder);
    EXPECT_FALSE(found.measured);
    EXPECT_EQ(found.warning, "");
    EXPECT_THAT(found.source, HasSubstr("skydrop accuracy calibrate --scene fair --size 640x360"));
    const auto ladder = accuracy::budgetLadder(found.results);
    ASSERT_GE(ladder.size(), 5u);
    EXPECT_LT(ladder.front().ms, ladder.back().ms / 5);
  }
}

TEST(BudgetFronts, damagedOnesAreReportedInOneLineAndShippedOnesUsed) {
  const test::TemporaryFolder cache;
  accuracy::Results foreign = measured(), forbidden = measured(), empty = measured(), large = measured();
  large.cases[0].points.assign(accuracy::kMostPoints + 1, measured().cases[0].points[0]);
  foreign.cases[0].machine = "another machine";
  forbidden.cases[0].points[0].set = {"wind.speed=40"};
  empty.cases[0].points.clear();
  const std::string good = accuracy::resultText(measured());
  for (const std::string& text :
       {std::string(), std::string("{}"), good.substr(0, good.size() / 2), accuracy::resultText(foreign),
        accuracy::resultText(forbidden), accuracy::resultText(empty), accuracy::resultText(large),
        std::string(kMostFrontBytes + 1, ' ')}) {
    const auto file = key().file(cache.path());
    std::filesystem::create_directories(file.parent_path());
    test::writePlainly(file, text);
    const BudgetFronts found = findBudgetFronts(key(), cache.path());
    EXPECT_FALSE(found.measured);
    EXPECT_TRUE(test::isOneLineAbout(found.warning, file.string())) << found.warning;
    EXPECT_THAT(found.warning, HasSubstr("; the shipped fronts are used"));
    EXPECT_THAT(found.file, HasSubstr("assets"));
  }
}

TEST(BudgetFronts, everyMutantIsRefusedInOneLineOrMakesALadderInRange) {
  int refused = 0, read = 0;
  test::forEachMutant(accuracy::resultText(measured()), 3000, [&](const std::string& mutant) {
    accuracy::Results results;
    const std::string line =
        test::refusalOf<core::DataError>([&] { results = parseBudgetFronts(mutant, "f.jsonl"); });
    if (!line.empty()) {
      ++refused;
      ASSERT_TRUE(test::isOneLineAbout(line, "f.jsonl")) << line;
      return;
    }
    ++read;
    double ms = 0;
    for (const accuracy::BudgetRung& rung : accuracy::budgetLadder(results)) {
      ASSERT_GT(rung.ms, ms);
      ms = rung.ms;
      ASSERT_TRUE(std::isfinite(rung.ms) && std::isfinite(rung.error));
      governedRows(rung.set, "f.jsonl");
    }
  });
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace skydrop::app
