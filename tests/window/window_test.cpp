// Every key, pressed in the real window.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

#include "app/input/binding_editor.h"
#include "app/session/effect_table.h"
#include "app/settings/settings.h"
#include "skydrop/scene/scene.h"
#include "skydrop/ui/menu.h"
#include "support/process.h"
#include "ui/interface_driver.h"
#include "window/flown_game.h"

namespace skydrop::test {
namespace {

using nlohmann::json;

double game(const json& statistics, const char* name) { return statistics.at("game").at(name).get<double>(); }
bool isOn(const json& statistics, const char* name) { return statistics.at("window").at(name).get<bool>(); }

// Degrees from a to b, in (-180, 180].
double turn(double a, double b) { return std::remainder(b - a, 360.0); }

// Share of the pixels of a rectangle that differ by more than 8 of 255 in some channel.
double changed(const core::Image& a, const core::Image& b, const ui::ScreenRect& rect) {
  int count = 0, all = 0;
  for (int y = static_cast<int>(rect.top); y < static_cast<int>(rect.bottom); ++y) {
    for (int x = static_cast<int>(rect.left); x < static_cast<int>(rect.right); ++x) {
      ++all;
      for (int c = 0; c < 3; ++c) {
        if (std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]) > 8) {
          ++count;
          break;
        }
      }
    }
  }
  return static_cast<double>(count) / all;
}

// So many frames later than now.
FlownGame::Condition laterBy(const FlownGame& flown, int frames) {
  const auto until = flown.statistics().at("frame").at("count").get<int>() + frames;
  return [until](const json& s) { return s.at("frame").at("count").get<int>() > until; };
}

// Holds the key until the condition is met.
testing::AssertionResult whileHeld(FlownGame& flown, const std::string& key,
                                   const FlownGame::Condition& condition) {
  flown.hold(key);
  const bool met = flown.waitFor(condition);
  flown.release(key);
  if (met) return testing::AssertionSuccess();
  return testing::AssertionFailure() << key << ": " << flown.statistics()["game"].dump() << flown.log();
}

// Back to the start, held level and on its first heading.
void startAnew(FlownGame& flown, double heading) {
  flown.press("r");
  ASSERT_TRUE(flown.waitFor([&](const json& s) {
    return std::abs(game(s, "bank")) < 3 && std::abs(game(s, "pitch")) < 6 &&
           std::abs(turn(heading, game(s, "heading"))) < 2;
  })) << flown.statistics()["game"].dump();
}

TEST(Window, theThrottleKeysPullTheThrottle) {
  // W to full, S to idle, and back to cruise when both are free.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  const double cruise = game(flown.statistics(), "throttle");
  EXPECT_TRUE(whileHeld(flown, "w", [](const json& s) { return game(s, "throttle") > 0.9; }));
  EXPECT_TRUE(whileHeld(flown, "s", [&](const json& s) { return game(s, "throttle") < 0.5 * cruise; }));
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return std::abs(game(s, "throttle") - cruise) < 0.1; }));
}

TEST(Window, theStickKeysRollPitchAndYaw) {
  // D and right bank right, A and left bank left, down lifts the nose, up lowers it, E turns right, Q left.
  // What counts is the side to which the aircraft leaves its level flight first.
  SKIP_WITHOUT_DISPLAY();
  struct Case {
    const char* key;
    const char* angle;
    int sign;
  };
  constexpr Case kCases[] = {{"d", "bank", 1},     {"Right", "bank", 1}, {"a", "bank", -1},
                             {"Left", "bank", -1}, {"Down", "pitch", 1}, {"Up", "pitch", -1},
                             {"e", "heading", 1},  {"q", "heading", -1}};
  FlownGame flown;
  const double heading = game(flown.statistics(), "heading");
  for (const Case& c : kCases) {
    startAnew(flown, heading);
    const double level = c.angle == std::string("heading") ? heading : 0;
    double left = 0;
    EXPECT_TRUE(whileHeld(flown, c.key, [&](const json& s) {
      left = turn(level, game(s, c.angle));
      return std::abs(left) > 7;
    }));
    EXPECT_GT(left * c.sign, 7) << c.key;
  }
}

TEST(Window, spaceDropsAPackageAndRGoesBackToTheStart) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  const auto x = [](const json& s) { return s.at("game").at("position").at(0).get<double>(); };
  const auto z = [](const json& s) { return s.at("game").at("position").at(2).get<double>(); };
  flown.press("space");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return game(s, "drops") == 1; }));
  // 400 m away, then near the start again: the statistics are at most a second of flight old.
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return std::hypot(x(s), z(s)) > 400; }));
  flown.press("r");
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return std::hypot(x(s), z(s)) < 200; }));
  EXPECT_EQ(game(flown.statistics(), "drops"), 1) << "one press, one package";
}

