#include "skydrop/ui/menu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bindings.h"
#include "skydrop/core/error.h"
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
          MenuContent content{table, sections, statistics, error};
          content.tools = {.frameMs = frameMs, .bases = bases, .pose = pose, .presets = presets};
          const MenuResult result = menu.draw(context, content);
          changed.insert(changed.end(), result.changedPaths.begin(), result.changedPaths.end());
          if (result.preset) request = result.preset;
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

  // Control and a click make a text field of a slider.
  void startTyping(const std::string& path) {
    driver.key(app::key::kLeftControl, true);
    driver.frames(1);
    driver.click(place(path).value);
    driver.key(app::key::kLeftControl, false);
    driver.frames(3);
  }
  void typeAndEnter(const char* text) {
    driver.type(text);
    driver.tap(app::key::kEnter);
  }
  void clickOn(std::string_view what) {
    ASSERT_NE(menu.place(what), nullptr) << what;
    driver.click(ScreenRect(*menu.place(what)));
  }
  void chord(int code, bool shift = false) {
    driver.key(app::key::kLeftControl, true);
    if (shift) driver.key(app::key::kLeftShift, true);
    driver.frames(1);
    driver.tap(code);
    driver.key(app::key::kLeftControl, false);
    if (shift) driver.key(app::key::kLeftShift, false);
    driver.frames(3);
  }
  void search(const char* text) {
    chord('F');
    driver.type(text);
    driver.frames(2);
  }
  std::vector<std::string> rows() const {
    std::vector<std::string> paths;
    for (const auto& [path, where] : menu.places()) paths.push_back(path);
    return paths;
  }

  Settings settings, base;
  core::SettingsTable table{settings}, baseTable{base};
  const core::SettingsTable* bases[1] = {&baseTable};
  std::vector<double> frameMs;
  std::string pose;
  std::vector<PresetEntry> presetList;
  std::optional<std::span<const PresetEntry>> presets;
  std::optional<PresetRequest> request;
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
  clickOn("reset all");
  for (const core::Field& field : table.fields()) {
    EXPECT_EQ(field.isDefault(), field.group != "weather") << field.path;
  }
  EXPECT_EQ(changed.size(), 6u);
}

TEST_F(MenuTest, aTypedValueIsTakenExactlyOrRefusedWithALine) {
  // No rounding to the slider's five digits; out of range and no number change nothing and are said.
  startTyping("aircraft.rollFactor");
  EXPECT_TRUE(app::ImGuiInput::wantsText()) << "keys go to the field";
  typeAndEnter("0.123456789012345");
  EXPECT_EQ(settings.aircraft.rollFactor, 0.123456789012345);
  EXPECT_FALSE(app::ImGuiInput::wantsText());
  const float top = place("aircraft.rollFactor").value.top;
  for (const char* refused : {"99", "-1e-9", "fast", "nan", ""}) {
    startTyping("aircraft.rollFactor");
    if (*refused) {
      driver.type(refused);
    } else {
      driver.tap(app::key::kBackspace);
    }
    driver.tap(app::key::kEnter);
    EXPECT_EQ(settings.aircraft.rollFactor, 0.123456789012345) << refused;
    EXPECT_GT(place("aircraft.rollFactor").value.top, top) << "a line above says so: " << refused;
  }
  startTyping("aircraft.rollFactor");
  typeAndEnter("2");
  EXPECT_EQ(settings.aircraft.rollFactor, 2);
  EXPECT_EQ(place("aircraft.rollFactor").value.top, top) << "the line is gone";
}

TEST_F(MenuTest, aTypedValueMayCarryItsUnit) {
  startTyping("aircraft.mass");
  typeAndEnter("950.5 kg");
  EXPECT_EQ(settings.aircraft.mass, 950.5);
}

TEST_F(MenuTest, escapeLeavesATypedValueAsItWas) {
  startTyping("aircraft.rollFactor");
  driver.type("1.5");
  driver.tap(app::key::kEscape);
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_TRUE(changed.empty());
}

TEST_F(MenuTest, tabTypesOnInTheNextRow) {
  // And Shift with Tab in the one before; rows that are not numbers are passed over.
  startTyping("aircraft.mass");
  driver.type("900");
  driver.tap(app::key::kTab);
  EXPECT_EQ(settings.aircraft.mass, 900);
  driver.frames(3);
  driver.type("3");
  driver.tap(app::key::kTab);
  EXPECT_EQ(settings.aircraft.blades, 3);
  driver.frames(3);
  typeAndEnter("12");
  EXPECT_EQ(settings.aircraft.wing.span, 12);
}

