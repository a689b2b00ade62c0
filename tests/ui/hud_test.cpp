#include "skydrop/ui/hud.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/input/bindings.h"
#include "support/margin.h"

namespace skydrop::ui {
namespace {

game::Snapshot flying() {
  game::Snapshot snapshot;
  snapshot.aircraft.present = true;
  snapshot.aircraft.position = {100, 812, -50};
  snapshot.aircraft.velocity = {60, 3, 0};
  snapshot.aircraft.airspeedMps = 60;
  snapshot.aircraft.headingRad = std::numbers::pi / 2;
  snapshot.aircraft.heightAboveGround = 310;
  snapshot.target.present = true;
  snapshot.target.position = {100, 40, -550};
  snapshot.target.distance = 500;
  return snapshot;
}

// Everything at once, with texts that are too long.
HudData fullest() {
  HudData data = makeHudData(flying());
  data.dropPulse = 1;
  data.cooldownSeconds = 1.5;
  data.stalled = data.paused = data.autopilot = data.frozen = true;
  data.score = data.misses = 123456789;
  data.targetDistanceM = 1e300;
  data.altitudeM = -1e12;
  const std::string longText =
      "The package landed in the water, 1234 m from the middle of the target, and is lost for ever. ";
  for (int i = 0; i < 3; ++i) data.messages.push_back({longText + longText, 1});
  return data;
}

std::vector<HelpRow> longHelp() {
  return std::vector<HelpRow>(16, {"Left, Right", "roll, and a sentence that does not fit into its column"});
}

bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

constexpr int kSizes[][2] = {{320, 180},  {320, 240},   {640, 360},   {800, 601},   {1024, 768}, {1280, 720},
                             {720, 1280}, {1920, 1080}, {2560, 1080}, {3440, 1440}, {3840, 2160}};

TEST(Hud, noItemCoversAnotherOrLeavesTheWindowAtAnySize) {
  // Score, notes, instruments, messages, drop text, pause, warning and help keep apart, from 320 x 180
  // on.
  for (const double scale : {1.0, 0.5, 3.0})
    for (const auto& [width, height] : kSizes) {
      const Interface context(width, height, {scale, 1});
      for (const auto& [help, paused, air] :
           {std::tuple(false, false, false), std::tuple(false, true, false), std::tuple(true, true, false),
            std::tuple(false, false, true), std::tuple(false, true, true), std::tuple(true, true, true)}) {
        HudData data = fullest();
        data.paused = paused;  // a pause takes the place of the warning
        if (air) data.air = HudAir{1e300, -1e12, -179.6, 123, 359.7, 1};
        const HudLayout layout = layoutHud(context, data, help ? longHelp() : std::vector<HelpRow>());
        ASSERT_EQ(layout.items.size(), help ? 6u : 8u);
        for (std::size_t i = 0; i < layout.items.size(); ++i) {
          const HudItem& item = layout.items[i];
          SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + " " + item.name);
          EXPECT_LT(item.rect.left, item.rect.right);
          EXPECT_LT(item.rect.top, item.rect.bottom);
          EXPECT_GE(item.rect.left, 0);
          EXPECT_GE(item.rect.top, 0);
          EXPECT_LE(item.rect.right, static_cast<float>(width));
          EXPECT_LE(item.rect.bottom, static_cast<float>(height));
          for (std::size_t k = i + 1; k < layout.items.size(); ++k) {
            EXPECT_FALSE(overlap(item.rect, layout.items[k].rect)) << layout.items[k].name;
          }
        }
      }
    }
}

// With a package in the air, its picture, the dials, a warning of ground, and a table in the middle.
HudData delivering(bool panel) {
  HudData data = fullest();
  data.paused = false;
  data.points = 123456789;
  data.package = HudPackage{12345, 1e12, false};
  data.pictureAspect = 16.0 / 9;
  data.instruments = InstrumentReadings{};
  data.pullUp = true;
  data.respawnSeconds = 2.5;
  data.crashReason = "The gear broke: the left wheel met the ground at 12.3 m/s (limit 3.5)";
  if (panel) {
    data.panel = HudPanel{"A title that goes on", {}, "And what it ends with"};
    for (int i = 0; i < 30; ++i)
      data.panel->rows.push_back(
          {"12345", "missed", "a cell of some length", "86400 s", "another one, longer still"});
  }
  return data;
}

TEST(Hud, theDropAndTheDialsKeepApartFromAllElse) {
  for (const double scale : {1.0, 0.5, 3.0})
    for (const auto& [width, height] : kSizes) {
      const Interface context(width, height, {scale, 1});
      for (const bool panel : {false, true}) {
        const HudLayout layout = layoutHud(context, delivering(panel));
        for (std::size_t i = 0; i < layout.items.size(); ++i) {
          const HudItem& item = layout.items[i];
          SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height) + " " + item.name);
          EXPECT_GE(item.rect.left, 0);
          EXPECT_GE(item.rect.top, 0);
          EXPECT_LE(item.rect.right, static_cast<float>(width));
          EXPECT_LE(item.rect.bottom, static_cast<float>(height));
          for (std::size_t k = i + 1; k < layout.items.size(); ++k)
            EXPECT_FALSE(overlap(item.rect, layout.items[k].rect)) << layout.items[k].name;
          for (const HudText& text : item.texts) {
            const Typeface& typeface = text.large ? context.large() : context.text();
            const ImVec2 size = typeface.face->CalcTextSizeA(typeface.pixels, FLT_MAX, 0, text.text.c_str());
            EXPECT_GE(text.position.x, item.rect.left) << text.text;
            EXPECT_LE(text.position.x + size.x, item.rect.right) << text.text;
            EXPECT_LE(text.position.y + size.y, item.rect.bottom) << text.text;
          }
        }
      }
    }
}