TEST(Window, eachKeyOfTheProgramTogglesItsOwnThing) {
  // C goes around the cameras; P, H, F1 and Escape open and close.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  for (const std::string camera : {"cockpit", "free", "chase"}) {
    flown.press("c");
    EXPECT_TRUE(flown.waitFor([&](const json& s) { return s.at("window").at("camera") == camera; }))
        << camera;
  }
  const std::vector<std::pair<std::string, const char*>> toggles = {
      {"p", "paused"}, {"h", "helpOpen"}, {"F1", "menuOpen"}, {"Escape", "escapeOpen"}};
  for (const auto& [key, name] : toggles) {
    flown.press(key);
    EXPECT_TRUE(flown.waitFor([&](const json& s) { return isOn(s, name); })) << key;
    for (const auto& [otherKey, other] : toggles) {
      const bool expected = key == otherKey || (key == "Escape" && otherKey == "p");  // it pauses
      EXPECT_EQ(isOn(flown.statistics(), other), expected) << key << ": " << other;
    }
    flown.press(key);
    EXPECT_TRUE(flown.waitFor([&](const json& s) { return !isOn(s, name); })) << key;
  }
}

TEST(Window, lSwitchesTheLandingLight) {
  // Its pass works while it is on and says why it is idle while it is off; a scene without one says so.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({"--scene", "night-approach"});
  const auto skipped = [](const json& s) {
    return s.at("passes").at("landingLight").value("skipped", std::string());
  };
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return skipped(s).empty(); }));
  flown.press("l");
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return skipped(s) == "switched off"; }));
  flown.press("l");
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return skipped(s).empty(); }));
}

TEST(Window, aPauseStopsTheClock) {
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  flown.press("p");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "paused"); }));
  const json paused = flown.statistics();
  ASSERT_TRUE(flown.waitFor(laterBy(flown, 10)));
  EXPECT_EQ(flown.statistics().at("steps"), paused.at("steps"));
  EXPECT_EQ(flown.statistics().at("stateHash"), paused.at("stateHash"));
  flown.press("p");
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return s.at("steps") > paused.at("steps"); }));
}

TEST(Window, aFreezeHoldsTimeWhileTheCameraMovesAndIsNotRecorded) {
  // F holds the steps and frees the camera, whose keys still change the picture; F again rides on. What was
  // recorded around the freeze replays to the same state.
  SKIP_WITHOUT_DISPLAY();
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "flight.log").string();
  FlownGame flown({"--record", log});
  flown.press("f");
  ASSERT_TRUE(
      flown.waitFor([](const json& s) { return isOn(s, "frozen") && s.at("terrain").at("queue") == 0; }));
  const json frozen = flown.statistics();
  EXPECT_EQ(frozen.at("window").at("camera"), "free");
  EXPECT_FALSE(isOn(frozen, "paused"));
  const core::Image before = flown.screenshot();
  flown.hold("d");
  ASSERT_TRUE(flown.waitFor(laterBy(flown, 20)));
  flown.release("d");
  const core::Image after = flown.screenshot();
  EXPECT_GT(changed(before, after, {0, 60, FlownGame::kWidth, FlownGame::kHeight}), 0.2)
      << "the camera turned";
  EXPECT_EQ(flown.statistics().at("steps"), frozen.at("steps"));
  EXPECT_EQ(flown.statistics().at("stateHash"), frozen.at("stateHash"));
  flown.press("f");
  ASSERT_TRUE(
      flown.waitFor([&](const json& s) { return !isOn(s, "frozen") && s.at("steps") > frozen.at("steps"); }));
  EXPECT_EQ(flown.window().at("camera"), "chase");
  flown.process().askToEnd();
  ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
  const json end = flown.statistics();
  const ProcessResult replay = runSkydrop({"simulate", "--replay", log, "--seconds", "600"});
  EXPECT_NE(replay.out.find(end.at("stateHash").get<std::string>()), std::string::npos)
      << replay.out << replay.err;
}

TEST(Window, losingTheFocusPausesAndReleasesTheKeys) {
  // W is let go while another window has the keyboard: it must not stick.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  flown.hold("w");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return game(s, "throttle") > 0.9; }));
  flown.loseFocus();
  EXPECT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "paused"); }));
  flown.release("w");
  flown.focus();
  flown.press("p");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return !isOn(s, "paused") && game(s, "throttle") < 0.6; }));
}

