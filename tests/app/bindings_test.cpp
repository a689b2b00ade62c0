#include "app/input/bindings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace skydrop::app {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<InputCode> everyInput() {
  std::vector<InputCode> all;
  for (int code = 0; code <= key::kLast; ++code) all.push_back(keyInput(code));
  for (int code = 0; code < pad::kButtons; ++code) all.push_back(buttonInput(code));
  for (int code = 0; code < pad::kAxes; ++code)
    all.insert(all.end(), {axisInput(code, true), axisInput(code, false)});
  return all;
}

TEST(InputCode, everyNameStandsForOneInput) {
  // GLFW 3.3 knows 120 keys (GLFW/glfw3.h); 15 buttons; four axes with two directions and two with one.
  std::map<std::string, int> names;
  int keys = 0, others = 0;
  for (const InputCode input : everyInput()) {
    const std::string name = inputName(input);
    if (name.empty()) continue;
    (input.isKey() ? keys : others) += 1;
    EXPECT_EQ(++names[name], 1) << name;
    EXPECT_EQ(inputNamed(name), input) << name;
  }
  EXPECT_EQ(keys, 120);
  EXPECT_EQ(others, 15 + 4 * 2 + 2);
  for (const char* none :
       {"", "w", "KEY_W", "GAMEPAD_BUTTON_", "GAMEPAD_AXIS_LEFT_X", "GAMEPAD_AXIS_LEFT_TRIGGER-", "F26"}) {
    EXPECT_EQ(inputNamed(none), std::nullopt) << none;
  }
}

TEST(InputCode, namesAreThoseOfGlfw) {
  EXPECT_EQ(inputNamed("W"), keyInput('W'));
  EXPECT_EQ(inputNamed("LEFT_SHIFT"), keyInput(key::kLeftShift));
  EXPECT_EQ(inputNamed("KP_0"), keyInput(key::kKeypad0));
  EXPECT_EQ(inputNamed("F25"), keyInput(key::kF25));
  EXPECT_EQ(inputNamed("GAMEPAD_BUTTON_DPAD_LEFT"), buttonInput(pad::kLeft));
  EXPECT_EQ(inputNamed("GAMEPAD_AXIS_RIGHT_Y-"), axisInput(pad::kRightY, false));
}

TEST(InputCode, labelsShowWhatStandsOnThePlayersKeys) {
  EXPECT_EQ(inputLabel(keyInput('Q')), "Q");
  EXPECT_EQ(inputLabel(keyInput('Q'), {{'Q', "A"}}), "A") << "a French keyboard";
  EXPECT_EQ(inputLabel(keyInput(key::kLeft)), "\u2190");
  EXPECT_EQ(inputLabel(buttonInput(pad::kA)), "(A)") << "apart from the key A";
  EXPECT_EQ(inputLabel(keyInput(-1)), "key -1");
}

TEST(Bindings, noInputStandsTwiceAndEveryKeyHasAHelpRow) {
  const Bindings bindings;
  std::map<InputCode, int> uses;
  std::string keys, both;
  for (const ui::HelpRow& row : helpRows(bindings)) keys += " " + row.keys + " ";
  for (const ui::HelpRow& row : helpRows(bindings, true)) both += " " + row.keys + " ";
  for (std::size_t i = 0; i < kActions; ++i) {
    for (const InputCode input : bindings.inputsOf(static_cast<Action>(i))) {
      EXPECT_EQ(++uses[input], 1) << inputName(input);
      EXPECT_EQ(bindings.actionOf(input), static_cast<Action>(i));
      EXPECT_THAT(both, HasSubstr(" " + inputLabel(input) + " "));
      EXPECT_EQ(keys.find(" " + inputLabel(input) + " ") != std::string::npos, input.isKey())
          << inputName(input);
    }
  }
}

