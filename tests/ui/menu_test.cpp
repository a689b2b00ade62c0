#include <imgui.h>

#include <utility>
#include <vector>

#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

class MenuTest : public MenuFixture {};

TEST_F(MenuTest, whatIsOpenAndWhereTheMenuStandsIsRemembered) {
  sections.push_back({"weather", "Weather", false});
  driver.frames(2);
  clickOn("section aircraft");
  clickOn("section weather");
  EXPECT_THAT(rows(), ::testing::ElementsAre("weather.cell", "weather.scale", "weather.seed"));
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
  EXPECT_EQ(place("aircraft.rollFactor").value.top, firstRow) << "its place was kept free";
  ASSERT_NE(menu.place("refusal"), nullptr);
  EXPECT_LE(menu.place("refusal")->bottom, firstRow);
  EXPECT_GT(driver.drawData()->TotalVtxCount, plain);
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

}  // namespace
}  // namespace skydrop::ui
