// The interface of the laboratory, driven by mouse and keys.
#include "skydrop/ui/lab_view.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "skydrop/lab/knobs.h"
#include "ui/interface_driver.h"

namespace skydrop::ui {
namespace {

class LabViewTest : public ::testing::Test {
 protected:
  ScreenRect place(const std::string& name) {
    const auto found = view.placeOf(name);
    EXPECT_TRUE(found) << name;
    return found.value_or(ScreenRect{});
  }
  // What all frames since the last call said.
  LabResult sum() {
    LabResult all;
    for (const LabResult& result : results) {
      if (result.chosen) all.chosen = result.chosen;
      all.changed = all.changed || result.changed;
      all.reset = all.reset || result.reset;
      all.measure = all.measure || result.measure;
      all.turnedX += result.turnedX;
      all.turnedY += result.turnedY;
      all.zoomed += result.zoomed;
    }
    results.clear();
    return all;
  }

  lab::MarchKnobs knobs;
  core::SettingsTable table{knobs};
  std::vector<LabEntry> entries = {
      {"march", "first", "First page"}, {"march", "second", "Second page"}, {"noise", "third", "Third page"}};
  std::vector<LabResult> results;
  LabView view;
  test::InterfaceDriver driver{1280, 720, [this](const Interface& context) {
                                 LabContent content{.entries = entries, .text = "Text", .table = table};
                                 results.push_back(view.draw(context, content));
                               }};
};

TEST_F(LabViewTest, aClickInTheListChoosesAPage) {
  sum();
  driver.click(place("third"));
  EXPECT_EQ(sum().chosen, std::optional<std::size_t>(2));
}

TEST_F(LabViewTest, aSliderSetsItsKnob) {
  sum();
  const ScreenRect row = place("aim");
  const float y = (row.top + row.bottom) / 2, right = row.left + 0.9f * (row.right - row.left);
  driver.click({right, y, right, y});
  EXPECT_TRUE(sum().changed);
  EXPECT_GT(knobs.aim, 0.5);
}

TEST_F(LabViewTest, theMouseTurnsAndTheWheelZooms) {
  const ScreenRect picture = place("picture");
  EXPECT_GT(picture.right - picture.left, 600);
  const float x = (picture.left + picture.right) / 2, y = (picture.top + picture.bottom) / 2;
  driver.move(x, y);
  sum();
  driver.move(x + 50, y);
  EXPECT_EQ(sum().turnedX, 0) << "without a button nothing turns";
  driver.button(x + 50, y, true);
  driver.move(x + 90, y + 20);
  const LabResult turned = sum();
  EXPECT_GT(turned.turnedX, 0);
  EXPECT_GT(turned.turnedY, 0);
  EXPECT_NEAR(turned.turnedX, 2 * turned.turnedY, 1e-4);
  driver.button(x + 90, y + 20, false);
}

TEST_F(LabViewTest, buttonsAskForResetAndMeasurement) {
  sum();
  driver.click(place("Reset"));
  EXPECT_TRUE(sum().reset);
  driver.click(place("Measure cost and error"));
  EXPECT_TRUE(sum().measure);
}

TEST_F(LabViewTest, changedKnobsAreCopiedAsWordsOfACommandLine) {
  EXPECT_EQ(knobFlags(table), "");
  knobs.stride = 0.5;
  knobs.view.distance = 3;
  EXPECT_EQ(knobFlags(table), " --set view.distance=3 --set stride=0.5");
}

}  // namespace
}  // namespace skydrop::ui
