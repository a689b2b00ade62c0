#include "skydrop/ui/menu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/key_map.h"
#include "ui/field_label.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

enum class Quality { low, medium, high };
constexpr std::string_view kQualityNames[] = {"low", "medium", "high"};

struct Wing {
  double span = 10;
};

void describe(core::SettingsVisitor& visitor, Wing& wing) {
  visitor.number("span", wing.span, {"m", 1, 20, "From tip to tip."});
}

struct Aircraft {
  double rollFactor = 0.75;
  double mass = 1200;
  std::int64_t blades = 2;
  bool smoke = false;
  Quality quality = Quality::medium;
  Wing wing;
};

void describe(core::SettingsVisitor& visitor, Aircraft& a) {
  using core::TakesEffect;
  visitor.number("rollFactor", a.rollFactor, {"1", 0, 2, "How strongly the stick rolls."});
  visitor.number("mass", a.mass, {"kg", 1, 100000, "Of the aircraft.", TakesEffect::rebuild, true});
  visitor.integer("blades", a.blades, {"1", 1, 6, "Of the propeller."});
  visitor.flag("smoke", a.smoke, {"Leaves a trail."});
  visitor.choice("quality", a.quality, kQualityNames, {"Of the model."});
  visitor.group("wing", a.wing, "The wing.");
}

struct Weather {
  double scale = 0.595;
  std::int64_t seed = 7;
};

void describe(core::SettingsVisitor& visitor, Weather& w) {
  visitor.number("scale", w.scale, {"%", 0.001, 1, "Low: bigger, fluffier."});
  visitor.integer("seed", w.seed, {"1", 0, 1e15, "Of the sky."});
}

struct Settings {
  Aircraft aircraft;
  Weather weather;
};

void describe(core::SettingsVisitor& visitor, Settings& s) {
  visitor.group("aircraft", s.aircraft, "The aircraft.");
  visitor.group("weather", s.weather, "The weather.");
}

class MenuTest : public ::testing::Test {
 protected:
  MenuTest()
      : driver(1280, 720, [this](const Interface& context) {
          if (!shown) return;
          const MenuResult result = menu.draw(context, {table, sections, statistics, error});
          changed.insert(changed.end(), result.changedPaths.begin(), result.changedPaths.end());
          if (result.closed) shown = false;
        }) {}

  const MenuRowPlace& place(const std::string& path) const { return menu.places().at(path); }

  // Presses at `from` of the slider's width and moves to `to`, without releasing.
  void drag(const std::string& path, float from, float to) {
    const ScreenRect rect = place(path).value;
    const float y = (rect.top + rect.bottom) / 2, width = rect.right - rect.left;
    driver.move(rect.left + from * width, y);
    driver.button(rect.left + from * width, y, true);
    driver.move(rect.left + to * width, y);
  }
  void release(const std::string& path, float at) {
    const ScreenRect rect = place(path).value;
    driver.button(rect.left + at * (rect.right - rect.left), (rect.top + rect.bottom) / 2, false);
    driver.frames(1);
  }

  Settings settings;
  core::SettingsTable table{settings};
  std::vector<MenuSection> sections = {{"aircraft", "Aircraft", true}};
  const core::FrameStatistics* statistics = nullptr;
  std::string error;
  bool shown = true;
  std::vector<std::string> changed;
  ConfigurationMenu menu;
  test::InterfaceDriver driver;  // last: its constructor draws
};

TEST_F(MenuTest, everyFieldOfTheGivenSectionsHasARowAndOthersHaveNone) {
  // Only the groups that the caller names are shown, subgroups included.
  const std::vector<std::string> expected = {"aircraft.rollFactor", "aircraft.mass",    "aircraft.blades",
                                             "aircraft.smoke",      "aircraft.quality", "aircraft.wing.span"};
  for (const std::string& path : expected) EXPECT_TRUE(menu.places().contains(path)) << path;
  EXPECT_EQ(menu.places().size(), expected.size());
  EXPECT_TRUE(changed.empty()) << "drawing alone changes nothing";
}

TEST_F(MenuTest, aLiveSliderChangesItsValueWhileItMoves) {
  drag("aircraft.rollFactor", 0.4f, 0.75f);
  EXPECT_NEAR(settings.aircraft.rollFactor, 1.5, 0.1);  // a twentieth: the grab's own width
  EXPECT_THAT(changed, ::testing::Contains("aircraft.rollFactor"));
  drag("aircraft.rollFactor", 0.75f, 5.0f);
  EXPECT_EQ(settings.aircraft.rollFactor, 2) << "dragged past the end, it stays in range";
  release("aircraft.rollFactor", 5.0f);
}

