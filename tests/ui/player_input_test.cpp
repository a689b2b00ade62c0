#include "app/player_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

WindowEvent keyEvent(int code, bool pressed, bool repeated = false) {
  WindowEvent event{WindowEvent::Kind::key};
  event.code = code;
  event.pressed = pressed;
  event.repeated = repeated;
  return event;
}

WindowEvent focusEvent(bool gained) {
  WindowEvent event{WindowEvent::Kind::focus};
  event.pressed = gained;
  return event;
}

// The controls after the ramp has run out.
game::Controls settled(PlayerInput& input) {
  game::Controls controls;
  for (int i = 0; i < kRampSteps; ++i) controls = input.step();
  return controls;
}

TEST(PlayerInput, everyFlightKeyMovesItsControlToTheEnd) {
  // W thrust, S brake, A and left roll left, D and right roll right, up nose down, down nose up, Q and E yaw.
  const std::map<int, game::Controls> expected = {{'W', {.thrust = 1}},
                                                  {'S', {.brake = 1}},
                                                  {'A', {.roll = -1}},
                                                  {key::kLeft, {.roll = -1}},
                                                  {'D', {.roll = 1}},
                                                  {key::kRight, {.roll = 1}},
                                                  {key::kUp, {.pitch = -1}},
                                                  {key::kDown, {.pitch = 1}},
                                                  {'Q', {.yaw = -1}},
                                                  {'E', {.yaw = 1}},
                                                  {key::kSpace, {.drop = true}},
                                                  {'R', {.reset = true}}};
  for (const auto& [code, controls] : expected) {
    PlayerInput input;
    input.handle(keyEvent(code, true));
    EXPECT_EQ(settled(input), controls) << keyName(code);
    input.handle(keyEvent(code, false));
    EXPECT_EQ(settled(input), game::Controls()) << keyName(code);
    EXPECT_TRUE(input.takeActions().empty());
  }
}

TEST(PlayerInput, levelsRiseByEqualSharesOfAStep) {
  PlayerInput input;
  input.handle(keyEvent('D', true));
  for (int i = 1; i <= kRampSteps; ++i)
    EXPECT_DOUBLE_EQ(input.step().roll, static_cast<double>(i) / kRampSteps);
  EXPECT_EQ(input.step().roll, 1);
  input.handle(keyEvent('D', false));
  EXPECT_LT(input.step().roll, 1);
}

TEST(PlayerInput, oppositeKeysCancelAndEitherOfTwoKeysHolds) {
  PlayerInput input;
  input.handle(keyEvent('A', true));
  input.handle(keyEvent('D', true));
  EXPECT_EQ(settled(input).roll, 0);
  input.handle(keyEvent(key::kRight, true));
  input.handle(keyEvent('A', false));
  input.handle(keyEvent('D', false));
  EXPECT_EQ(settled(input).roll, 1) << "the right arrow is still held";
}

TEST(PlayerInput, aTapBetweenTwoStepsDropsOnce) {
  // At 5 frames a second a whole press falls between two steps.
  PlayerInput input;
  input.handle(keyEvent(key::kSpace, true));
  input.handle(keyEvent(key::kSpace, false));
  EXPECT_TRUE(input.step().drop);
  EXPECT_FALSE(input.step().drop);
  input.handle(keyEvent('R', true));
  input.handle(keyEvent('R', false));
  input.forgetTaps();
  EXPECT_FALSE(input.step().reset) << "pressed in a pause";
}

TEST(PlayerInput, losingTheFocusReleasesEveryKey) {
  PlayerInput input;
  input.handle(keyEvent('W', true));
  input.handle(keyEvent(key::kSpace, true));
  input.step();
  input.handle(focusEvent(false));
  EXPECT_EQ(settled(input), game::Controls());
  input.handle(focusEvent(true));
  EXPECT_EQ(settled(input), game::Controls()) << "a key is held again only when it is pressed again";
}

TEST(PlayerInput, keysTypedIntoAFieldDoNotFly) {
  PlayerInput input;
  input.handle(keyEvent('W', true));
  input.handle(keyEvent('D', true), true);
  input.handle(keyEvent('P', true), true);
  EXPECT_EQ(settled(input), (game::Controls{.thrust = 1}));
  EXPECT_TRUE(input.takeActions().empty());
  input.handle(keyEvent('W', false), true);
  EXPECT_EQ(settled(input), game::Controls()) << "a release counts wherever it arrives";
}

TEST(PlayerInput, actionsComeOnceAPressInOrder) {
  PlayerInput input;
  for (const int code :
       {int{'C'}, int{'P'}, int{'H'}, key::kF1, key::kF11, key::kF12, key::kEscape, int{'M'}}) {
    input.handle(keyEvent(code, true));
    input.handle(keyEvent(code, true, true));
    input.handle(keyEvent(code, false));
  }
  input.handle(keyEvent('Z', true));
  EXPECT_THAT(input.takeActions(),
              ::testing::ElementsAre(Action::camera, Action::pause, Action::help, Action::menu,
                                     Action::fullScreen, Action::screenshot, Action::escape, Action::mute));
  EXPECT_TRUE(input.takeActions().empty());
  EXPECT_EQ(input.step(), game::Controls());
}

TEST(PlayerInput, theSameKeysAtTheSameStepsGiveTheSameControls) {
  // However the steps are grouped into frames.
  const auto fly = [](int stepsPerFrame) {
    PlayerInput input;
    std::vector<game::Controls> flown;
    for (int step = 0; step < 240; step += stepsPerFrame) {
      if (step == 0) input.handle(keyEvent(key::kDown, true));
      if (step == 120) input.handle(keyEvent(key::kDown, false));
      for (int i = 0; i < stepsPerFrame; ++i) flown.push_back(input.step());
    }
    return flown;
  };
  EXPECT_EQ(fly(1), fly(8));
}

TEST(KeyMap, noKeyStandsInTwoBindingsAndEveryActionHasAHelpRow) {
  const KeyMap map = defaultKeyMap();
  std::map<int, int> uses;
  std::string helpKeys;
  for (const ui::HelpRow& row : helpRows(map)) helpKeys += " " + row.keys + " ";
  for (const KeyBinding& binding : map.bindings()) {
    for (const int code : binding.keys) {
      EXPECT_EQ(++uses[code], 1) << keyName(code);
      EXPECT_NE(helpKeys.find(" " + keyName(code) + " "), std::string::npos) << keyName(code);
    }
  }
}

}  // namespace
}  // namespace skydrop::app
