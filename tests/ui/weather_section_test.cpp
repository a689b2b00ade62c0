// The weather's page: skies as buttons and a picture for each genus, in small windows and large ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "app/session/effect_table.h"
#include "app/settings/settings.h"
#include "app/window/genus_buttons.h"
#include "skydrop/ui/menu.h"
#include "skydrop/weather/usual_layer.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

struct Window {
  int width, height;
};

class WeatherSectionTest : public testing::TestWithParam<Window> {
 protected:
  WeatherSectionTest()
      : driver(GetParam().width, GetParam().height, [this](const Interface& context) {
          MenuContent content{table, sections};
          content.tools.genera = genera;
          const MenuResult result = menu.draw(context, content);
          changed.insert(result.changedPaths.begin(), result.changedPaths.end());
        }) {
    MenuState state;
    state.open["weather"] = true;
    menu.setState(state);
    driver.frames(2);
  }

  void clickOn(const std::string& what) {
    ASSERT_NE(menu.place(what), nullptr) << what;
    changed.clear();
    driver.click(ScreenRect(*menu.place(what)));
    driver.frames(2);
  }
  const weather::SiteSettings& site() const { return settings.weather.sites[0]; }

  app::Settings settings;
  core::SettingsTable table{settings};
  std::vector<GenusButton> genera = app::genusButtons();
  std::vector<MenuSection> sections = [] {
    scene::EffectSet effects;
    effects.insert(scene::Effect::weather);
    std::vector<MenuSection> ofWeather;
    for (MenuSection& section : app::menuSections(effects)) {
      if (section.head == MenuSection::Head::weather) ofWeather.push_back(std::move(section));
    }
    return ofWeather;
  }();
  std::set<std::string> changed;
  ConfigurationMenu menu;
  test::InterfaceDriver driver;  // last: its constructor draws
};

TEST_P(WeatherSectionTest, thereIsAPictureForEachGenusAndAButtonForEachSky) {
  // Within the menu and apart from each other.
  std::vector<ScreenRect> places;
  const auto add = [&](const std::string& name) {
    const ScreenRect* place = menu.place(name);
    ASSERT_NE(place, nullptr) << name;
    EXPECT_GE(place->left, menu.place().left) << name;
    EXPECT_LE(place->right, menu.place().right) << name;
    for (const ScreenRect& other : places) {
      EXPECT_TRUE(place->left >= other.right || place->top >= other.bottom || place->right <= other.left ||
                  place->bottom <= other.top)
          << name;
    }
    places.push_back(*place);
  };
  for (const std::string_view genus : weather::kGenusNames) add("genus " + std::string(genus));
  for (std::size_t i = 1; i < weather::kSkyChoiceNames.size(); ++i)
    add("mood " + std::string(weather::kSkyChoiceNames[i]));
  EXPECT_EQ(places.size(), 15u);
}

INSTANTIATE_TEST_SUITE_P(Windows, WeatherSectionTest,
                         testing::Values(Window{640, 360}, Window{1280, 720}, Window{3840, 2160}),
                         [](const auto& window) { return "of" + std::to_string(window.param.width); });

using WeatherClickTest = WeatherSectionTest;
INSTANTIATE_TEST_SUITE_P(Windows, WeatherClickTest, testing::Values(Window{1280, 720}, Window{3840, 2160}),
                         [](const auto& window) { return "of" + std::to_string(window.param.width); });

TEST_P(WeatherClickTest, aPictureSetsItsLayerInOneStepAndAnotherClickTakesTheCloudsAway) {
  for (std::size_t i = 0; i < weather::kGenusNames.size(); ++i) {
    const auto genus = static_cast<weather::Genus>(i);
    const weather::Layer usual = weather::usualLayer(genus);
    const weather::WeatherLayerSettings& layer = site().layers[weather::usualPlace(genus)];
    const std::string name = "genus " + std::string(weather::kGenusNames[i]);
    const auto before = layer;
    clickOn(name);
    EXPECT_EQ(layer.genus, genus);
    EXPECT_EQ(layer.base, usual.baseM);
    EXPECT_EQ(layer.top, usual.topM);
    EXPECT_EQ(layer.cover, usual.cover);
    EXPECT_NO_THROW(weather::requireUsable(settings.weather)) << name;
    EXPECT_EQ(settings.clouds, clouds::CloudSettings()) << "would count twice: " << name;
    clickOn("undo");
    EXPECT_EQ(layer.genus, before.genus) << name;
    EXPECT_EQ(layer.top, before.top) << name;
    clickOn("redo");
    EXPECT_EQ(layer.genus, genus) << name;
    clickOn(name);
    EXPECT_EQ(layer.cover, 0) << name;
  }
}

TEST_P(WeatherClickTest, aSkyIsPickedByAClickAndLeftByAnother) {
  clickOn("mood thunderstorm");
  EXPECT_EQ(settings.weather.sky, weather::SkyChoice::thunderstorm);
  EXPECT_TRUE(changed.contains("weather.sky"));
  clickOn("mood fair");
  EXPECT_EQ(settings.weather.sky, weather::SkyChoice::fair);
  clickOn("mood fair");
  EXPECT_EQ(settings.weather.sky, weather::SkyChoice::none);
}

}  // namespace
}  // namespace skydrop::ui