TEST_F(MenuTest, aDoubleClickTypesAndTakesBackWhatItsFirstClickMoved) {
  for (const char* path : {"aircraft.rollFactor", "aircraft.mass"}) {
    const double before = table.at(path).get();
    const ScreenRect rect = place(path).value;
    const ScreenRect end{rect.right - 8, rect.top, rect.right - 6, rect.bottom};  // far from the value
    driver.click(end);
    driver.click(end);
    driver.frames(3);
    EXPECT_EQ(table.at(path).get(), before);
    EXPECT_TRUE(app::ImGuiInput::wantsText());
    typeAndEnter("1.25");
    EXPECT_EQ(table.at(path).get(), 1.25);
    driver.frames(30);
    EXPECT_EQ(table.at(path).get(), 1.25);
    clickOn("undo");
    EXPECT_EQ(table.at(path).get(), before) << "the clicks left no step of their own";
  }
}

TEST_F(MenuTest, aClickOnASlowSliderTakesEffectOnceNoSecondOneCanFollow) {
  const ScreenRect rect = place("aircraft.mass").value;
  driver.click({rect.right - 8, rect.top, rect.right - 6, rect.bottom});
  EXPECT_EQ(settings.aircraft.mass, 1200);
  driver.frames(30);  // half a second
  EXPECT_GT(settings.aircraft.mass, 50000);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.mass"));
}

TEST_F(MenuTest, aRangeTooWideForASliderIsTypedOrRefused) {
  sections = {{"weather", "Weather", true}};
  driver.frames(2);
  for (const auto& [typed, expected] :
       {std::pair("-5", std::int64_t{7}), std::pair("123456789012", 123456789012)}) {
    driver.click(place("weather.seed").value);
    driver.frames(3);
    typeAndEnter(typed);
    EXPECT_EQ(settings.weather.seed, expected);
  }
}

TEST_F(MenuTest, aDragIsOneStepThatUndoAndRedoTakeWhole) {
  const ScreenRect rect = place("aircraft.rollFactor").value;
  drag("aircraft.rollFactor", 0.4f, 0.6f);
  for (const float to : {0.7f, 0.8f, 0.9f}) {
    driver.move(rect.left + to * (rect.right - rect.left), (rect.top + rect.bottom) / 2);
  }
  release("aircraft.rollFactor", 0.9f);
  const double dragged = settings.aircraft.rollFactor;
  EXPECT_GT(dragged, 1.5);
  changed.clear();
  clickOn("undo");
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.rollFactor")) << "the caller hears of it";
  clickOn("redo");
  EXPECT_EQ(settings.aircraft.rollFactor, dragged);
  chord('Z');
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  chord('Y');
  EXPECT_EQ(settings.aircraft.rollFactor, dragged);
  chord('Z');
  chord('Z', true);
  EXPECT_EQ(settings.aircraft.rollFactor, dragged) << "Shift turns it round";
  clickOn("redo");
  EXPECT_EQ(settings.aircraft.rollFactor, dragged) << "nothing more to do again";
}

TEST_F(MenuTest, controlZInATextFieldIsTheFieldsOwn) {
  settings.aircraft.rollFactor = 1;
  driver.frames(1);
  driver.click(*place("aircraft.rollFactor").reset);
  startTyping("aircraft.rollFactor");
  chord('Z');
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  driver.tap(app::key::kEscape);
  chord('Z');
  EXPECT_EQ(settings.aircraft.rollFactor, 1);
}

TEST_F(MenuTest, resetAllIsUndoneAsOneStep) {
  settings.aircraft = {1, 2, 3, true, Quality::high, {4}};
  driver.frames(1);
  clickOn("reset all");
  EXPECT_EQ(settings.aircraft.mass, 1200);
  changed.clear();
  clickOn("undo");
  EXPECT_EQ(changed.size(), 6u);
  EXPECT_EQ(settings.aircraft.rollFactor, 1);
  EXPECT_EQ(settings.aircraft.mass, 2);
  EXPECT_EQ(settings.aircraft.blades, 3);
  EXPECT_TRUE(settings.aircraft.smoke);
  EXPECT_EQ(settings.aircraft.quality, Quality::high);
  EXPECT_EQ(settings.aircraft.wing.span, 4);
}