TEST_F(MenuTest, aSlowSettingWaitsUntilTheSliderIsReleased) {
  drag("aircraft.mass", 0.5f, 1.0f);
  driver.frames(5);
  EXPECT_EQ(settings.aircraft.mass, 1200);
  EXPECT_TRUE(changed.empty());
  release("aircraft.mass", 1.0f);
  EXPECT_NEAR(settings.aircraft.mass, 100000, 1e-6);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.mass"));
}

TEST_F(MenuTest, aLogarithmicSliderMovesByRatios) {
  drag("aircraft.mass", 0.1f, 0.5f);
  release("aircraft.mass", 0.5f);
  // The middle of 1 .. 1e5 by ratio is 316; the grab's width moves it by less than a third of a decade.
  EXPECT_NEAR(std::log10(settings.aircraft.mass), 2.5, 0.3);
}

TEST_F(MenuTest, aRowShowsResetOnlyWhileItIsNotTheDefault) {
  EXPECT_FALSE(place("aircraft.rollFactor").reset);
  settings.aircraft.rollFactor = 1.25;
  driver.frames(1);
  ASSERT_TRUE(place("aircraft.rollFactor").reset);
  driver.click(*place("aircraft.rollFactor").reset);
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.rollFactor"));
  EXPECT_FALSE(place("aircraft.rollFactor").reset);
}

TEST_F(MenuTest, resetAllSetsEveryShownSectionAndNoOther) {
  settings.aircraft = {1, 2, 3, true, Quality::high, {4}};
  settings.weather = {0.1, 8};
  driver.frames(1);
  driver.click(menu.resetAllPlace());
  for (const core::Field& field : table.fields()) {
    EXPECT_EQ(field.isDefault(), field.group != "weather") << field.path;
  }
  EXPECT_EQ(changed.size(), 6u);
}

TEST_F(MenuTest, aTypedValueIsClampedToTheRange) {
  // Control and a click make a text field of a slider.
  const ScreenRect rect = place("aircraft.rollFactor").value;
  driver.key(app::key::kLeftControl, true);
  driver.frames(1);
  driver.click(rect);
  driver.key(app::key::kLeftControl, false);
  driver.frames(1);
  EXPECT_TRUE(app::ImGuiInput::wantsText()) << "keys go to the field";
  driver.type("99");
  driver.tap(app::key::kEnter);
  EXPECT_EQ(settings.aircraft.rollFactor, 2);
  EXPECT_FALSE(app::ImGuiInput::wantsText());
}

TEST_F(MenuTest, aRangeTooWideForASliderIsTypedAndClamped) {
  sections = {{"weather", "Weather", true}};
  driver.frames(2);
  for (const auto& [typed, expected] :
       {std::pair("-5", std::int64_t{0}), std::pair("123456789012", 123456789012)}) {
    driver.click(place("weather.seed").value);
    driver.key(app::key::kLeftControl, true);
    driver.tap('A');
    driver.key(app::key::kLeftControl, false);
    driver.frames(1);
    driver.type(typed);
    driver.tap(app::key::kEnter);
    EXPECT_EQ(settings.weather.seed, expected);
  }
}

TEST_F(MenuTest, integersFlagsAndChoicesAreEdited) {
  drag("aircraft.blades", 0.3f, 1.0f);
  release("aircraft.blades", 1.0f);
  EXPECT_EQ(settings.aircraft.blades, 6);
  const ScreenRect box = place("aircraft.smoke").value;
  driver.click({box.left, box.top, box.left + (box.bottom - box.top), box.bottom});
  EXPECT_TRUE(settings.aircraft.smoke);
  const ScreenRect combo = place("aircraft.quality").value;
  driver.click(combo);
  // The list opens below the combo; its third entry is two and a half rows down.
  const float row = driver.context().text().pixels + ImGui::GetStyle().ItemSpacing.y;
  const float y = combo.bottom + ImGui::GetStyle().WindowPadding.y + 2.5f * row;
  driver.click({combo.left, y - 1, combo.right, y + 1});
  EXPECT_EQ(settings.aircraft.quality, Quality::high);
}

TEST_F(MenuTest, theCrossClosesIt) {
  // A click on the right end of the title bar.
  driver.click(menu.crossPlace());
  EXPECT_FALSE(shown);
}

TEST_F(MenuTest, theTopOfTheTableCanBeASectionToo) {
  // A section without a group's name shows the fields that belong to no group.
  sections = {{"", "Everything else", true}};
  driver.frames(2);
  EXPECT_TRUE(menu.places().empty());
  EXPECT_GT(menu.place().right, menu.place().left);
}