TEST(Hud, theDialsAreReadableAt640And4KAndLeftOutWhereTheyAreNot) {
  HudData data = makeHudData(flying());
  data.instruments = InstrumentReadings{};
  for (const auto& [width, height] : {std::pair(640, 360), std::pair(1920, 1080), std::pair(3840, 2160)}) {
    const HudLayout layout = layoutHud(Interface(width, height), data);
    ASSERT_TRUE(layout.instruments) << width;
    const ScreenRect& dial = (*layout.instruments)[0];
    EXPECT_GE(dial.right - dial.left, 0.11f * static_cast<float>(height)) << width;
    EXPECT_LE(dial.bottom - dial.top, 0.2f * static_cast<float>(height)) << "they leave the view free";
  }
  EXPECT_FALSE(layoutHud(Interface(320, 180), data).instruments);
}

TEST(Hud, aCrashNamesItsReasonAndTheKeyThatBeginsAgain) {
  game::Snapshot snapshot = flying();
  snapshot.aircraft.crashed = true;
  snapshot.aircraft.secondsToRespawn = 2.1;
  snapshot.aircraft.gear.endReason = "Crashed into the ground";
  snapshot.pullUpSeconds = 1;
  const HudData data = makeHudData(snapshot);
  EXPECT_FALSE(data.pullUp) << "too late";
  std::string words;
  const Interface context(1280, 720);
  for (const HudItem& item : layoutHud(context, data).items)
    for (const HudText& line : item.texts) words += line.text + "|";
  EXPECT_NE(words.find("Crashed into the ground: back in 2.1 s, R begins again"), std::string::npos) << words;
}