TEST_F(MenuTest, aSectionIsResetByItself) {
  sections = {{"aircraft", "Aircraft", true}, {"weather", "Weather", true}};
  settings.aircraft.mass = 900;
  settings.weather.scale = 0.1;
  driver.frames(3);
  clickOn("reset weather");
  EXPECT_EQ(settings.aircraft.mass, 900);
  EXPECT_EQ(settings.weather.scale, 0.595);
  driver.frames(1);
  EXPECT_EQ(menu.place("reset weather"), nullptr) << "nothing left to reset";
}

TEST_F(MenuTest, aSearchShowsRowsOfClosedSectionsTooAndNoOthers) {
  sections.push_back({"weather", "Weather", false});
  driver.frames(2);
  EXPECT_FALSE(menu.places().contains("weather.scale")) << "closed";
  search("FLUFFIER");
  EXPECT_THAT(rows(), ::testing::ElementsAre("weather.scale")) << "a word of the tooltip, capitals or not";
  EXPECT_TRUE(app::ImGuiInput::wantsText());
  search("wing span");
  EXPECT_THAT(rows(), ::testing::ElementsAre("aircraft.wing.span")) << "every word must stand somewhere";
  search("aircraft.m");
  EXPECT_THAT(rows(), ::testing::ElementsAre("aircraft.mass")) << "a part of the path";
  search("nothing like it");
  EXPECT_THAT(rows(), ::testing::IsEmpty());
  chord('F');
  driver.tap(app::key::kBackspace);
  EXPECT_EQ(rows().size(), 6u) << "an empty search shows the open sections";
}

TEST_F(MenuTest, onlyWhatWasChangedIsShownOnRequest) {
  sections.push_back({"weather", "Weather", false});
  settings.weather.seed = 8;
  settings.aircraft.smoke = true;
  driver.frames(2);
  clickOn("changed only");
  EXPECT_THAT(rows(), ::testing::ElementsAre("aircraft.smoke", "weather.seed"));
}

TEST_F(MenuTest, thePathAndAValueInTheSearchFieldSetIt) {
  // Flags and choices are within the keyboard's reach too.
  search("aircraft.quality=high");
  driver.tap(app::key::kEnter);
  EXPECT_EQ(settings.aircraft.quality, Quality::high);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.quality"));
  const float top = place("aircraft.rollFactor").value.top;
  for (const char* refused : {"aircraft.qualify=high", "aircraft.mass=0"}) {
    search(refused);
    driver.tap(app::key::kEnter);
    EXPECT_EQ(settings.aircraft.mass, 1200);
    EXPECT_TRUE(menu.places().empty()) << "it stands there still, to be mended";
  }
  chord('F');
  driver.tap(app::key::kBackspace);
  EXPECT_GT(place("aircraft.rollFactor").value.top, top) << "with the line that says what is wrong";
  chord('Z');
  driver.tap(app::key::kEscape);
  chord('Z');
  EXPECT_EQ(settings.aircraft.quality, Quality::medium);
}

TEST_F(MenuTest, whatIsOpenAndWhereTheMenuStandsIsRemembered) {
  sections.push_back({"weather", "Weather", false});
  driver.frames(2);
  clickOn("section aircraft");
  clickOn("section weather");
  EXPECT_THAT(rows(), ::testing::ElementsAre("weather.scale", "weather.seed"));
  EXPECT_FALSE(menu.state().place) << "nobody has moved it";
  const ScreenRect before = menu.place();
  const float y = before.top + 5;
  driver.move(before.left + 100, y);
  driver.button(before.left + 100, y, true);
  driver.move(before.left + 400, y + 50);
  driver.button(before.left + 400, y + 50, false);
  driver.frames(2);
  EXPECT_NEAR(menu.place().left, before.left + 300, 1);
  ASSERT_TRUE(menu.state().place);

  ConfigurationMenu next;
  next.setState(menu.state());
  test::InterfaceDriver nextDriver(1280, 720, [&](const Interface& context) {
    next.draw(context, {table, sections});
  });
  EXPECT_NEAR(next.place().left, menu.place().left, 1);
  EXPECT_NEAR(next.place().bottom, menu.place().bottom, 1);
  EXPECT_TRUE(next.places().contains("weather.seed"));
  EXPECT_FALSE(next.places().contains("aircraft.mass"));
  nextDriver.resize(640, 360);
  nextDriver.frames(2);
  EXPECT_NEAR(next.place().left, menu.place().left / 2, 1) << "at the same share of another window";
}