TEST_F(MenuTest, errorAndStatisticsAreDrawnOnRequest) {
  driver.frames(1);
  const float firstRow = place("aircraft.rollFactor").value.top;
  const int plain = driver.drawData()->TotalVtxCount;
  error = "shaders/sky/sky.frag:12: a long line about what is wrong with the shader that was just saved";
  driver.frames(2);
  EXPECT_GT(place("aircraft.rollFactor").value.top, firstRow);
  error.clear();
  core::FrameStatistics shownStatistics;
  shownStatistics.passes = {{"sky", {1.5, 1, 0, ""}}, {"clouds", {0, 0, 0, "no ray meets the layer"}}};
  statistics = &shownStatistics;
  driver.frames(2);
  EXPECT_GT(driver.drawData()->TotalVtxCount, plain);
}

TEST_F(MenuTest, aNewWindowSizeKeepsTheMenuInside) {
  driver.resize(320, 180);
  driver.frames(1);
  EXPECT_TRUE(driver.fontsChanged()) << "the pass must upload the atlas";
  driver.frames(2);
  EXPECT_FALSE(driver.fontsChanged());
  const MenuRowPlace& row = place("aircraft.rollFactor");
  EXPECT_GE(row.value.left, 0);
  EXPECT_LE(row.value.right, 320);
}

TEST_F(MenuTest, theSameFramesGiveTheSameVertices) {
  // No clock, no file: a picture of the menu is a function of what it shows.
  const auto vertices = [this] {
    driver.frames(2);
    std::vector<float> all;
    for (int i = 0; i < driver.drawData()->CmdListsCount; ++i) {
      for (const ImDrawVert& v : driver.drawData()->CmdLists[i]->VtxBuffer) {
        all.insert(all.end(), {v.pos.x, v.pos.y, v.uv.x, v.uv.y});
      }
    }
    return all;
  };
  const std::vector<float> first = vertices();
  driver.frames(100);
  EXPECT_EQ(vertices(), first);
  EXPECT_EQ(ImGui::GetIO().IniFilename, nullptr);
}

TEST(FieldLabel, namesReadAsWords) {
  EXPECT_EQ(humanName("rollFactor"), "Roll factor");
  EXPECT_EQ(humanName("mass"), "Mass");
  EXPECT_EQ(humanName("inducedYawFactor"), "Induced yaw factor");
  EXPECT_EQ(humanName("errorLODPixels"), "Error LOD pixels");
  EXPECT_EQ(humanName(""), "");
}

TEST(FieldLabel, theFormatShowsTheThesisDefaultsInFullAndEscapesUnits) {
  core::Field field;
  field.min = 0;
  field.max = 100;
  field.unit = "%";
  EXPECT_EQ(sliderFormat(field), "%.5g %%");
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", 32.175);
  EXPECT_STREQ(text, "32.175");
  field.unit = "1";
  field.logarithmic = true;
  field.min = 1e-7;
  EXPECT_EQ(sliderFormat(field), "%.7g") << "Dear ImGui would take less than 1e-5 for zero";
  field.kind = core::FieldKind::integer;
  EXPECT_EQ(sliderFormat(field), "%lld");
}

class EscapeMenuTest : public ::testing::Test {
 protected:
  EscapeAction taken() { return std::exchange(action, EscapeAction::none); }

  EscapeMenu menu;
  EscapeAction action = EscapeAction::none;
  test::InterfaceDriver driver{1280, 720, [this](const Interface& context) {
                                 const EscapeAction now = menu.draw(context);
                                 if (now != EscapeAction::none) action = now;
                               }};
};

TEST_F(EscapeMenuTest, arrowsSelectAndEnterChooses) {
  EXPECT_EQ(taken(), EscapeAction::none);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::resume) << "the first entry is selected at first";
  driver.tap(app::key::kDown);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::help);
  driver.tap(app::key::kDown);
  driver.tap(app::key::kKeypadEnter);
  EXPECT_EQ(taken(), EscapeAction::quit);
  driver.tap(app::key::kDown);
  EXPECT_EQ(menu.selected(), 0) << "wraps around";
  driver.tap(app::key::kUp);
  driver.tap(app::key::kEnter);
  EXPECT_EQ(taken(), EscapeAction::quit);
  menu.reset();
  EXPECT_EQ(menu.selected(), 0);
}

TEST_F(EscapeMenuTest, theMouseChooses) {
  constexpr EscapeAction kActions[] = {EscapeAction::resume, EscapeAction::help, EscapeAction::quit};
  ASSERT_EQ(menu.places().size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    driver.click(ScreenRect(menu.places()[i]));
    EXPECT_EQ(taken(), kActions[i]);
  }
}

TEST_F(EscapeMenuTest, aRestingMouseDoesNotHoldTheKeysBack) {
  const ScreenRect first = menu.places()[0];
  driver.move((first.left + first.right) / 2, (first.top + first.bottom) / 2);
  driver.tap(app::key::kDown);
  EXPECT_EQ(menu.selected(), 1);
}

}  // namespace
}  // namespace skydrop::ui
