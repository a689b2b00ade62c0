#include "ui/menu_fixture.h"

namespace skydrop::ui {
namespace {

class MenuSearchTest : public MenuFixture {};

TEST_F(MenuSearchTest, aSearchShowsRowsOfClosedSectionsTooAndNoOthers) {
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
  search("aileron");
  EXPECT_THAT(rows(), ::testing::ElementsAre("aircraft.rollFactor")) << "another name";
  search("nothing like it");
  EXPECT_THAT(rows(), ::testing::IsEmpty());
  chord('F');
  driver.tap(app::key::kBackspace);
  EXPECT_EQ(rows().size(), 6u) << "an empty search shows the open sections";
}

TEST_F(MenuSearchTest, onlyWhatWasChangedIsShownOnRequest) {
  sections.push_back({"weather", "Weather", false});
  settings.weather.seed = 8;
  settings.aircraft.smoke = true;
  driver.frames(2);
  clickOn("changed only");
  EXPECT_THAT(rows(), ::testing::ElementsAre("aircraft.smoke", "weather.seed"));
}

TEST_F(MenuSearchTest, thePathAndAValueInTheSearchFieldSetIt) {
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

}  // namespace
}  // namespace skydrop::ui