TEST(Hud, withWeatherItShowsGroundSpeedCrabWindAndIce) {
  // Instruments show the indicated airspeed, the speed over the ground beside it, how far the nose is held
  // into the wind, where the wind comes from, and the ice; without weather none of it.
  game::Snapshot snapshot = flying();
  EXPECT_FALSE(makeHudData(snapshot).air);
  snapshot.air.present = true;
  snapshot.air.indicatedMps = 55.4;
  snapshot.air.groundMps = 81.6;
  snapshot.air.driftRad = -7 * std::numbers::pi / 180;
  snapshot.air.wind = {0, 0, 12};  // from north
  snapshot.air.icing = 0.3;
  const Interface context(1280, 720);
  std::string words;
  for (const HudItem& item : layoutHud(context, makeHudData(snapshot)).items)
    for (const HudText& line : item.texts) words += line.text + "|";
  for (const char* part :
       {"55 m/s", "82 m/s", "090\u00b0 +7\u00b0", "000\u00b0 12 m/s", "Ice on the wing: 30 %"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in " << words;
}

TEST(Hud, theMiddleMovesBesideTheMenu) {
  // Neither messages, drop text, pause nor help stand under the configuration menu, on whichever side it is.
  for (const auto& [width, height] : kSizes) {
    const Interface context(width, height);
    const auto right = static_cast<float>(width), bottom = 0.7f * static_cast<float>(height);
    for (const ScreenRect& menu :
         {ScreenRect{5, 50, right * 0.42f, bottom}, ScreenRect{right * 0.6f, 50, right, bottom},
          ScreenRect{5, 30, right - 5, bottom}}) {
      for (const bool help : {false, true}) {
        const auto rows = help ? longHelp() : std::vector<HelpRow>();
        for (const HudItem& item : layoutHud(context, fullest(), rows, menu).items) {
          if (item.name == "score" || item.name == "notes") continue;  // above it
          const ScreenRect& rect = item.rect;
          if (item.name == "flight" || item.name == "navigation" || item.name == "position")
            continue;  // below it
          EXPECT_FALSE(overlap(rect, menu)) << width << "x" << height << " " << item.name;
        }
      }
    }
  }
}

TEST(Hud, textsStayInsideTheirItem) {
  // Cut with an ellipsis where they would not; measured as Dear ImGui draws them.
  for (const auto& [width, height] : kSizes) {
    const Interface context(width, height);
    for (const bool help : {false, true}) {
      const HudLayout layout = layoutHud(context, fullest(), help ? longHelp() : std::vector<HelpRow>());
      for (const HudItem& item : layout.items) {
        for (const HudText& text : item.texts) {
          const Typeface& typeface = text.large ? context.large() : context.text();
          const ImVec2 size = typeface.face->CalcTextSizeA(typeface.pixels, FLT_MAX, 0, text.text.c_str());
          EXPECT_GE(text.position.x, item.rect.left) << width << " " << item.name << ": " << text.text;
          EXPECT_LE(text.position.x + size.x, item.rect.right)
              << width << " " << item.name << ": " << text.text;
          EXPECT_GE(text.position.y, item.rect.top) << width << " " << item.name << ": " << text.text;
          EXPECT_LE(text.position.y + size.y, item.rect.bottom)
              << width << " " << item.name << ": " << text.text;
        }
      }
    }
  }
}

TEST(Hud, ordinaryValuesAreShownInFullAtEverySize) {
  // No ellipsis in a usual flight, the real help included; that of a gamepad from 640 pixels on.
  HudData data = makeHudData(flying());
  data.autopilot = true;
  data.dropPulse = 1;
  data.cooldownSeconds = 2;
  data.score = 99;
  data.misses = 99;
  data.altitudeM = 12345;
  data.targetDistanceM = 5999;
  for (const auto& [width, height] : kSizes) {
    const Interface context(width, height);
    for (const bool help : {false, true}) {
      const auto rows = help ? app::helpRows(app::Bindings(), width >= 640) : std::vector<HelpRow>();
      for (const HudItem& item : layoutHud(context, data, rows).items) {
        for (const HudText& text : item.texts) {
          EXPECT_EQ(text.text.find("\u2026"), std::string::npos)
              << width << "x" << height << ": " << text.text;
        }
      }
    }
  }
}

TEST(Hud, helpOfAGamepadKeepsItsMeaningsInSmallWindows) {
  // The inputs are cut first: half of a column is left to what they do.
  const Interface context(320, 180);
  HudData data = makeHudData(flying());
  const auto rows = app::helpRows(app::Bindings(), true);
  const HudLayout layout = layoutHud(context, data, rows);
  const auto help = std::ranges::find(layout.items, "help", &HudItem::name);
  ASSERT_NE(help, layout.items.end());
  float smallest = 1e9f;
  for (const HudText& text : help->texts) {
    if (text.tone != HudText::Tone::dim) continue;
    smallest = std::min(smallest, help->rect.right - text.position.x);
  }
  EXPECT_GT(smallest, (help->rect.right - help->rect.left) / 5);
}

TEST(Hud, notesNameTheKeysAsTheyAreBound) {
  // And none that does not exist.
  const Interface context(1280, 720);
  HudData data = makeHudData(flying());
  data.dropPulse = 1;
  data.paused = true;
  data.keys = {"X", "Pause", "F2"};
  const auto shows = [&](const std::string& wanted) {
    for (const HudItem& item : layoutHud(context, data).items) {
      for (const HudText& text : item.texts) {
        if (text.text == wanted) return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(shows("X"));
  EXPECT_TRUE(shows("Pause resumes"));
  data.paused = false;
  data.hintOpacity = 1;
  EXPECT_TRUE(shows("F2: controls"));
  data.keys = {"", "", ""};
  EXPECT_FALSE(shows(": controls"));
  data.paused = true;
  EXPECT_FALSE(shows(" resumes"));
}

TEST(Hud, tinyWindowsAreLaidOutWithoutHarm) {
  for (const auto& [width, height] :
       {std::pair(1, 1), std::pair(7, 5), std::pair(64, 36), std::pair(16384, 1)}) {
    const Interface context(width, height);
    EXPECT_FALSE(layoutHud(context, fullest(), longHelp()).items.empty());
    EXPECT_FALSE(layoutHud(context, fullest()).items.empty());
  }
}

TEST(Hud, readsTheSnapshot) {
  game::Snapshot snapshot = flying();
  snapshot.score = 3;
  snapshot.misses = 1;
  snapshot.aircraft.throttle = 0.5;
  const HudData data = makeHudData(snapshot);
  EXPECT_TRUE(data.aircraft);
  EXPECT_EQ(data.airspeedMps, 60);
  EXPECT_EQ(data.altitudeM, 812);
  EXPECT_EQ(data.heightAboveGroundM, 310);
  EXPECT_DOUBLE_EQ(data.headingDeg, 90);
  EXPECT_EQ(data.throttle, 0.5);
  EXPECT_EQ(data.targetDistanceM, 500);
  EXPECT_EQ(data.score, 3);
  EXPECT_EQ(data.misses, 1);
  EXPECT_FALSE(data.dropPulse);
  EXPECT_FALSE(data.respawnSeconds);
}

TEST(Hud, withoutAircraftOnlyScoreMessagesAndNotesRemain) {
  game::Snapshot snapshot;
  snapshot.target.present = true;
  const HudData data = makeHudData(snapshot);
  EXPECT_FALSE(data.navigation.dot);
  const Interface context(640, 360);
  const HudLayout layout = layoutHud(context, data);
  ASSERT_EQ(layout.items.size(), 1u);
  EXPECT_EQ(layout.items[0].name, "score");
  EXPECT_EQ(layout.circleRadius, 0);
}

TEST(NavigationBar, theArrowIsTheVelocityOnAMapWithNorthOnTop) {
  // +x is east: right; -z is north: up (y grows downwards). Vertical speed does not show.
  game::Snapshot snapshot = flying();
  snapshot.aircraft.velocity = {0, 50, -kNavigationSpeedMps / 2};
  EXPECT_EQ(makeHudData(snapshot).navigation.arrow, glm::dvec2(0, -0.5));
  snapshot.aircraft.velocity = {10 * kNavigationSpeedMps, 0, 0};
  EXPECT_EQ(makeHudData(snapshot).navigation.arrow, glm::dvec2(1, 0)) << "capped at the rim";
  snapshot.aircraft.velocity = {0, -80, 0};
  EXPECT_FALSE(makeHudData(snapshot).navigation.arrow) << "straight down has no direction on a map";
}

TEST(NavigationBar, theDotMovesInsideWhenNearAndStaysOnTheRimWhenFar) {
  game::Snapshot snapshot = flying();
  const glm::dvec3 from = snapshot.aircraft.position;
  const auto dotAt = [&](double x, double z) {
    snapshot.target.position = {from.x + x, 40, from.z + z};
    return makeHudData(snapshot).navigation.dot.value();
  };
  EXPECT_EQ(dotAt(0, -kNavigationRangeM / 2), glm::dvec2(0, -0.5));
  EXPECT_EQ(dotAt(kNavigationRangeM, 0), glm::dvec2(1, 0));
  EXPECT_EQ(dotAt(0, 3 * kNavigationRangeM), glm::dvec2(0, 1));
  const glm::dvec2 far = dotAt(-1e9, 1e9);
  EXPECT_NEAR(std::hypot(far.x, far.y), 1, 1e-12);  // rounding of one division
}

TEST(NavigationBar, P22_theDotIsTheCentreExactlyAboveTheTarget) {
  // Player exactly on the target: the direction is undefined, the dot is not.
  test::noFaults("P22", "differences");
  game::Snapshot snapshot = flying();
  snapshot.target.position = snapshot.aircraft.position;
  snapshot.aircraft.velocity = {0, 0, 0};
  const HudData data = makeHudData(snapshot);
  EXPECT_EQ(data.navigation.dot, glm::dvec2(0, 0));
  EXPECT_FALSE(data.navigation.arrow);
  const Interface context(640, 360);
  for (const HudItem& item : layoutHud(context, data).items) {
    for (const HudText& text : item.texts) EXPECT_EQ(text.text.find("nan"), std::string::npos) << text.text;
  }
}

TEST(NavigationBar, theDotBlinksBySimulatedTimeAlone) {
  game::Snapshot snapshot = flying();
  snapshot.simulatedSeconds = 1e7 + 0.25 * kBlinkPeriodSeconds;
  EXPECT_TRUE(makeHudData(snapshot).navigation.dotLit);
  EXPECT_TRUE(makeHudData(snapshot).navigation.dotLit);
  snapshot.simulatedSeconds = 1e7 + 0.75 * kBlinkPeriodSeconds;
  EXPECT_FALSE(makeHudData(snapshot).navigation.dotLit);
}

TEST(Hud, theDropTextPulsesWhileInTheZone) {
  game::Snapshot snapshot = flying();
  snapshot.dropZone = true;
  EXPECT_NEAR(makeHudData(snapshot).dropPulse.value(), 1, 1e-12);
  snapshot.simulatedSeconds = kPulsePeriodSeconds / 2;
  EXPECT_NEAR(makeHudData(snapshot).dropPulse.value(), 0, 1e-12);
}

TEST(Hud, aCrashedAircraftIsNotAskedToDrop) {
  game::Snapshot snapshot = flying();
  snapshot.dropZone = snapshot.aircraft.crashed = snapshot.aircraft.stalled = true;
  snapshot.aircraft.secondsToRespawn = 1.5;
  const HudData data = makeHudData(snapshot);
  EXPECT_FALSE(data.dropPulse);
  EXPECT_FALSE(data.stalled);
  EXPECT_EQ(data.respawnSeconds, 1.5);
}

TEST(Hud, aStallIsAnnouncedBeforeItIsThere) {
  // Near the stall the warning stands alone; in it the stall takes its place; a wreck has neither.
  game::Snapshot snapshot = flying();
  snapshot.aircraft.stallWarning = true;
  EXPECT_TRUE(makeHudData(snapshot).stallWarning);
  EXPECT_FALSE(makeHudData(snapshot).stalled);
  snapshot.aircraft.stalled = true;
  EXPECT_FALSE(makeHudData(snapshot).stallWarning);
  EXPECT_TRUE(makeHudData(snapshot).stalled);
  snapshot.aircraft.crashed = true;
  EXPECT_FALSE(makeHudData(snapshot).stallWarning);
}

TEST(Hud, theFirstSecondsNameTheKeyForHelp) {
  game::Snapshot snapshot = flying();
  EXPECT_EQ(makeHudData(snapshot).hintOpacity, 1);
  snapshot.autopilot = true;
  EXPECT_EQ(makeHudData(snapshot).hintOpacity, 0) << "nobody is at the stick";
  snapshot.autopilot = false;
  snapshot.simulatedSeconds = kHintSeconds;
  EXPECT_EQ(makeHudData(snapshot).hintOpacity, 0);
}

TEST(Hud, valuesThatAreNotFiniteAreShownAsZero) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInf = std::numeric_limits<double>::infinity();
  game::Snapshot snapshot = flying();
  snapshot.aircraft.position = {kNan, kInf, kNan};
  snapshot.aircraft.velocity = {kNan, 0, -kInf};
  snapshot.aircraft.airspeedMps = kInf;
  snapshot.aircraft.headingRad = kNan;
  snapshot.aircraft.throttle = kNan;
  snapshot.target.distance = kInf;
  snapshot.simulatedSeconds = kNan;
  const HudData data = makeHudData(snapshot);
  EXPECT_EQ(data.altitudeM, 0);
  EXPECT_EQ(data.airspeedMps, 0);
  EXPECT_EQ(data.headingDeg, 0);
  EXPECT_EQ(data.throttle, 0);
  EXPECT_EQ(data.targetDistanceM, 0);
  EXPECT_FALSE(data.navigation.arrow);
  EXPECT_TRUE(std::isfinite(data.navigation.dot->x) && std::isfinite(data.navigation.dot->y));
}

TEST(Hud, headingReads000To359) {
  game::Snapshot snapshot = flying();
  const Interface context(1280, 720);
  const auto shown = [&](double degrees) {
    snapshot.aircraft.headingRad = degrees * std::numbers::pi / 180;
    for (const HudItem& item : layoutHud(context, makeHudData(snapshot)).items) {
      if (item.name == "flight") return item.texts.at(3).text;
    }
    return std::string();
  };
  EXPECT_EQ(shown(0), "000\u00b0");
  EXPECT_EQ(shown(7.2), "007\u00b0");
  EXPECT_EQ(shown(359.7), "000\u00b0");
  EXPECT_EQ(shown(-90), "270\u00b0");
}

TEST(Hud, onlyTheLastThreeMessagesAreShownAndTheyFade) {
  game::Snapshot snapshot = flying();
  for (const char* text : {"one", "two", "three", "four"}) snapshot.messages.push_back({text, 3});
  snapshot.messages[1].secondsLeft = 0.25;
  const HudData data = makeHudData(snapshot);
  ASSERT_EQ(data.messages.size(), 3u);
  EXPECT_EQ(data.messages[0].text, "two");
  EXPECT_DOUBLE_EQ(data.messages[0].opacity, 0.5);
  EXPECT_EQ(data.messages[2].opacity, 1);
}

}  // namespace
}  // namespace skydrop::ui