TEST(Bindings, helpShowsTheBindingsAsTheyAre) {
  Bindings bindings;
  bindings.bind(Action::drop, keyInput('X'), 0);
  std::string drop;
  for (const ui::HelpRow& row : helpRows(bindings, false, {{'X', "Y"}})) {
    if (row.meaning == "drop a package") drop = row.keys;
  }
  EXPECT_EQ(drop, "Y");
}

TEST(Bindings, aBoundInputIsTakenFromTheOther) {
  Bindings bindings;
  const Bindings::Change change = bindings.bind(Action::drop, keyInput('W'));
  EXPECT_TRUE(change);
  EXPECT_THAT(change.takenFrom, ElementsAre(Action::thrust));
  EXPECT_EQ(bindings.actionOf(keyInput('W')), Action::drop);
  EXPECT_THAT(bindings.inputsOf(Action::thrust), ElementsAre(axisInput(pad::kRightTrigger, true)));
  EXPECT_THAT(bindings.inputsOf(Action::drop),
              ElementsAre(keyInput(key::kSpace), buttonInput(pad::kA), keyInput('W')));
  EXPECT_FALSE(bindings.isDefault(Action::thrust));
}

TEST(Bindings, anInputCanTakeAnothersPlace) {
  Bindings bindings;
  EXPECT_TRUE(bindings.bind(Action::drop, keyInput('X'), 0));
  EXPECT_THAT(bindings.inputsOf(Action::drop), ElementsAre(keyInput('X'), buttonInput(pad::kA)));
  EXPECT_EQ(bindings.actionOf(keyInput(key::kSpace)), std::nullopt);
  EXPECT_TRUE(bindings.bind(Action::drop, buttonInput(pad::kA), 0));
  EXPECT_THAT(bindings.inputsOf(Action::drop), ElementsAre(buttonInput(pad::kA), keyInput('X')))
      << "its own: they change places";
  EXPECT_TRUE(bindings.bind(Action::drop, keyInput('X')));
  EXPECT_EQ(bindings.inputsOf(Action::drop).size(), 2u) << "is there already";
}

TEST(Bindings, thePlayerAlwaysGetsBack) {
  // Escape and a key for the menu stay; a refusal changes nothing and says why.
  Bindings bindings;
  const auto refused = [&bindings](const Bindings::Change& change) {
    EXPECT_FALSE(change);
    EXPECT_THAT(change.takenFrom, IsEmpty());
    EXPECT_EQ(bindings, Bindings());
    return change.refusal;
  };
  EXPECT_THAT(refused(bindings.bind(Action::drop, keyInput(key::kEscape))), HasSubstr("Esc"));
  EXPECT_THAT(refused(bindings.bind(Action::escape, keyInput('X'), 0)), HasSubstr("Esc"));
  EXPECT_THAT(refused(bindings.unbind(Action::escape, 0)), HasSubstr("Esc"));
  EXPECT_THAT(refused(bindings.bind(Action::drop, keyInput(key::kF1))), HasSubstr("menu needs a key"));
  EXPECT_THAT(refused(bindings.unbind(Action::menu, 0)), HasSubstr("menu needs a key"));
  EXPECT_THAT(refused(bindings.bind(Action::drop, keyInput(7))), HasSubstr("no name"));
}

TEST(Bindings, aRowHoldsFour) {
  Bindings bindings;
  EXPECT_TRUE(bindings.bind(Action::drop, keyInput('X')));
  EXPECT_TRUE(bindings.bind(Action::drop, keyInput('Y')));
  EXPECT_THAT(bindings.bind(Action::drop, keyInput('Z')).refusal, HasSubstr("no room"));
  EXPECT_TRUE(bindings.bind(Action::drop, keyInput('Z'), 0)) << "in the place of another";
}

