// What a player does within one slow frame takes effect in its order, as if frames were fast.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "app/input/event_feed.h"
#include "app/input/player_input.h"
#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

using app::ImGuiInput;
using Event = test::InterfaceDriver::Event;

// The menu with a flight beside it, as in the game: keys fly unless a text field has the keyboard.
class SlowFramesTest : public MenuFixture {
 protected:
  SlowFramesTest() {
    driver.setFirstReader([this](const Event& event) {
      const bool typing = ImGuiInput::wantsText() || ImGuiInput::isMenuChord(event);
      const bool letter = event.kind == Event::Kind::key && event.code < 128;
      if (letter && event.pressed && !typing) flown += static_cast<char>(event.code);
      return false;
    });
    driver.setFrameRate(3);
    driver.frames(2);
  }

  void press(float x, float y, bool pressed) {
    Event event{Event::Kind::mouseButton};
    event.pressed = pressed;
    event.x = x;
    event.y = y;
    driver.send(event);
  }
  void clickAt(float x, float y) {
    press(x, y, true);
    press(x, y, false);
  }
  void moveTo(float x, float y) {
    Event event{Event::Kind::mouseMove};
    event.x = x;
    event.y = y;
    driver.send(event);
  }
  // As a keyboard does: down, the letter, up.
  void typeKeys(const std::string& text) {
    for (const char c : text) {
      driver.key(c, true);
      Event letter{Event::Kind::character};
      letter.character = static_cast<unsigned char>(c);
      driver.send(letter);
      driver.key(c, false);
    }
  }
  void tapKey(int code) {
    driver.key(code, true);
    driver.key(code, false);
  }
  ScreenRect slider(const std::string& path) const { return place(path).value; }

  std::string flown;
};

TEST_F(SlowFramesTest, aDoubleClickInOneFrameTypesAndWhatIsTypedThereFliesNowhere) {
  // Double click, a number and Enter, all between two frames a third of a second apart.
  const ScreenRect rect = slider("aircraft.rollFactor");
  const float x = rect.right - 8, y = (rect.top + rect.bottom) / 2;
  moveTo(x, y);
  clickAt(x, y);
  clickAt(x, y);
  typeKeys("1.25");
  tapKey(app::key::kEnter);
  driver.frames(1);
  EXPECT_EQ(settings.aircraft.rollFactor, 1.25);
  EXPECT_EQ(flown, "");
  tapKey('W');
  driver.frames(1);
  EXPECT_EQ(flown, "W") << "the field is closed again";
  clickOn("undo");
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75) << "the clicks left no step of their own";
}

TEST_F(SlowFramesTest, aDoubleClickAcrossTwoFramesTypes) {
  // A tenth of a second apart in truth; all that is known is that two frames told of them.
  const ScreenRect rect = slider("aircraft.rollFactor");
  const float x = rect.right - 8, y = (rect.top + rect.bottom) / 2;
  clickAt(x, y);
  driver.frames(1);
  clickAt(x, y);
  driver.frames(1);
  typeKeys("1.5");
  tapKey(app::key::kEnter);
  driver.frames(1);
  EXPECT_EQ(settings.aircraft.rollFactor, 1.5);
  EXPECT_EQ(flown, "");
}

TEST_F(SlowFramesTest, twoClicksThatLieApartAreNoDoubleClick) {
  const ScreenRect rect = slider("aircraft.rollFactor");
  const float y = (rect.top + rect.bottom) / 2;
  clickAt(rect.right - 8, y);
  driver.frames(3);
  clickAt(rect.right - 8, y);
  driver.frames(3);
  EXPECT_FALSE(ImGuiInput::wantsText());
  EXPECT_GT(settings.aircraft.rollFactor, 1.9);
}

TEST_F(SlowFramesTest, aDragInOneFrameMovesTheSliderToItsEnd) {
  const ScreenRect rect = slider("aircraft.rollFactor");
  const float y = (rect.top + rect.bottom) / 2;
  moveTo(rect.left + 5, y);
  press(rect.left + 5, y, true);
  moveTo((rect.left + rect.right) / 2, y);
  moveTo(rect.right + 50, y);
  press(rect.right + 50, y, false);
  moveTo(rect.left, y);
  driver.frames(1);
  EXPECT_EQ(settings.aircraft.rollFactor, 2);
}

