// The interface of the noise tool, driven by mouse and keys.
#include "skydrop/ui/noise_tool_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/window/noise_tool_settings.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

class NoiseToolViewTest : public ::testing::Test {
 protected:
  ScreenRect place(const std::string& name) {
    const auto found = view.placeOf(name);
    EXPECT_TRUE(found) << name;
    return found.value_or(ScreenRect{});
  }

  app::NoiseToolSettings settings;
  core::SettingsTable table{settings};
  std::vector<NoiseToolContent::Section> sections = {{"Noise", {"noise.octaves", "noise.persistence"}}};
  bool canSave = true, canUseInSky = false;
  std::vector<NoiseToolResult> results;
  NoiseToolView view;
  test::InterfaceDriver driver{1280, 720, [this](const Interface& context) {
                                 NoiseToolContent content{table, sections};
                                 content.canSave = canSave;
                                 content.canUseInSky = canUseInSky;
                                 results.push_back(view.draw(context, content));
                               }};
};

TEST_F(NoiseToolViewTest, aSliderIsHeldAndSetWhileItMoves) {
  // Each step of the mouse changes the value before the button is let go, slow though the row is elsewhere.
  const ScreenRect row = place("noise.persistence");
  const float y = (row.top + row.bottom) / 2, width = row.right - row.left;
  driver.button(row.left + 0.25f * width, y, true);
  driver.frames(1);
  const double first = settings.noise.persistence;
  EXPECT_NEAR(first, 0.25, 0.06);
  EXPECT_TRUE(results.back().held);
  driver.move(row.left + 0.75f * width, y);
  driver.frames(1);
  EXPECT_NEAR(settings.noise.persistence, 0.75, 0.06);
  EXPECT_TRUE(results.back().held);
  driver.button(row.left + 0.75f * width, y, false);
  driver.frames(2);
  EXPECT_FALSE(results.back().held);
}

TEST_F(NoiseToolViewTest, aTypedValueOutOfRangeIsRefusedInOneLine) {
  const ScreenRect row = place("noise.octaves");
  const float x = (row.left + row.right) / 2, y = (row.top + row.bottom) / 2;
  driver.key(app::key::kLeftControl, true);
  driver.click({x, y, x, y});
  driver.key(app::key::kLeftControl, false);
  driver.frames(6);
  results.clear();
  driver.type("17");
  driver.tap(app::key::kEnter);
  driver.frames(3);
  std::string refusal;
  for (const NoiseToolResult& result : results) refusal += result.refusal.value_or("");
  EXPECT_THAT(refusal, testing::HasSubstr("'17' is out of range 1 to 16"));
  EXPECT_EQ(settings.noise.octaves, noise::NoiseSettings().octaves);
}

TEST_F(NoiseToolViewTest, buttonsGiveTheFileThatIsNamed) {
  driver.click(place("Save as DDS"));
  driver.click(place("Open"));
  std::vector<std::string> saved, opened;
  for (const NoiseToolResult& result : results) {
    if (result.save) saved.push_back(*result.save);
    if (result.open) opened.push_back(*result.open);
  }
  EXPECT_THAT(saved, testing::ElementsAre("noise.dds"));
  EXPECT_THAT(opened, testing::ElementsAre("noise.dds"));
  canSave = false;
  driver.frames(1);
  results.clear();
  driver.click(place("Save as DDS"));
  for (const NoiseToolResult& result : results) EXPECT_FALSE(result.save) << "one is being saved";
}

TEST_F(NoiseToolViewTest, theSkyIsOfferedWhereThereIsOne) {
  EXPECT_FALSE(view.placeOf("Use in the sky"));
  canUseInSky = true;
  driver.frames(1);
  driver.click(place("Use in the sky"));
  EXPECT_TRUE(std::ranges::any_of(results, [](const NoiseToolResult& result) { return result.useInSky; }));
}

}  // namespace
}  // namespace skydrop::ui
