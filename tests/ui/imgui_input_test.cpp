#include "app/input/imgui_input.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cstdio>
#include <string>

#include "app/input/event_feed.h"
#include "app/input/input_code.h"
#include "app/window/cursor_auto_hide.h"
#include "skydrop/ui/imgui_context.h"

namespace skydrop::app {
namespace {

using render::gl::WindowEvent;

class FakeClipboard : public Clipboard {
 public:
  std::string text() override { return kept; }
  void setText(const std::string& text) override { kept = text; }
  std::string kept;
};

class ImGuiInputTest : public ::testing::Test {
 protected:
  void frame(bool focusField = false) {
    feed.deliver({nullptr, [] { return true; }, [this] { build(false); }});
    build(focusField);
  }
  void build(bool focusField) {
    static_cast<void>(interface.beginFrame(640, 360, 1.0 / 60));
    feed.frameBuilt();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::Begin("Window");
    if (focusField) ImGui::SetKeyboardFocusHere();
    ImGui::InputText("field", field, sizeof field);
    ImGui::End();
    interface.endFrame();
  }
  void withControl(int code) {
    for (const auto& [key, pressed] : {std::pair(int{key::kLeftControl}, true), std::pair(code, true),
                                       std::pair(code, false), std::pair(int{key::kLeftControl}, false)}) {
      WindowEvent event{WindowEvent::Kind::key};
      event.code = key;
      event.letter = render::gl::letterOfKey(key, nullptr);
      event.pressed = pressed;
      feed.add(event);
      frame();
      frame();
    }
  }

  FakeClipboard clipboard;
  ui::Interface interface { 640, 360 };
  ImGuiInput input{&clipboard};
  EventFeed feed{input};
  char field[64] = "aircraft";
};

TEST_F(ImGuiInputTest, textIsCutCopiedAndPastedByTheWindowsClipboard) {
  frame(true);
  frame();
  withControl('A');
  withControl('C');
  EXPECT_EQ(clipboard.kept, "aircraft");
  clipboard.kept = "render.sun \u2191";
  withControl('A');
  withControl('V');
  EXPECT_STREQ(field, "render.sun \u2191");
  withControl('A');
  withControl('X');
  EXPECT_STREQ(field, "");
  EXPECT_EQ(clipboard.kept, "render.sun \u2191");
  ImGui::SetClipboardText("--set");
  EXPECT_EQ(clipboard.kept, "--set");
}

TEST_F(ImGuiInputTest, positionsArriveInPixelsOfTheFrame) {
  // A window of 320 x 180 coordinates on a screen with twice as many pixels.
  WindowEvent event{WindowEvent::Kind::mouseMove};
  event.x = 100;
  event.y = 50.5;
  feed.add(event, 2);
  frame();
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 200);
  EXPECT_EQ(ImGui::GetIO().MousePos.y, 101);
  event.kind = WindowEvent::Kind::scroll;
  event.x = 0;
  event.y = 1;
  feed.add(event, 2);
  frame();
  EXPECT_EQ(ImGui::GetIO().MousePos.x, 200) << "a turn of the wheel is no position";
}

TEST(MenuChord, controlWithALetterOfTheMenuIsNoKeyOfTheFlight) {
  // F alone freezes time; with Control it searches.
  WindowEvent event{WindowEvent::Kind::key};
  event.pressed = true;
  for (const char letter : {'F', 'Z', 'Y', 'A'}) {
    event.code = event.letter = letter;
    event.modifiers = 0;
    EXPECT_FALSE(ImGuiInput::isMenuChord(event)) << letter;
    event.modifiers = 2 | 1;  // GLFW_MOD_CONTROL, GLFW_MOD_SHIFT
    EXPECT_EQ(ImGuiInput::isMenuChord(event), letter != 'A') << letter;
  }
  event.kind = WindowEvent::Kind::character;
  EXPECT_FALSE(ImGuiInput::isMenuChord(event));
}

TEST(KeyboardLayout, shortcutsGoByTheLetterThatTheLayoutHas) {
  // GLFW's codes are places on an American keyboard; its names are what the layout has there.
  using render::gl::letterOfKey;
  EXPECT_EQ(letterOfKey('Y', "z"), 'Z') << "German";
  EXPECT_EQ(letterOfKey('Z', "y"), 'Y');
  EXPECT_EQ(letterOfKey('W', "z"), 'Z') << "French";
  EXPECT_EQ(letterOfKey('Z', "w"), 'W');
  EXPECT_EQ(letterOfKey('Q', "a"), 'A');
  EXPECT_EQ(letterOfKey(59, "m"), 'M') << "beside L";
  EXPECT_EQ(letterOfKey('M', ","), '\0') << "no letter is there";
  EXPECT_EQ(letterOfKey('Z', "z"), 'Z') << "American";
  EXPECT_EQ(letterOfKey('Z', "\xd1\x8f"), 'Z') << "Russian: no Latin letters, so the place counts";
  EXPECT_EQ(letterOfKey('Z', nullptr), 'Z');
  EXPECT_EQ(letterOfKey(key::kEnter, nullptr), '\0');
  EXPECT_EQ(letterOfKey('1', "1"), '\0');
}

TEST_F(ImGuiInputTest, aTextFieldsShortcutsGoByTheLetterOfAFrenchLayout) {
  // A stands on the place of the American Q, and its own place has Q: Ctrl with that is nothing.
  const auto chord = [this](int place, char letter) {
    for (const auto& [code, pressed] : {std::pair(int{key::kLeftControl}, true), std::pair(place, true),
                                        std::pair(place, false), std::pair(int{key::kLeftControl}, false)}) {
      WindowEvent event{WindowEvent::Kind::key};
      event.code = code;
      event.letter = code == place ? letter : '\0';
      event.pressed = pressed;
      feed.add(event);
    }
    frame();
  };
  frame(true);
  frame();
  chord('Q', 'A');
  chord('X', 'X');
  EXPECT_STREQ(field, "");
  EXPECT_EQ(clipboard.kept, "aircraft");
  chord('V', 'V');
  EXPECT_STREQ(field, "aircraft");
  chord('A', 'Q');
  WindowEvent letter{WindowEvent::Kind::character};
  letter.character = 's';
  feed.add(letter);
  frame();
  EXPECT_STREQ(field, "aircrafts") << "nothing was selected";
}

TEST(CursorAutoHide, aPointerAtRestHidesUnlessAMenuNeedsIt) {
  CursorAutoHide pointer;
  EXPECT_TRUE(pointer.isShown(0.5 * kCursorIdleSeconds, false, false));
  EXPECT_FALSE(pointer.isShown(0.6 * kCursorIdleSeconds, false, false));
  EXPECT_TRUE(pointer.isShown(1, true, false)) << "moved";
  EXPECT_FALSE(pointer.isShown(kCursorIdleSeconds, false, false));
  EXPECT_TRUE(pointer.isShown(10, false, true)) << "a menu is open";
  EXPECT_TRUE(pointer.isShown(0.5, false, false)) << "and stays a little when it closes";
}

}  // namespace
}  // namespace skydrop::app