TEST(Window, itFollowsItsSizeAndFillsTheScreen) {
  // Resized from outside, F11 to the whole display and back; screenshots have the size of the window.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  const auto hasSize = [](int width, int height) {
    return [=](const json& s) {
      return s.at("window").at("width") == width && s.at("window").at("height") == height;
    };
  };
  EXPECT_TRUE(flown.waitFor(hasSize(FlownGame::kWidth, FlownGame::kHeight)));
  flown.resize(500, 301);
  EXPECT_TRUE(flown.waitFor(hasSize(500, 301))) << flown.window().dump();
  const core::Image small = flown.screenshot();
  EXPECT_EQ(small.width, 500);
  EXPECT_EQ(small.height, 301);
  flown.press("F11");
  EXPECT_TRUE(flown.waitFor(hasSize(FlownGame::kDisplayWidth, FlownGame::kDisplayHeight)))
      << flown.window().dump();
  EXPECT_TRUE(isOn(flown.statistics(), "fullScreen"));
  flown.press("F11");
  EXPECT_TRUE(flown.waitFor(hasSize(500, 301))) << flown.window().dump();
  EXPECT_FALSE(isOn(flown.statistics(), "fullScreen"));
}

TEST(Window, theDisplayShowsThePictureInTheWholeWindow) {
  // What the display shows is what the game drew, at the first size, larger, smaller, over the whole screen
  // and back: the game's own target alone does not tell what arrives.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  flown.press("p");
  const std::vector<std::pair<int, int>> sizes = {
      {FlownGame::kWidth, FlownGame::kHeight},
      {790, 500},
      {400, 301},
      {FlownGame::kDisplayWidth, FlownGame::kDisplayHeight},  // F11
      {400, 301},                                             // and again
  };
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto [width, height] = sizes[i];
    if (i == 1 || i == 2) flown.resize(width, height);
    if (i >= 3) flown.press("F11");
    ASSERT_TRUE(flown.waitFor([&](const json& s) {
      return s.at("window").at("width") == width && s.at("window").at("height") == height &&
             isOn(s, "paused") && s.at("terrain").at("queue") == 0;
    })) << flown.window().dump();
    const core::Image drawn = flown.screenshot();
    ASSERT_EQ(drawn.width, width);
    ASSERT_EQ(drawn.height, height);
    // Without the top, where the note of the screenshot comes and goes.
    const ui::ScreenRect rest{0, 60, static_cast<float>(width), static_cast<float>(height)};
    double difference = 1;
    EXPECT_TRUE(flown.waitForPicture([&](const core::Image& shown) {
      difference = shown.width == width && shown.height == height ? changed(drawn, shown, rest) : 1;
      return difference < 0.001;
    })) << width
        << "x" << height << ": " << 100 * difference << " % of the window shows something else";
  }
}

// Where the menu's widgets stand in a window of this size: the same code, run without a window.
struct MenuPlaces {
  MenuPlaces() {
    ui::Interface interface(FlownGame::kWidth, FlownGame::kHeight);
    app::Settings settings;
    const core::SettingsTable table(settings);
    const auto sections = app::menuSections(scene::requiredEffects(scene::loadScene("terrain")));
    // Every section that the game shows above the rows.
    const core::FrameStatistics statistics;
    const core::SettingsTable* const bases[] = {&table};
    const ui::MenuTools tools{.bases = bases, .presets = std::span<const ui::PresetEntry>()};
    for (int i = 0; i < 2; ++i) {
      static_cast<void>(interface.beginFrame(FlownGame::kWidth, FlownGame::kHeight, 0));
      ui::MenuContent content{table, sections, &statistics, "", tools};
      content.bindings = &bindings;
      menu.draw(interface, content);
      escape.draw(interface);
      interface.endFrame();
    }
  }
  app::Bindings defaults;
  const ui::BindingsContent bindings = app::BindingEditor(defaults).content({}, "");
  ui::ConfigurationMenu menu;
  ui::EscapeMenu escape;
};

