#include <imgui.h>

#include <cmath>
#include <string>
#include <vector>

#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

class MenuRowsTest : public MenuFixture {};

constexpr int kNoDoubleClick = 40;  // frames between two presses that are two clicks

TEST_F(MenuRowsTest, everyFieldOfTheGivenSectionsHasARowAndOthersHaveNone) {
  // Only the groups that the caller names are shown, subgroups included.
  const std::vector<std::string> expected = {"aircraft.rollFactor", "aircraft.mass",    "aircraft.blades",
                                             "aircraft.smoke",      "aircraft.quality", "aircraft.wing.span"};
  for (const std::string& path : expected) EXPECT_TRUE(menu.places().contains(path)) << path;
  EXPECT_EQ(menu.places().size(), expected.size());
  EXPECT_TRUE(changed.empty()) << "drawing alone changes nothing";
}

TEST_F(MenuRowsTest, aSubgroupWithASectionOfItsOwnIsShownThereAlone) {
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

TEST_F(MenuRowsTest, aSectionMayShowMoreGroupsBelowItsOwn) {
  // Their rows come after its own, and its reset is theirs too.
  sections = {{"aircraft", "Aircraft", true, {"weather"}}};
  settings.weather.cell = 128;
  driver.frames(2);
  EXPECT_EQ(rows().size(), table.fields().size());
  EXPECT_GT(place("weather.scale").value.top, place("aircraft.wing.span").value.bottom);
  EXPECT_EQ(menu.place("section weather"), nullptr);
  clickOn("reset aircraft");
  EXPECT_EQ(settings.weather.cell, 64);
}

TEST_F(MenuRowsTest, nothingMovesTheRowsButTheUser) {
  // Refusals, errors, changed values and what the passes of a frame did come and go; every row stays where it
  // is, those below the costs included.
  core::FrameStatistics costs;
  costs.passes = {{"sky", {1.5, 1, 0, ""}}, {"clouds", {2, 0, 3, ""}}};
  costs.clock = "timer query";
  costs.terrain.chunksDrawn = 5;
  statistics = &costs;
  sections = {{"aircraft", "Aircraft", true}, {"weather", "Weather", true}};
  driver.frames(2);
  clickOn("costs");
  driver.frames(2);
  const auto tops = [this] {
    driver.frames(2);
    std::vector<float> all;
    for (const auto& [path, where] : menu.places()) all.push_back(where.value.top);
    return all;
  };
  const std::vector<float> before = tops();
  ASSERT_EQ(before.size(), table.fields().size());
  error = "assets/presets/low.json: line 3: expected a value";
  EXPECT_EQ(tops(), before) << "an error";
  error += std::string(2000, 'x');
  EXPECT_EQ(tops(), before) << "a long one";
  error.clear();
  settings.aircraft.rollFactor = 1;
  settings.weather.scale = 0.5;
  EXPECT_EQ(tops(), before) << "changed values";
  costs.passes[0].second = {0, 0, 0,
                            "the land covers the sky, for a long reason that takes more than a line"};
  costs.passes[1].second = {0, 0, 0, "no ray meets the layer"};
  costs.terrain.coarsened = 3;
  EXPECT_EQ(tops(), before) << "other passes are idle";
}

TEST_F(MenuRowsTest, aLiveSliderChangesItsValueWhileItMoves) {
  drag("aircraft.rollFactor", 0.4f, 0.75f);
  EXPECT_NEAR(settings.aircraft.rollFactor, 1.5, 0.1);  // a twentieth: the grab's own width
  EXPECT_THAT(changed, ::testing::Contains("aircraft.rollFactor"));
  drag("aircraft.rollFactor", 0.75f, 5.0f);
  EXPECT_EQ(settings.aircraft.rollFactor, 2) << "dragged past the end, it stays in range";
  release("aircraft.rollFactor", 5.0f);
}

TEST_F(MenuRowsTest, aSlowSettingWaitsUntilTheSliderIsReleased) {
  drag("aircraft.mass", 0.5f, 1.0f);
  driver.frames(5);
  EXPECT_EQ(settings.aircraft.mass, 1200);
  EXPECT_TRUE(changed.empty());
  release("aircraft.mass", 1.0f);
  EXPECT_NEAR(settings.aircraft.mass, 100000, 1e-6);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.mass"));
}

TEST_F(MenuRowsTest, aLogarithmicSliderMovesByRatios) {
  drag("aircraft.mass", 0.1f, 0.5f);
  release("aircraft.mass", 0.5f);
  // The middle of 1 .. 1e5 by ratio is 316; the grab's width moves it by less than a third of a decade.
  EXPECT_NEAR(std::log10(settings.aircraft.mass), 2.5, 0.3);
}

TEST_F(MenuRowsTest, aSliderCoversItsPartOfTheRangeAndTypingAllOfIt) {
  sections = {{"weather", "Weather", true}};
  driver.frames(2);
  drag("weather.scale", 0.3f, 5.0f);
  release("weather.scale", 5.0f);
  driver.frames(kNoDoubleClick);
  EXPECT_EQ(settings.weather.scale, 1) << "the slider's end, not the range's";
  startTyping("weather.scale");
  typeAndEnter("3.5");
  EXPECT_EQ(settings.weather.scale, 3.5);
  driver.frames(kNoDoubleClick);
  EXPECT_EQ(settings.weather.scale, 3.5) << "the slider leaves it as it was typed";
  startTyping("weather.scale");
  typeAndEnter("4.5");
  EXPECT_EQ(settings.weather.scale, 3.5) << "beyond the range it is refused";
  driver.frames(kNoDoubleClick);
  drag("weather.scale", 0.9f, -0.2f);
  release("weather.scale", -0.2f);
  EXPECT_EQ(settings.weather.scale, 0.5);
}

TEST_F(MenuRowsTest, aSliderOfPowersOfTwoStopsAtThemAlone) {
  sections = {{"weather", "Weather", true}};
  driver.frames(2);
  for (const auto& [at, value] : {std::pair(5.0f, 512.0), std::pair(-0.2f, 4.0), std::pair(0.5f, 64.0)}) {
    drag("weather.cell", 0.3f, at);
    release("weather.cell", at);
    driver.frames(kNoDoubleClick);
    EXPECT_EQ(std::exp2(std::round(std::log2(settings.weather.cell))), settings.weather.cell);
    EXPECT_TRUE(settings.weather.cell == value || (value == 64 && settings.weather.cell == 32)) << at;
  }
  startTyping("weather.cell");
  typeAndEnter("100");
  EXPECT_EQ(settings.weather.cell, 100) << "typed, it stays";
}

TEST_F(MenuRowsTest, integersFlagsAndChoicesAreEdited) {
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

TEST_F(MenuRowsTest, aRowShowsResetOnlyWhileItIsNotTheDefault) {
  EXPECT_FALSE(place("aircraft.rollFactor").reset);
  settings.aircraft.rollFactor = 1.25;
  driver.frames(1);
  ASSERT_TRUE(place("aircraft.rollFactor").reset);
  driver.click(*place("aircraft.rollFactor").reset);
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_THAT(changed, ::testing::ElementsAre("aircraft.rollFactor"));
  EXPECT_FALSE(place("aircraft.rollFactor").reset);
}

TEST_F(MenuRowsTest, aSectionIsResetByItself) {
  sections = {{"aircraft", "Aircraft", false}, {"weather", "Weather", true}};
  settings.aircraft.mass = 900;
  settings.weather.scale = 0.1;
  driver.frames(3);
  const float top = menu.place("reset weather")->top;
  clickOn("reset weather");
  EXPECT_EQ(settings.aircraft.mass, 900);
  EXPECT_EQ(settings.weather.scale, 0.595);
  changed.clear();
  driver.frames(kNoDoubleClick);
  clickOn("reset weather");
  EXPECT_TRUE(changed.empty()) << "nothing left to reset";
  EXPECT_EQ(menu.place("reset weather")->top, top) << "and it keeps its place";
}

TEST_F(MenuRowsTest, resetAllSetsEveryShownSectionAndNoOther) {
  settings.aircraft = {1, 2, 3, true, Quality::high, {4}};
  settings.weather = {0.1, 32, 8};
  driver.frames(1);
  clickOn("reset all");
  for (const core::Field& field : table.fields()) {
    EXPECT_EQ(field.isDefault(), field.group != "weather") << field.path;
  }
  EXPECT_EQ(changed.size(), 6u);
}

}  // namespace
}  // namespace skydrop::ui
