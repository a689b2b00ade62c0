#include "app/input/gamepad.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/input/gamepads.h"
#include "skydrop/core/guards.h"
#include "skydrop/core/settings_table.h"

namespace skydrop::app {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(),
                kInfinite = std::numeric_limits<float>::infinity();
// Of a float in [-1, 1] and the few double operations on it.
constexpr double kRounding = 1e-7;

GamepadSettings straight(double deadZone) {
  GamepadSettings settings;
  settings.deadZone = deadZone;
  settings.curve = 0;
  settings.triggerDeadZone = 0;
  return settings;
}

GamepadState stick(float x, float y) {
  GamepadState state;
  state.axes[pad::kLeftX] = x;
  state.axes[pad::kLeftY] = y;
  return state;
}

TEST(Gamepad, theDeadZoneIsSilentAndLeavesTheFullWay) {
  // 0 inside, continuous at its edge, 1 at the end, and odd.
  for (const double zone : {0.0, 0.12, 0.5, 0.9}) {
    EXPECT_EQ(withoutDeadZone(0, zone), 0);
    EXPECT_EQ(withoutDeadZone(zone, zone), 0);
    EXPECT_NEAR(withoutDeadZone(zone + 1e-9, zone), 0, 1e-7);
    EXPECT_NEAR(withoutDeadZone((1 + zone) / 2, zone), 0.5, 1e-12);  // rounding, tenfold by the widest zone
    EXPECT_EQ(withoutDeadZone(1, zone), 1);
    EXPECT_EQ(withoutDeadZone(-1, zone), -1);
    EXPECT_EQ(withoutDeadZone(1.5, zone), 1) << "worn sticks send more than 1";
  }
}

TEST(Gamepad, theCurveIsFineAtTheCentreAndKeepsTheEnds) {
  for (const double curve : {0.0, 0.4, 1.0}) {
    EXPECT_EQ(curved(0, curve), 0);
    EXPECT_DOUBLE_EQ(curved(1, curve), 1);
    EXPECT_DOUBLE_EQ(curved(-1, curve), -1);
    for (double x = -1; x < 1; x += 1.0 / 64) {
      EXPECT_LE(curved(x, curve), curved(x + 1.0 / 64, curve)) << "never falls";
      EXPECT_DOUBLE_EQ(curved(-x, curve), -curved(x, curve));
    }
  }
  EXPECT_EQ(curved(0.3, 0), 0.3);
  EXPECT_LT(curved(0.3, 0.4), 0.3);
}

TEST(Gamepad, axialZonesKeepDirectionsApartAndRadialOnesKeepTheDirection) {
  GamepadSettings settings = straight(0.2);
  GamepadReading reading = readingOf(stick(0.6f, 0.15f), settings);
  EXPECT_NEAR(reading.axes[pad::kLeftX], 0.5, kRounding);
  EXPECT_EQ(reading.axes[pad::kLeftY], 0);
  settings.deadZoneShape = DeadZoneShape::radial;
  reading = readingOf(stick(0.6f, 0.15f), settings);
  EXPECT_NEAR(reading.axes[pad::kLeftY] / reading.axes[pad::kLeftX], 0.25, kRounding);
  EXPECT_EQ(readingOf(stick(0.12f, 0.12f), settings).axes[pad::kLeftX], 0);
  for (const float end : {1.0f, -1.0f}) {
    EXPECT_EQ(readingOf(stick(end, 0), settings).axes[pad::kLeftX], end);
    EXPECT_EQ(readingOf(stick(end, end), settings).axes[pad::kLeftX], end) << "the corner of a square stick";
  }
}

TEST(Gamepad, triggersGoFromFreeToPulled) {
  GamepadState state;
  GamepadSettings settings = straight(0.2);
  EXPECT_EQ(readingOf(state, settings).axes[pad::kRightTrigger], 0);
  state.axes[pad::kRightTrigger] = 0;
  EXPECT_EQ(readingOf(state, settings).axes[pad::kRightTrigger], 0.5);
  settings.triggerDeadZone = 0.5;
  EXPECT_EQ(readingOf(state, settings).axes[pad::kRightTrigger], 0);
  state.axes[pad::kRightTrigger] = 1;
  EXPECT_EQ(readingOf(state, settings).axes[pad::kRightTrigger], 1);
}

TEST(Gamepad, anAxisThatSendsNoNumberIsFreeAndCounted) {
  // P13: whatever a device sends, every level is finite and within its range.
  for (const float bad : {kNan, kInfinite, -kInfinite}) {
    for (std::size_t axis = 0; axis < pad::kAxes; ++axis) {
      GamepadState state = stick(0.5f, -0.5f);
      state.axes[axis] = bad;
      core::resetGuardCounts();
      GamepadState good = stick(0.5f, -0.5f);
      good.axes[axis] = GamepadState().axes[axis];
      EXPECT_EQ(readingOf(state, GamepadSettings()).axes, readingOf(good, GamepadSettings()).axes) << axis;
      EXPECT_EQ(core::guardCount(core::Guard::notFiniteControl), 1u) << axis;
    }
  }
  core::resetGuardCounts();
  GamepadState huge;
  huge.axes.fill(1e38f);
  for (const double level : readingOf(huge, GamepadSettings()).axes) EXPECT_EQ(level, 1);
}

TEST(Gamepad, oneThatIsSwitchedOffIsAtRest) {
  GamepadState state = stick(1, 1);
  state.buttons.fill(true);
  GamepadSettings settings;
  settings.enabled = false;
  const GamepadReading reading = readingOf(state, settings);
  EXPECT_EQ(reading.axes, GamepadReading().axes);
  EXPECT_EQ(reading.buttons, GamepadReading().buttons);
}

TEST(Gamepad, strengthIsThatOfOneDirection) {
  GamepadReading reading;
  reading.axes[pad::kLeftX] = -0.5;
  reading.buttons[pad::kA] = true;
  EXPECT_EQ(reading.strength(axisInput(pad::kLeftX, false)), 0.5);
  EXPECT_EQ(reading.strength(axisInput(pad::kLeftX, true)), 0);
  reading.axes[pad::kLeftY] = 0.5;
  EXPECT_EQ(reading.strength(axisInput(pad::kLeftY, false)), 0);
  EXPECT_EQ(reading.strength(axisInput(pad::kLeftY, true)), 0.5);
  EXPECT_EQ(reading.strength(buttonInput(pad::kA)), 1);
  EXPECT_EQ(reading.strength(buttonInput(99)), 0);
  EXPECT_EQ(reading.strength(axisInput(-1, true)), 0);
  EXPECT_EQ(reading.strength(keyInput('A')), 0);
}

class FakeJoysticks : public JoystickSource {
 public:
  void plug(std::vector<Joystick> all) {
    joysticks = std::move(all);
    changed = true;
  }
  bool takeChange() override { return std::exchange(changed, false); }
  std::vector<Joystick> list() override { return joysticks; }
  std::optional<GamepadState> read(int id) override {
    GamepadState state;
    state.axes[0] = static_cast<float>(id) / 16;
    return state;
  }

