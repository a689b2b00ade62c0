#include "skydrop/ui/bindings_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "app/input/player_controls.h"
#include "ui/interface_driver.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class OneGamepad : public JoystickSource {
 public:
  bool takeChange() override { return std::exchange(changed, false); }
  std::vector<Joystick> list() override {
    return plugged ? std::vector<Joystick>{{0, "Pad", true}} : std::vector<Joystick>();
  }
  std::optional<GamepadState> read(int) override { return state; }

  bool changed = true, plugged = true;
  GamepadState state;
};

// The menu's section as the game runs it: events to the controls first, then to Dear ImGui.
class BindingsViewTest : public ::testing::Test {
 protected:
  BindingsViewTest() { controls.pollGamepad(false); }

  void press(int code) {
    WindowEvent event{WindowEvent::Kind::key};
    event.code = code;
    for (const bool pressed : {true, false}) {
      event.pressed = pressed;
      if (!controls.handle(event, false)) driver.send(event);
    }
    driver.frames(3);
  }
  void pressButton(int button) {
    for (const bool pressed : {true, false}) {
      joysticks.state.buttons[static_cast<std::size_t>(button)] = pressed;
      controls.pollGamepad(false);
    }
    driver.frames(2);
  }
  const ui::BindingsPlaces::Row& row(Action action) const {
    return places.rows.at(std::string(actionName(action)));
  }
  void click(const ui::ScreenRect& rect) { driver.click(ui::ScreenRect(rect)); }
  bool isWaiting() const { return controls.menuContent().waiting.has_value(); }
  std::string note() const { return controls.menuContent().note; }

  Bindings bindings;
  GamepadSettings settings;
  OneGamepad joysticks;
  PlayerControls controls{bindings, settings, joysticks};
  ui::BindingsPlaces places;
  test::InterfaceDriver driver{1280, 1440, [this](const ui::Interface&) {
                                 ImGui::SetNextWindowPos({0, 0});
                                 ImGui::SetNextWindowSize({640, 1440});
                                 ImGui::Begin("Configuration");
                                 controls.apply(ui::drawBindings(controls.menuContent(), places));
                                 ImGui::End();
                               }};
};

TEST_F(BindingsViewTest, everyActionHasARowWithItsInputs) {
  ASSERT_EQ(places.rows.size(), kActions);
  for (std::size_t i = 0; i < kActions; ++i) {
    const auto action = static_cast<Action>(i);
    EXPECT_EQ(row(action).inputs.size(), bindings.inputsOf(action).size()) << actionName(action);
    EXPECT_FALSE(row(action).reset) << "it is at its default";
    for (const ui::ScreenRect& rect : row(action).inputs) EXPECT_LE(rect.right, 640) << actionName(action);
  }
}

TEST_F(BindingsViewTest, waitingAndItsNotesMoveNoRow) {
  const auto tops = [this] {
    driver.frames(2);
    std::vector<float> all;
    for (const auto& [name, row] : places.rows) {
      for (const ui::ScreenRect& rect : row.inputs) all.insert(all.end(), {rect.left, rect.top});
    }
    return all;
  };
  const std::vector<float> before = tops();
  click(row(Action::drop).inputs.at(0));
  EXPECT_TRUE(isWaiting());
  EXPECT_EQ(tops(), before);
  press(key::kSpace);
  joysticks.plugged = false;
  joysticks.changed = true;
  controls.pollGamepad(false);
  EXPECT_NE(note(), "");
  EXPECT_EQ(tops(), before);
}

TEST_F(BindingsViewTest, aClickAndAKeyPutItInThePlace) {
  click(row(Action::drop).inputs.at(0));
  EXPECT_TRUE(isWaiting());
  press('X');
  EXPECT_FALSE(isWaiting());
  EXPECT_THAT(bindings.inputsOf(Action::drop), ElementsAre(keyInput('X'), buttonInput(pad::kA)));
  EXPECT_EQ(note(), "X now does 'drop a package'.");
  EXPECT_FALSE(controls.input().step().drop) << "the key that is bound does not act";
  press('X');
  EXPECT_TRUE(controls.input().step().drop) << "and then it does";
}

TEST_F(BindingsViewTest, plusAddsAButtonAndTheOtherLosesItWithALineSayingSo) {
  ASSERT_TRUE(row(Action::camera).add);
  click(*row(Action::camera).add);
  pressButton(pad::kA);
  EXPECT_THAT(bindings.inputsOf(Action::camera),
              ElementsAre(keyInput('C'), buttonInput(pad::kY), buttonInput(pad::kA)));
  EXPECT_EQ(note(), "(A) now does 'camera', taken from 'drop a package'.");
  EXPECT_TRUE(controls.input().takeActions().empty());
  EXPECT_TRUE(row(Action::drop).reset);
  click(*row(Action::drop).reset);
  EXPECT_TRUE(bindings.isDefault(Action::drop));
  EXPECT_EQ(bindings.actionOf(buttonInput(pad::kA)), Action::drop);
}