TEST(Window, picturesShowWhatIsOpen) {
  // A paused frame changes where the menu, the help and the Escape menu stand, and is the same again without.
  SKIP_WITHOUT_DISPLAY();
  const MenuPlaces places;
  FlownGame flown;
  flown.press("p");
  ASSERT_TRUE(
      flown.waitFor([](const json& s) { return isOn(s, "paused") && s.at("terrain").at("queue") == 0; }));
  const core::Image plain = flown.screenshot();
  ASSERT_EQ(plain.width, FlownGame::kWidth);
  ASSERT_EQ(plain.height, FlownGame::kHeight);
  // Without the top line, where the note of the screenshot stands.
  const ui::ScreenRect whole{0, 60, FlownGame::kWidth, FlownGame::kHeight};
  const ui::ScreenRect middle{200, 100, 440, 260};

  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "menuOpen"); }));
  EXPECT_GT(changed(plain, flown.screenshot(), places.menu.place()), 0.8);
  flown.press("F1");
  flown.press("h");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "helpOpen") && !isOn(s, "menuOpen"); }));
  EXPECT_GT(changed(plain, flown.screenshot(), middle), 0.3);
  flown.press("h");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !isOn(s, "helpOpen"); }));
  EXPECT_LT(changed(plain, flown.screenshot(), whole), 0.001) << "all is closed again";
}

TEST(Window, theTableOfCostsIsFilledAndRenewed) {
  // Opened by a click, it shows the passes, frames and bytes of the running game, and later ones later.
  SKIP_WITHOUT_DISPLAY();
  MenuPlaces places;
  FlownGame flown;
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "menuOpen"); }));
  EXPECT_EQ(flown.window().at("costs").at("passes"), 0) << "nobody looks";
  const ui::ScreenRect header = *places.menu.place("costs");
  flown.moveMouse((header.left + header.right) / 2, (header.top + header.bottom) / 2);
  flown.clickMouse("click");
  const auto shown = [](const json& s, const char* name) {
    return s.at("window").at("costs").at(name).get<std::int64_t>();
  };
  ASSERT_TRUE(flown.waitFor([&](const json& s) { return shown(s, "passes") > 0; })) << flown.window().dump();
  const json first = flown.statistics();
  EXPECT_EQ(shown(first, "passes"), std::ssize(first.at("passes")));
  EXPECT_GT(shown(first, "bytes"), 1 << 20);
  EXPECT_GT(shown(first, "frames"), 0);
  EXPECT_TRUE(flown.waitFor([&](const json& s) { return shown(s, "frames") > shown(first, "frames") + 5; }));
}

TEST(Window, theMouseMovesASliderResetsItAndClosesTheMenuByItsCross) {
  // And what the slider changed is kept among the player's settings.
  SKIP_WITHOUT_DISPLAY();
  const MenuPlaces places;
  FlownGame flown;
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "menuOpen"); }));
  const auto drag = [&](const std::string& path) {
    const ui::ScreenRect slider = places.menu.places().at(path).value;
    const float y = (slider.top + slider.bottom) / 2;
    flown.moveMouse(slider.left + 0.5f * (slider.right - slider.left), y);
    flown.clickMouse("mousedown");
    flown.moveMouse(slider.right - 2, y);
    flown.clickMouse("mouseup");
  };
  drag("aircraft.rollFactor");
  drag("aircraft.pitchSpeed");
  // The reset button stands right of the slider.
  const ui::ScreenRect row = places.menu.places().at("aircraft.pitchSpeed").value;
  flown.moveMouse(row.right + (row.bottom - row.top) * 0.8f, (row.top + row.bottom) / 2);
  flown.clickMouse("click");
  const ui::ScreenRect cross = places.menu.crossPlace();
  flown.moveMouse((cross.left + cross.right) / 2, (cross.top + cross.bottom) / 2);
  flown.clickMouse("click");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !isOn(s, "menuOpen"); }));
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
  std::ifstream file(flown.userFolder() / "settings.json");
  const std::string kept((std::istreambuf_iterator<char>(file)), {});
  EXPECT_NE(kept.find("rollFactor"), std::string::npos) << kept;
  EXPECT_EQ(kept.find("pitchSpeed"), std::string::npos) << kept;
}

// Clicks and keys that went in before have been handled.
void waitForFrames(FlownGame& flown, int frames) {
  const auto count = [](const json& s) { return s.at("frame").at("count").get<int>(); };
  const int wanted = count(flown.statistics()) + frames;
  ASSERT_TRUE(flown.waitFor([&](const json& s) { return count(s) > wanted; }));
}

json readJson(const std::filesystem::path& path) {
  std::ifstream file(path);
  return json::parse(file, nullptr, false);
}

TEST(Window, keysDoWhatThePlayersFileSays) {
  // Bound again: the new key acts, the old one does not. What the file does not name stays.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown({}, R"({"schema": 1, "bindings": {"camera": ["V"], "thrust": ["J", "KP_ADD"]}})");
  flown.press("c");
  flown.press("v");
  EXPECT_TRUE(flown.waitFor([](const json& s) { return s.at("window").at("camera") == "cockpit"; }));
  EXPECT_TRUE(whileHeld(flown, "j", [](const json& s) { return game(s, "throttle") > 0.9; }));
  EXPECT_TRUE(whileHeld(flown, "s", [](const json& s) { return game(s, "throttle") < 0.3; }));
  EXPECT_TRUE(whileHeld(flown, "KP_Add", [](const json& s) { return game(s, "throttle") > 0.9; }));
  EXPECT_EQ(flown.window().at("camera"), "cockpit") << "C is free";
}

