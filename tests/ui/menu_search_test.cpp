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

TEST_F(MenuSearchTest, aRowThatIsResetStaysWhileOnlyChangedOnesAreShown) {
  // Else the next row would come under the mouse, and a second click would reset that one.
  sections = {{"aircraft", "Aircraft", true}, {"weather", "Weather", true}};
  settings.aircraft.smoke = true;
  settings.aircraft.rollFactor = 1;
  settings.weather.seed = 9;
  driver.frames(2);
  clickOn("changed only");
  const ScreenRect next = place("weather.seed").value;
  driver.click(place("aircraft.rollFactor").reset.value());
  EXPECT_EQ(settings.aircraft.rollFactor, 0.75);
  EXPECT_EQ(place("weather.seed").value.top, next.top);
  clickOn("changed only");
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
  EXPECT_NE(menu.place("refusal"), nullptr) << "the line that says what is wrong";
  EXPECT_EQ(place("aircraft.rollFactor").value.top, top);
  chord('Z');
  driver.tap(app::key::kEscape);
  chord('Z');
  EXPECT_EQ(settings.aircraft.quality, Quality::medium);
}

}  // namespace
}  // namespace skydrop::ui