  bool changed = true;
  std::vector<Joystick> joysticks;
};

std::vector<std::string> said(Gamepads& gamepads) {
  std::vector<std::string> texts;
  for (const GamepadMessage& message : gamepads.takeMessages()) texts.push_back(message.text);
  return texts;
}

TEST(Gamepads, noneIsNormalAndSaidOnce) {
  FakeJoysticks source;
  Gamepads gamepads(source);
  EXPECT_EQ(gamepads.poll(), std::nullopt);
  const auto messages = gamepads.takeMessages();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_FALSE(messages[0].isNews);
  source.plug({});
  EXPECT_EQ(gamepads.poll(), std::nullopt);
  EXPECT_TRUE(said(gamepads).empty());
}

TEST(Gamepads, theyComeAndGoWhileFlying) {
  FakeJoysticks source;
  Gamepads gamepads(source);
  gamepads.poll();
  said(gamepads);
  source.plug({{2, "Second", true}});
  EXPECT_EQ(gamepads.poll()->axes[0], 2.0f / 16);
  EXPECT_THAT(said(gamepads), ::testing::ElementsAre("Gamepad 'Second'"));
  EXPECT_TRUE(gamepads.poll());
  EXPECT_TRUE(said(gamepads).empty());
  source.plug({{1, "First", true}, {2, "Second", true}});
  EXPECT_EQ(gamepads.poll()->axes[0], 1.0f / 16) << "the lowest number";
  said(gamepads);
  source.plug({{2, "Second", true}});
  EXPECT_EQ(gamepads.poll()->axes[0], 2.0f / 16);
  EXPECT_THAT(said(gamepads), ::testing::ElementsAre("Gamepad 'First' is gone", "Gamepad 'Second'"));
  source.plug({});
  EXPECT_EQ(gamepads.poll(), std::nullopt);
  EXPECT_EQ(gamepads.name(), "");
  EXPECT_THAT(said(gamepads), ::testing::ElementsAre("Gamepad 'Second' is gone"));
}

TEST(Gamepads, aJoystickWithoutMappingIsNamedOnceAndNotUsed) {
  FakeJoysticks source;
  source.plug({{0, "Pedals", false}, {1, "Pad", true}});
  Gamepads gamepads(source);
  EXPECT_EQ(gamepads.poll()->axes[0], 1.0f / 16);
  EXPECT_THAT(said(gamepads), ::testing::ElementsAre(::testing::HasSubstr("'Pedals'"), "Gamepad 'Pad'"));
  source.plug({{1, "Pad", true}});
  gamepads.poll();
  source.plug({{0, "Pedals", false}, {1, "Pad", true}});
  gamepads.poll();
  EXPECT_TRUE(said(gamepads).empty());
}

TEST(GamepadSettings, everyFieldIsDescribed) {
  InputSettings settings;
  const core::SettingsTable table(settings);
  core::setField(table, "gamepad.deadZone=0.3");
  core::setField(table, "gamepad.deadZoneShape=radial");
  core::setField(table, "gamepad.invertPitch=true");
  EXPECT_EQ(settings.gamepad.deadZone, 0.3);
  EXPECT_EQ(settings.gamepad.deadZoneShape, DeadZoneShape::radial);
  EXPECT_TRUE(settings.gamepad.invertPitch);
  EXPECT_EQ(table.fields().size(), 8u);
}

}  // namespace
}  // namespace skydrop::app