TEST_F(BindingsViewTest, aStickIsBoundByPushingIt) {
  click(*row(Action::thrust).add);
  joysticks.state.axes[pad::kRightY] = -0.3f;
  controls.pollGamepad(false);
  EXPECT_TRUE(isWaiting()) << "it drifts";
  joysticks.state.axes[pad::kRightY] = -1;
  controls.pollGamepad(false);
  EXPECT_EQ(bindings.actionOf(axisInput(pad::kRightY, false)), Action::thrust);
  EXPECT_EQ(controls.input().step().thrust, 0) << "not in the frame that binds it";
  controls.pollGamepad(false);
  EXPECT_EQ(controls.input().step().thrust, 1);
}

TEST_F(BindingsViewTest, aButtonThatIsHeldWhenTheWaitingBeginsIsNotMeant) {
  joysticks.state.buttons[pad::kB] = true;
  controls.pollGamepad(false);
  click(row(Action::drop).inputs.at(1));
  controls.pollGamepad(false);
  EXPECT_TRUE(isWaiting());
  EXPECT_EQ(bindings, Bindings());
}

TEST_F(BindingsViewTest, escapeAClickAndLosingTheFocusCancel) {
  click(row(Action::drop).inputs.at(0));
  press(key::kEscape);
  EXPECT_FALSE(isWaiting());
  EXPECT_TRUE(controls.input().takeActions().empty()) << "the small menu stays closed";
  click(row(Action::drop).inputs.at(0));
  click(row(Action::drop).inputs.at(0));
  EXPECT_FALSE(isWaiting());
  click(row(Action::drop).inputs.at(0));
  click(row(Action::camera).inputs.at(0));
  EXPECT_EQ(controls.menuContent().waiting, (ui::BindingSlot{static_cast<std::size_t>(Action::camera), 0}));
  controls.handle({WindowEvent::Kind::focus}, false);
  EXPECT_FALSE(isWaiting());
  EXPECT_EQ(bindings, Bindings());
}

TEST_F(BindingsViewTest, theRightButtonTakesAnInputAway) {
  const ui::ScreenRect rect = row(Action::rollLeft).inputs.at(1);
  WindowEvent event{WindowEvent::Kind::mouseButton};
  event.code = 1;
  event.x = (rect.left + rect.right) / 2;
  event.y = (rect.top + rect.bottom) / 2;
  for (const bool pressed : {true, false}) {
    event.pressed = pressed;
    driver.send(event);
  }
  driver.frames(3);
  EXPECT_EQ(bindings.actionOf(keyInput(key::kLeft)), std::nullopt);
  EXPECT_THAT(note(), HasSubstr("no longer does 'roll left'"));
}

TEST_F(BindingsViewTest, aRefusalSaysWhyAndChangesNothing) {
  click(row(Action::drop).inputs.at(0));
  press(key::kF1);
  EXPECT_EQ(bindings, Bindings());
  EXPECT_EQ(note(), "Nothing changed: the configuration menu needs a key.");
}

TEST_F(BindingsViewTest, allControlsGoBack) {
  click(row(Action::drop).inputs.at(0));
  press('W');
  EXPECT_THAT(note(), HasSubstr("taken from 'faster'"));
  click(places.resetAll);
  EXPECT_EQ(bindings, Bindings());
}

TEST_F(BindingsViewTest, helpAndDisplayFollow) {
  controls.takeChange();
  EXPECT_FALSE(controls.takeChange());
  click(row(Action::drop).inputs.at(0));
  press('X');
  EXPECT_TRUE(controls.takeChange());
  EXPECT_EQ(controls.hudKeys().drop, "X");
  const auto lists = [this](const std::string& label) {
    for (const ui::HelpRow& help : controls.help()) {
      if (help.keys.find(label) != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(lists("(LB)"));
  joysticks.plugged = false;
  joysticks.changed = true;
  controls.pollGamepad(false);
  EXPECT_TRUE(controls.takeChange());
  EXPECT_FALSE(lists("(LB)")) << "the gamepad is gone";
}

TEST_F(BindingsViewTest, theGamepadSteersTheSmallMenu) {
  // Cross and stick move, A chooses, B and Start close; nothing of it flies.
  const auto keysOf = [this](int button) {
    joysticks.state.buttons[static_cast<std::size_t>(button)] = true;
    std::vector<int> codes;
    for (const WindowEvent& event : controls.pollGamepad(true)) {
      if (event.pressed) codes.push_back(event.code);
    }
    joysticks.state.buttons[static_cast<std::size_t>(button)] = false;
    controls.pollGamepad(true);
    return codes;
  };
  EXPECT_THAT(keysOf(pad::kUp), ElementsAre(key::kUp));
  EXPECT_THAT(keysOf(pad::kDown), ElementsAre(key::kDown));
  EXPECT_THAT(keysOf(pad::kA), ElementsAre(key::kEnter));
  EXPECT_TRUE(controls.input().takeActions().empty());
  EXPECT_TRUE(keysOf(pad::kB).empty());
  EXPECT_TRUE(keysOf(pad::kStart).empty());
  EXPECT_THAT(controls.input().takeActions(), ElementsAre(Action::escape, Action::escape));
  EXPECT_EQ(controls.input().step(), game::Controls());
}

}  // namespace
}  // namespace skydrop::app
