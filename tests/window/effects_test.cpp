// Effects switched in the real window.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "skydrop/scene/effect.h"
#include "support/process.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

bool flies(const json& statistics, const std::string& effect) {
  const json& effects = statistics.at("effects");
  return std::find(effects.begin(), effects.end(), effect) != effects.end();
}

bool draws(const json& statistics, const std::string& pass) { return statistics.at("passes").contains(pass); }

class EffectsWindow : public testing::Test {
 protected:
  void SetUp() override {
    SKIP_WITHOUT_DISPLAY();
    flown_.emplace(std::vector<std::string>{"--scene", "fair", "--set", "quality=low"});
    flown_->press("F1");
    ASSERT_TRUE(flown_->waitFor([](const json& s) { return s.at("window").at("menuOpen").get<bool>(); }));
  }

  // In the menu's search field.
  void set(const std::string& assignment) {
    flown_->press("ctrl+f");
    flown_->type(assignment);
    flown_->press("Return");
  }

  bool waitFor(const FlownGame::Condition& condition) { return flown_->waitFor(condition); }
  FlownGame& flown() { return *flown_; }

 private:
  std::optional<FlownGame> flown_;
};

TEST_F(EffectsWindow, comeAndGoWhileFlying) {
  // Clouds go and come back, land and targets go with what they simulate, and the flight goes on.
  const auto position = [](const json& s) { return s.at("game").at("position").dump(); };
  set("effects.clouds=false");
  EXPECT_TRUE(waitFor([](const json& s) { return !flies(s, "clouds") && !draws(s, "clouds"); }));
  set("effects.clouds=true");
  EXPECT_TRUE(waitFor([](const json& s) { return flies(s, "clouds") && draws(s, "clouds"); }));
  set("effects.targets=false");
  EXPECT_TRUE(waitFor([](const json& s) { return !flies(s, "targets") && !draws(s, "marker"); }));
  // What rests on land goes before it.
  for (const scene::EffectNeed& need : scene::kEffectNeeds)
    if (need.needs == scene::Effect::terrain)
      set("effects." + std::string(scene::nameOf(need.effect)) + "=false");
  EXPECT_TRUE(waitFor([](const json& s) { return !flies(s, "places") && !draws(s, "vegetation"); }));
  set("effects.terrain=false");
  EXPECT_TRUE(waitFor([](const json& s) {
    return !flies(s, "terrain") && !draws(s, "terrain") && s.at("terrain").at("chunksDrawn") == 0;
  }));
  set("effects.aircraft=false");
  EXPECT_TRUE(waitFor([](const json& s) {
    return !flies(s, "aircraft") && !draws(s, "aircraft") && s.at("window").at("camera") == "free";
  }));
  set("effects.terrain=true");
  EXPECT_TRUE(waitFor([](const json& s) { return s.at("terrain").at("chunksDrawn") > 0; }));
  set("effects.aircraft=true");
  EXPECT_TRUE(
      waitFor([](const json& s) { return draws(s, "aircraft") && s.at("window").at("camera") == "chase"; }));
  const std::string here = position(flown().statistics());
  EXPECT_TRUE(waitFor([&](const json& s) { return position(s) != here; })) << "it flies";
  EXPECT_EQ(flown().window().at("fault"), "");
}

TEST_F(EffectsWindow, whatAnotherRestsOnStays) {
  // Targets need an aircraft: the menu refuses in one line, and everything is as it was.
  set("effects.aircraft=false");
  EXPECT_TRUE(waitFor([](const json& s) {
    return s.at("window").at("fault").get<std::string>().find("targets needs aircraft") != std::string::npos;
  })) << flown().window().dump();
  EXPECT_TRUE(flies(flown().statistics(), "aircraft"));
  EXPECT_TRUE(draws(flown().statistics(), "aircraft"));
}

TEST(EffectsOfARun, areChosenByTheCommandLine) {
  // --effect and --no-effect; an unknown one, and one that another rests on, are refused in one line.
  const auto run = [](std::vector<std::string> words) {
    words.insert(words.begin(), {"simulate", "--seconds", "0.1"});
    return runSkydrop(words);
  };
  EXPECT_EQ(run({"--no-effect", "clouds", "--effect", "cloudDome"}).exitCode, 0);
  const ProcessResult unknown = run({"--effect", "cloud"});
  EXPECT_EQ(unknown.exitCode, 2);
  EXPECT_NE(unknown.err.find("unknown effect 'cloud'; the nearest are 'clouds'"), std::string::npos)
      << unknown.err;
  const ProcessResult needed = run({"--no-effect", "terrain"});
  EXPECT_EQ(needed.exitCode, 2);
  EXPECT_NE(needed.err.find("targets needs terrain, which is off"), std::string::npos) << needed.err;
}

}  // namespace
}  // namespace skydrop::test
