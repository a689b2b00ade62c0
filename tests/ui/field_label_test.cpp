#include "ui/field_label.h"

#include <gtest/gtest.h>

#include <cstdio>

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

}  // namespace
}  // namespace skydrop::ui
