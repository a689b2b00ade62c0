#include "app/input/player_input.h"

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
    EXPECT_EQ(settled(input), controls) << inputLabel(keyInput(code));
    input.handle(keyEvent(code, false));
    EXPECT_EQ(settled(input), game::Controls()) << inputLabel(keyInput(code));
    EXPECT_TRUE(input.takeActions().empty());
  }
}

TEST(PlayerInput, heldKeysMoveTheirLeversSoftlyAndLetGoOnesFaster) {
  // D held: the lever leaves the centre by less than a hundredth in a step, never moves by more than a
  // fifteenth, arrives after .25 s and is back .2 s after the release. Pitch takes .4 s.
  PlayerInput input;
  input.handle(keyEvent('D', true));
  input.handle(keyEvent(key::kDown, true));
  double last = 0;
  for (int i = 1; i <= kPitchKeys.attackSteps; ++i) {
    const game::Controls now = input.step();
    EXPECT_GE(now.roll, last);
    EXPECT_LT(now.roll - last, i == 1 ? 0.01 : 1.0 / 15) << i;
    EXPECT_EQ(now.roll == 1, i >= 30) << i;
    EXPECT_EQ(now.pitch == 1, i == 48) << i;
    last = now.roll;
  }
  input.handle(keyEvent('D', false));
  for (int i = 1; i <= 24; ++i) EXPECT_EQ(input.step().roll == 0, i == 24) << i;
}

TEST(PlayerInput, aTapIsANudge) {
  // A tenth of a second of the down arrow reaches between a twentieth and a quarter of the elevator.
  PlayerInput input;
  input.handle(keyEvent(key::kDown, true));
  double most = 0;
  for (int i = 0; i < 12; ++i) most = std::max(most, input.step().pitch);
  input.handle(keyEvent(key::kDown, false));
  for (int i = 0; i < 24; ++i) most = std::max(most, input.step().pitch);
  EXPECT_GT(most, 0.05);
  EXPECT_LT(most, 0.25);
  EXPECT_EQ(input.step().pitch, 0);
}