TEST_F(SlowFramesTest, clicksInOneFrameHitWhatTheyWereAimedAt) {
  const ScreenRect smoke = slider("aircraft.smoke"), roll = slider("aircraft.rollFactor");
  clickAt(smoke.left + 5, (smoke.top + smoke.bottom) / 2);
  clickAt(roll.right - 2, (roll.top + roll.bottom) / 2);
  clickAt(smoke.left + 5, (smoke.top + smoke.bottom) / 2);
  clickAt(smoke.left + 5, (smoke.top + smoke.bottom) / 2);
  driver.frames(1);
  EXPECT_TRUE(settings.aircraft.smoke) << "three clicks";
  EXPECT_GT(settings.aircraft.rollFactor, 1.9);
}

TEST_F(SlowFramesTest, editingKeysOfOneFrameKeepTheirOrder) {
  // Ctrl+F, a word, two letters taken back, another: Dear ImGui alone takes letters first and one key.
  driver.key(app::key::kLeftControl, true);
  tapKey('F');
  driver.key(app::key::kLeftControl, false);
  typeKeys("rollXY");
  tapKey(app::key::kBackspace);
  tapKey(app::key::kBackspace);
  typeKeys("F");
  driver.frames(1);
  EXPECT_THAT(rows(), ::testing::ElementsAre("aircraft.rollFactor"));
  EXPECT_EQ(flown, "");
}

TEST_F(SlowFramesTest, chordsOfOneFrameUndoAndRedoInTheirOrder) {
  // Undo, undo, redo, with Control let go between them and not.
  for (const double value : {1.0, 1.25, 1.5})
    menu.change(table, std::vector<SettingValue>{{"aircraft.rollFactor", value}});
  driver.key(app::key::kLeftControl, true);
  tapKey('Z');
  tapKey('Z');
  driver.key(app::key::kLeftControl, false);
  driver.key(app::key::kLeftControl, true);
  tapKey('Y');
  driver.key(app::key::kLeftControl, false);
  tapKey('Z');
  driver.frames(1);
  EXPECT_EQ(settings.aircraft.rollFactor, 1.25);
  EXPECT_EQ(flown, "Z") << "without Control it flies";
}

TEST_F(SlowFramesTest, aKeyThatRepeatsEditsAsOftenAsItsKeyboardSays) {
  startTyping("aircraft.mass");
  typeKeys("123456");
  driver.key(app::key::kBackspace, true);
  Event again{Event::Kind::key};
  again.code = app::key::kBackspace;
  again.pressed = again.repeated = true;
  driver.send(again);
  driver.send(again);
  driver.frames(4);  // more than a second: held, but the keyboard says no more
  driver.key(app::key::kBackspace, false);
  tapKey(app::key::kEnter);
  driver.frames(1);
  EXPECT_EQ(settings.aircraft.mass, 123);
}

TEST_F(SlowFramesTest, moreThanAFrameCanTakeWaitsInItsOrder) {
  // Far more events than one frame may spend frames of the interface on.
  startTyping("aircraft.mass");
  std::string digits;
  for (int i = 0; i < 4 * app::EventFeed::kMostFrames; ++i) tapKey(app::key::kRight);
  for (int i = 0; i < 3; ++i) tapKey(app::key::kBackspace);
  typeKeys("7");
  tapKey(app::key::kEnter);
  driver.frames(1);
  EXPECT_EQ(settings.aircraft.mass, 1200) << "not yet";
  driver.frames(20);
  EXPECT_EQ(settings.aircraft.mass, 17);
  EXPECT_EQ(flown, "");
}

TEST(PlayerTaps, aKeyThatWasPressedAndReleasedBetweenTwoStepsMovesItsLever) {
  // A tap within one slow frame is a short one, not none.
  app::PlayerInput input;
  render::gl::WindowEvent event{render::gl::WindowEvent::Kind::key};
  event.code = 'D';
  for (const bool pressed : {true, false}) {
    event.pressed = pressed;
    input.handle(event);
  }
  EXPECT_GT(input.step().roll, 0);
  for (int i = 0; i < app::kRampSteps; ++i) input.step();
  EXPECT_EQ(input.step().roll, 0);
}

}  // namespace
}  // namespace skydrop::ui
