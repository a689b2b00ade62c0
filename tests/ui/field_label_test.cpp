#include "ui/field_label.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>

namespace skydrop::ui {
namespace {

TEST(FieldLabel, namesReadAsWords) {
  EXPECT_EQ(humanName("rollFactor"), "Roll factor");
  EXPECT_EQ(humanName("mass"), "Mass");
  EXPECT_EQ(humanName("inducedYawFactor"), "Induced yaw factor");
  EXPECT_EQ(humanName("errorLODPixels"), "Error LOD pixels");
  EXPECT_EQ(humanName(""), "");
}

TEST(FieldLabel, theFormatShowsTheThesisDefaultsInFullAndEscapesUnits) {
  core::Field field;
  field.sliderMin = 0;
  field.sliderMax = 100;
  field.unit = "%";
  EXPECT_EQ(sliderFormat(field), "%.5g %%");
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", 32.175);
  EXPECT_STREQ(text, "32.175");
  field.unit = "1";
  field.logarithmic = true;
  field.sliderMin = 1e-7;
  EXPECT_EQ(sliderFormat(field), "%.7g") << "Dear ImGui would take less than 1e-5 for zero";
  field.kind = core::FieldKind::integer;
  EXPECT_EQ(sliderFormat(field), "%lld");
}

TEST(FieldLabel, theTooltipHasOtherNamesBothRangesAndTheNote) {
  core::Field field;
  field.path = "clouds.scale";
  field.help = "Of the billows.";
  field.unit = "m";
  field.min = field.sliderMin = 1;
  field.max = field.sliderMax = 4;
  EXPECT_EQ(tooltipText(field),
            "Of the billows.\nRange 1 to 4 m.\nDefault 0 m.\nTakes effect at once.\nclouds.scale");
  field.sliderMax = 2;
  field.aliases = "size, frequency";
  field.note = [] { return std::string("Repeats after 3 km."); };
  EXPECT_EQ(
      tooltipText(field),
      "Of the billows.\nRepeats after 3 km.\nAlso called size, frequency.\nSlider 1 to 2 m.\nTyped 1 to 4 m."
      "\nDefault 0 m.\nTakes effect at once.\nclouds.scale");
}

TEST(FieldLabel, theTooltipWritesValuesInTheFieldsOwnForm) {
  static constexpr core::WrittenForm kDay = {
      .write = [](double value) { return "day " + std::to_string(static_cast<int>(value)); },
      .read = nullptr};
  core::Field field;
  field.kind = core::FieldKind::integer;
  field.path = "a.day";
  field.help = "When.";
  field.unit = "1";
  field.min = field.sliderMin = 1;
  field.max = field.sliderMax = 9;
  field.defaultValue = 3;
  field.written = &kDay;
  EXPECT_EQ(tooltipText(field), "When.\nRange day 1 to day 9.\nDefault day 3.\nTakes effect at once.\na.day");
}

TEST(FieldLabel, theTooltipSaysWhenAChangeTakesEffectAndWhatItRebuilds) {
  core::Field field;
  using core::TakesEffect;
  for (const auto& [effect, text] :
       {std::pair(TakesEffect::live, "\nTakes effect at once.\n"),
        std::pair(TakesEffect::liveRebuild, "\nTakes effect at once; each change rebuilds a part.\n"),
        std::pair(TakesEffect::variant, "\nCompiles a shader when released.\n"),
        std::pair(TakesEffect::rebuild, "\nRebuilds a part when released.\n"),
        std::pair(TakesEffect::restart, "\nLoads the flight again when released.\n")}) {
    field.takesEffect = effect;
    EXPECT_NE(tooltipText(field).find(text), std::string::npos) << tooltipText(field);
  }
}

}  // namespace
}  // namespace skydrop::ui