TEST(PlayerInput, theOtherKeyBringsTheLeverBackFirst) {
  // From full right, A alone: the lever passes the centre after the release time and is full left the attack
  // time later, without a jump.
  PlayerInput input;
  input.handle(keyEvent('D', true));
  settled(input);
  input.handle(keyEvent('D', false));
  input.handle(keyEvent('A', true));
  double last = 1;
  for (int i = 1; i <= 24 + 30; ++i) {
    const double now = input.step().roll;
    EXPECT_LT(now, last) << i;
    EXPECT_GT(now, last - 1.0 / 15) << i;
    EXPECT_EQ(now <= 0, i >= 24) << i;
    last = now;
  }
  EXPECT_EQ(last, -1);
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

// A gamepad with some axes moved.
GamepadReading pushed(std::map<int, double> axes) {
  GamepadReading reading;
  for (const auto& [axis, value] : axes) reading.axes[static_cast<std::size_t>(axis)] = value;
  return reading;
}

GamepadReading pressed(int button) {
  GamepadReading reading;
  reading.buttons[static_cast<std::size_t>(button)] = true;
  return reading;
}

const GamepadSettings kPad;

TEST(PlayerInput, sticksAndTriggersFlyAtOnceAndInProportion) {
  // Left stick rolls and pitches (back lifts the nose), right stick yaws, triggers pull the throttle.
  PlayerInput input;
  input.handle(
      pushed({{pad::kLeftX, 0.25}, {pad::kLeftY, -0.5}, {pad::kRightX, -0.75}, {pad::kRightTrigger, 0.6}}),
      kPad);
  EXPECT_EQ(input.step(), (game::Controls{.thrust = 0.6, .pitch = -0.5, .roll = 0.25, .yaw = -0.75}));
  input.handle(pushed({{pad::kLeftX, -1}, {pad::kLeftY, 1}, {pad::kLeftTrigger, 1}}), kPad);
  EXPECT_EQ(input.step(), (game::Controls{.brake = 1, .pitch = 1, .roll = -1}));
  input.handle(GamepadReading(), kPad);
  EXPECT_EQ(input.step(), game::Controls()) << "no ramp: the hand has one";
}

TEST(PlayerInput, eachInversionTurnsItsOwnControl) {
  PlayerInput input;
  const GamepadReading reading = pushed({{pad::kLeftX, 0.25}, {pad::kLeftY, 0.5}, {pad::kRightX, 0.75}});
  for (int which = 0; which < 3; ++which) {
    GamepadSettings settings;
    settings.invertPitch = which == 0;
    settings.invertRoll = which == 1;
    settings.invertYaw = which == 2;
    input.handle(reading, settings);
    const game::Controls controls = input.step();
    EXPECT_EQ(controls.pitch, which == 0 ? -0.5 : 0.5);
    EXPECT_EQ(controls.roll, which == 1 ? -0.25 : 0.25);
    EXPECT_EQ(controls.yaw, which == 2 ? -0.75 : 0.75);
  }
}

TEST(PlayerInput, keysAndGamepadAddUpToTheEnd) {
  // Neither takes the other's control away, whichever was used last.
  PlayerInput input;
  input.handle(keyEvent('D', true));
  settled(input);
  input.handle(pushed({{pad::kLeftX, 0.5}}), kPad);
  EXPECT_EQ(input.step().roll, 1) << "held to the range";
  input.handle(pushed({{pad::kLeftX, -0.25}}), kPad);
  EXPECT_EQ(input.step().roll, 0.75);
  input.handle(GamepadReading(), kPad);
  EXPECT_EQ(input.step().roll, 1) << "a gamepad at rest changes nothing";
}

TEST(PlayerInput, buttonsAreKeys) {
  // Bumpers yaw by the ramp, A drops once a press, and those of the program act once a press.
  PlayerInput input;
  input.handle(pressed(pad::kLeftBumper), kPad);
  EXPECT_DOUBLE_EQ(input.step().yaw, KeyAxisRamp(kYawKeys).step(-1));
  EXPECT_EQ(settled(input).yaw, -1);
  input.handle(pressed(pad::kA), kPad);
  EXPECT_TRUE(input.step().drop);
  input.handle(GamepadReading(), kPad);
  EXPECT_FALSE(input.step().drop);
  for (const int button : {int{pad::kY}, int{pad::kY}, int{pad::kStart}}) input.handle(pressed(button), kPad);
  EXPECT_THAT(input.takeActions(), ::testing::ElementsAre(Action::camera, Action::escape));
}

TEST(PlayerInput, anAxisThatTremblesPressesOnce) {
  // Bound to something that is on or off, it counts from half way and until it is well back.
  Bindings bindings;
  bindings.bind(Action::camera, axisInput(pad::kRightY, true));
  PlayerInput input(bindings);
  for (const double at : {0.45, 0.55, 0.45, 0.55, 0.35, 0.6})
    input.handle(pushed({{pad::kRightY, at}}), kPad);
  EXPECT_EQ(input.takeActions().size(), 1u);
  input.handle(pushed({{pad::kRightY, 0.2}}), kPad);
  input.handle(pushed({{pad::kRightY, 0.6}}), kPad);
  EXPECT_EQ(input.takeActions().size(), 1u);
}

TEST(PlayerInput, aGamepadFliesOnlyWithTheFocus) {
  // It tells its state to every window.
  PlayerInput input;
  input.handle(pushed({{pad::kLeftX, 1}}), kPad);
  input.handle(focusEvent(false));
  GamepadReading both = pushed({{pad::kLeftX, 1}});
  both.buttons[pad::kA] = true;
  input.handle(both, kPad);
  EXPECT_EQ(settled(input), game::Controls());
  input.handle(focusEvent(true));
  input.handle(both, kPad);
  EXPECT_EQ(settled(input), (game::Controls{.roll = 1})) << "A was pressed elsewhere";
}

TEST(PlayerInput, whatAMenuTookDoesNotFlyWhenItCloses) {
  // A on Resume must not drop a package.
  PlayerInput input;
  EXPECT_THAT(input.handle(pressed(pad::kA), kPad, true), ::testing::ElementsAre(buttonInput(pad::kA)));
  EXPECT_TRUE(input.handle(pressed(pad::kA), kPad, true).empty()) << "once a press";
  EXPECT_TRUE(input.handle(pressed(pad::kA), kPad).empty());
  EXPECT_EQ(input.step(), game::Controls());
  input.handle(GamepadReading(), kPad);
  input.handle(pressed(pad::kA), kPad);
  EXPECT_TRUE(input.step().drop);
}

TEST(PlayerInput, newBindingsLetGoOfWhatIsHeld) {
  PlayerInput input;
  input.handle(keyEvent('D', true));
  settled(input);
  Bindings bindings;
  bindings.bind(Action::rollLeft, keyInput('D'));
  input.setBindings(bindings);
  EXPECT_EQ(settled(input).roll, 0);
  input.handle(keyEvent('D', true));
  EXPECT_EQ(settled(input).roll, -1);
}

}  // namespace
}  // namespace skydrop::app