TEST_F(MenuTest, itLeavesTheAircraftFree) {
  // The wings of the aircraft that the chase camera follows end at a third of the width. Rows keep a slider
  // that can be aimed: a hand's width of pixels.
  for (const auto& [width, height] : {std::pair(640, 360), {1280, 720}, {1920, 1080}, {3840, 2160}}) {
    driver.resize(width, height);
    driver.frames(3);
    EXPECT_LE(menu.place().right, 0.33f * static_cast<float>(width)) << width;
    EXPECT_LE(menu.place().bottom, 0.8f * static_cast<float>(height)) << width;
    const ScreenRect slider = place("aircraft.rollFactor").value;
    EXPECT_GE(slider.right - slider.left, 70) << width;
    EXPECT_LE(slider.right, menu.place().right) << width;
  }
}

TEST_F(MenuTest, presetsAreSavedLoadedAndDeletedOnlyWhenConfirmed) {
  presetList = {{"calm", "aircraft", true}, {"torn", "calm.json: JSON: bad", false}};
  presets = presetList;
  driver.frames(2);
  clickOn("presets");
  driver.click(ScreenRect(*menu.place("preset name")));
  driver.type("my own");
  driver.frames(1);
  clickOn("save preset");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PresetRequest::Kind::save);
  EXPECT_EQ(request->name, "my own");
  EXPECT_EQ(request->group, "") << "every setting";
  request.reset();
  clickOn("load torn");
  EXPECT_FALSE(request) << "a broken one cannot be loaded";
  clickOn("load calm");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PresetRequest::Kind::load);
  EXPECT_EQ(request->name, "calm");
  request.reset();
  clickOn("delete torn");
  EXPECT_FALSE(request);
  clickOn("save preset");  // a click elsewhere is a no
  request.reset();
  clickOn("delete torn");
  EXPECT_FALSE(request);
  clickOn("delete torn");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, PresetRequest::Kind::remove);
  EXPECT_EQ(request->name, "torn");
}

TEST_F(MenuTest, valuesFromOutsideAreOneStepOrRefusedWhole) {
  const std::vector<SettingValue> values = {
      {"aircraft.mass", 900}, {"aircraft.smoke", 1}, {"weather.scale", 0.595}};
  EXPECT_THAT(menu.change(table, values), ::testing::ElementsAre("aircraft.mass", "aircraft.smoke"));
  EXPECT_EQ(settings.aircraft.mass, 900);
  const std::vector<SettingValue> bad = {{"aircraft.rollFactor", 1}, {"aircraft.mass", 0}};
  EXPECT_THROW(menu.change(table, bad), core::RangeError);
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  driver.frames(1);
  clickOn("undo");
  EXPECT_EQ(settings.aircraft.mass, 1200);
  EXPECT_FALSE(settings.aircraft.smoke);
}

std::string clipboard;  // Dear ImGui asks for plain functions

TEST_F(MenuTest, theCopyButtonsFillTheClipboard) {
  ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) { clipboard = text; };
  settings.aircraft.mass = 900.1;
  base.aircraft.smoke = true;  // the scene's: no smoke is a change of ours
  pose = "--pose=1,2,3,4,5,6";
  driver.frames(2);
  clickOn("copy");
  clickOn("copy flags");
  EXPECT_EQ(clipboard, "--set aircraft.mass=900.1 --set aircraft.smoke=false");
  clickOn("copy pose");
  EXPECT_EQ(clipboard, "--pose=1,2,3,4,5,6");
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

TEST_F(MenuTest, aSubgroupWithASectionOfItsOwnIsShownThereAlone) {
  // Its rows, its note of what was changed and its reset; the group above it has the rest.
  sections = {{"aircraft", "Aircraft", true}, {"aircraft.wing", "Wing", true}};
  settings.aircraft.mass = 2000;
  settings.aircraft.wing.span = 20;
  driver.frames(2);
  EXPECT_GT(place("aircraft.wing.span").value.top, place("aircraft.quality").value.bottom);
  EXPECT_GT(place("aircraft.wing.span").value.top, menu.place("section aircraft.wing")->top);
  clickOn("reset aircraft");
  EXPECT_NE(settings.aircraft.mass, 2000);
  EXPECT_EQ(settings.aircraft.wing.span, 20);
  clickOn("reset aircraft.wing");
  EXPECT_NE(settings.aircraft.wing.span, 20);
}

}  // namespace
}  // namespace skydrop::ui
