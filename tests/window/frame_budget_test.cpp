// The frame budget in the real window.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/process.h"
#include "support/stats_schema.h"
#include "support/temporary_folder.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

json budgetOf(const json& statistics) { return statistics.at("window").at("budget"); }

TEST(FrameBudgetWindow, aTightBudgetTakesTheCheapestRungAndReportsThatItDoesNotHold) {
  // No machine draws land at 640x360 in a millisecond. Without clouds in the scene the scale alone is turned.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "quality=low", "--frame-budget", "1"});
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !budgetOf(s).at("holds").get<bool>(); }))
      << flown.statistics().dump();
  const json budget = budgetOf(flown.statistics());
  EXPECT_EQ(budget.at("rung"), 0);
  EXPECT_NE(budget.at("choice").get<std::string>().find("scale 0.25"), std::string::npos) << budget.dump();
  EXPECT_NE(budget.at("text").get<std::string>().find("nothing is left to turn"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(flown.userFolder() / "settings.json"))
      << "neither the flag nor what the budget turned is the player's choice";
}

TEST(FrameBudgetWindow, aWideBudgetTakesTheBestRungAndStays) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "quality=low", "--frame-budget", "1000"});
  ASSERT_TRUE(flown.waitFor([](const json& s) { return budgetOf(s).at("medianMs").get<double>() > 0; }));
  const json budget = budgetOf(flown.statistics());
  EXPECT_EQ(budget.at("rung").get<int>() + 1, budget.at("rungs").get<int>()) << budget.dump();
  EXPECT_TRUE(budget.at("holds").get<bool>());
  EXPECT_EQ(budget.at("changes"), 0);
  if (!canCheckStatistics()) GTEST_SKIP() << "no python3 with jsonschema";
  EXPECT_EQ(faultsOfStatistics(flown.statisticsFile()), "");
}

TEST(FrameBudgetWindow, aRowThatIsSetByHandIsThePlayersUntilTheBudgetIsSetAnew) {
  // And the player's file has what was set by hand, not what the budget turned.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "quality=low"});
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("window").at("menuOpen").get<bool>(); }));
  const auto set = [&](const std::string& assignment) {
    flown.press("ctrl+f");
    flown.type(assignment);
    flown.press("Return");
  };
  const auto waitForRung = [&](int rung) {
    return flown.waitFor(
        [&](const json& s) { return !budgetOf(s).is_null() && budgetOf(s).at("rung") == rung; });
  };
  set("view.frameBudgetMs=1");
  ASSERT_TRUE(waitForRung(0)) << flown.statistics().at("window").dump();
  set("render.picture.scale=0.9");
  ASSERT_TRUE(waitForRung(-1)) << flown.statistics().at("window").dump();
  set("view.frameBudgetMs=2");
  ASSERT_TRUE(waitForRung(0)) << flown.statistics().at("window").dump();
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !s.at("window").at("menuOpen").get<bool>(); }));
  flown.process().askToEnd();
  ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
  std::ifstream file(flown.userFolder() / "settings.json");
  const json expected = {{"render", {{"picture", {{"scale", 0.9}}}}}, {"view", {{"frameBudgetMs", 2}}}};
  EXPECT_EQ(json::parse(file).at("settings"), expected);
}

TEST(FrameBudgetWindow, withoutABudgetThereIsNothingOfIt) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--set", "quality=low"});
  EXPECT_TRUE(budgetOf(flown.statistics()).is_null());
}

TEST(FrameBudgetWindow, aFlightThatABudgetGovernsReplaysToTheSameState) {
  // Only what is drawn is turned: the log of such a flight, made at whatever frame rate, is flown again step
  // by step without divergence.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "flight.log").string();
  {
    FlownGame flown({"--set", "quality=low", "--frame-budget", "20", "--record", log});
    flown.hold("Left");
    ASSERT_TRUE(flown.waitFor([](const json& s) { return s.at("steps").get<int>() > 240; }));
    flown.release("Left");
    flown.process().askToEnd();
    ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
  }
  const ProcessResult replay = runSkydrop({"simulate", "--replay", log});
  EXPECT_EQ(replay.exitCode, 0) << replay.err;
}

TEST(FrameBudgetProgram, whatCannotBeIsRefusedInOneLine) {
  const auto line = [](std::vector<std::string> words) {
    const ProcessResult result = runSkydrop(std::move(words));
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << result.err;
    return result.err;
  };
  EXPECT_NE(line({"--frame-budget", "0"}).find("--frame-budget: 0 is out of range 1 to 1000"),
            std::string::npos);
  EXPECT_NE(line({"--frame-budget", "nan"}).find("is not a finite number"), std::string::npos);
  EXPECT_NE(line({"render", "--set", "view.frameBudgetMs=33"}).find("does not depend on the time"),
            std::string::npos);
  EXPECT_NE(line({"accuracy", "calibrate", "cost"}).find("cost"), std::string::npos);
  EXPECT_NE(line({"accuracy", "calibrate", "landing"}).find("without other studies"), std::string::npos);
  for (const char* flag : {"--quick", "--resume"})
    EXPECT_NE(line({"accuracy", "calibrate", flag}).find(flag), std::string::npos);
  EXPECT_NE(line({"accuracy", "calibrate", "--out", "x"}).find("--out"), std::string::npos);
}

}  // namespace
}  // namespace skydrop::test