TEST(Bindings, aResetTakesItsDefaultsBack) {
  Bindings bindings;
  bindings.bind(Action::drop, keyInput('W'));
  const Bindings::Change change = bindings.resetAction(Action::thrust);
  EXPECT_TRUE(change);
  EXPECT_THAT(change.takenFrom, ElementsAre(Action::drop));
  EXPECT_EQ(bindings, Bindings());
  bindings.unbind(Action::camera, 0);
  bindings.resetAll();
  EXPECT_EQ(bindings, Bindings());
}

TEST(Bindings, theChangesComeBackFromJson) {
  Bindings bindings;
  EXPECT_EQ(bindings.toJson(), json::object()) << "only what was changed is written";
  bindings.bind(Action::drop, keyInput('W'), 0);
  bindings.bind(Action::brake, axisInput(pad::kRightY, true));
  while (!bindings.inputsOf(Action::mute).empty()) bindings.unbind(Action::mute, 0);
  const json written = bindings.toJson();
  EXPECT_EQ(written.size(), 4u) << written.dump();
  EXPECT_EQ(written["drop"], json({"W", "GAMEPAD_BUTTON_A"}));
  EXPECT_EQ(written["mute"], json::array());
  EXPECT_EQ(Bindings::fromJson(written).bindings, bindings);
}

TEST(Bindings, aFileByHandNeedNotNameWhatItTakesFrom) {
  const Bindings bindings = Bindings::fromJson({{"drop", {"W"}}}).bindings;
  EXPECT_THAT(bindings.inputsOf(Action::drop), ElementsAre(keyInput('W')));
  EXPECT_THAT(bindings.inputsOf(Action::thrust), ElementsAre(axisInput(pad::kRightTrigger, true)));
}

TEST(Bindings, whatDoesNotFitIsComplainedOfAndTheRestApplies) {
  // Each entry beside a good one: its place and the reason, in one line.
  const std::vector<std::pair<const char*, const char*>> cases = {
      {R"({"fly": ["W"]})", "bindings.fly: is no action"},
      {R"({"drop": "W"})", "bindings.drop: is no list"},
      {R"({"drop": [1]})", "1 is no name"},
      {R"({"drop": ["w"]})", "\"w\" is no key"},
      {R"({"drop": ["W", "W"]})", "bindings.drop: W is bound twice"},
      {R"({"drop": ["W"], "camera": ["W"]})", "bindings.drop: W is bound twice"},
      {R"({"drop": ["1", "2", "3", "4", "5"]})", "more than 4"},
      {R"({"drop": ["ESCAPE"]})", "bindings.drop: Esc"},
      {R"({"menu": ["GAMEPAD_BUTTON_B"]})", "bindings.menu: the configuration menu needs a key"},
      {R"({"drop": ["F1"]})", "bindings.drop: the configuration menu needs a key"}};
  for (const auto& [text, reason] : cases) {
    json object = json::parse(text);
    object["mute"] = {"N"};
    const Bindings::Read read = Bindings::fromJson(object);
    ASSERT_EQ(read.complaints.size(), 1u) << text;
    EXPECT_THAT(read.complaints[0], HasSubstr(reason)) << text;
    EXPECT_EQ(read.complaints[0].find('\n'), std::string::npos) << text;
    EXPECT_TRUE(read.bindings.isDefault(Action::drop) && read.bindings.isDefault(Action::menu)) << text;
    EXPECT_EQ(read.bindings.actionOf(keyInput('N')), Action::mute) << text;
  }
  EXPECT_THAT(Bindings::fromJson(json::array()).complaints, ElementsAre("bindings: is no object"));
  EXPECT_EQ(Bindings::fromJson(json::array()).bindings, Bindings());
}

TEST(Bindings, entriesThatBreakARuleOnlyTogetherAreAllLeftOut) {
  const Bindings::Read read = Bindings::fromJson({{"drop", {"ESCAPE"}}, {"help", {"F1"}}});
  EXPECT_EQ(read.bindings, Bindings());
  EXPECT_FALSE(read.complaints.empty());
}

}  // namespace
}  // namespace skydrop::app