TEST(Window, aKeyBoundInTheMenuFliesAndIsKept) {
  // Click on W, press X: X pulls the throttle, and the file says so after the flight.
  SKIP_WITHOUT_DISPLAY();
  app::Bindings bindings;
  const ui::BindingsContent content = app::BindingEditor(bindings).content({}, "");
  app::Settings settings;
  const core::SettingsTable table(settings);
  const auto sections = app::menuSections(scene::requiredEffects(scene::loadScene("terrain")));
  const core::FrameStatistics statistics;
  ui::ConfigurationMenu menu;
  InterfaceDriver twin(FlownGame::kWidth, FlownGame::kHeight, [&](const ui::Interface& interface) {
    ui::MenuContent shown{table, sections, &statistics};
    shown.bindings = &content;
    menu.draw(interface, shown);
  });
  FlownGame flown;
  flown.press("F1");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "menuOpen"); }));
  const auto click = [&](const ui::ScreenRect& rect) {
    flown.moveMouse((rect.left + rect.right) / 2, (rect.top + rect.bottom) / 2);
    flown.clickMouse("click");
  };
  const ui::ScreenRect header = *menu.place("controls");
  click(header);
  twin.click(header);
  click(menu.bindingPlaces().rows.at("thrust").inputs.at(0));
  waitForFrames(flown, 5);
  flown.press("x");
  waitForFrames(flown, 5);
  EXPECT_TRUE(whileHeld(flown, "x", [](const json& s) { return game(s, "throttle") > 0.9; }));
  flown.process().askToEnd();
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
  const json kept = readJson(flown.userFolder() / "settings.json");
  EXPECT_EQ(kept.at("bindings"), json({{"thrust", {"X", "GAMEPAD_AXIS_RIGHT_TRIGGER+"}}})) << kept.dump();
}

TEST(Window, shortcutsGoByTheLetterAndFlyingKeysByThePlace) {
  // Xdotool presses the key that has the letter. On a German keyboard Z has the place of the American Y, on a
  // French one of W: Ctrl with it undoes on both, alone it is no thrust on the one and thrust on the other.
  SKIP_WITHOUT_DISPLAY();
  for (const char* layout : {"de", "fr"}) {
    FlownGame flown(FlownGame::Launch{.keyboard = layout});
    const bool french = std::string(layout) == "fr";
    EXPECT_EQ(static_cast<bool>(whileHeld(flown, french ? "z" : "w",
                                          [](const json& s) { return game(s, "throttle") > 0.9; })),
              true)
        << layout;
    flown.press("F1");
    ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "menuOpen"); }));
    for (const char* assignment : {"aircraft.rollFactor=0.5", "aircraft.rollSpeed=40"}) {
      flown.press("ctrl+f");
      flown.type(assignment);
      flown.press("Return");
    }
    flown.press("ctrl+z");
    flown.press("F1");
    ASSERT_TRUE(flown.waitFor([](const json& s) { return !isOn(s, "menuOpen"); }));
    flown.process().askToEnd();
    ASSERT_EQ(flown.process().wait(60), 0) << flown.log();
    const json kept = readJson(flown.userFolder() / "settings.json");
    EXPECT_EQ(kept.at("settings"), json({{"aircraft", {{"rollFactor", 0.5}}}})) << layout;
  }
}

TEST(Window, theEscapeMenuResumesAndQuits) {
  // Enter on the first entry flies on; three further down it ends with exit code 0 and the last statistics.
  SKIP_WITHOUT_DISPLAY();
  FlownGame flown;
  flown.press("Escape");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "escapeOpen") && isOn(s, "paused"); }));
  flown.press("Return");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return !isOn(s, "escapeOpen") && !isOn(s, "paused"); }));
  flown.press("Escape");
  ASSERT_TRUE(flown.waitFor([](const json& s) { return isOn(s, "escapeOpen"); }));
  flown.press("Down");
  flown.press("Down");
  flown.press("Down");
  flown.press("Return");
  EXPECT_EQ(flown.process().wait(60), 0) << flown.log();
  EXPECT_TRUE(isOn(flown.statistics(), "escapeOpen"));
}

}  // namespace
}  // namespace skydrop::test
