#include "app/studies/cost_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace skydrop::app {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

CostTable twoColumns() {
  CostTable table;
  table.title = "Knobs, turned";
  table.method = "A \"knob\" against itself.";
  table.columns = {{"frame without it", "ms"}, {"draws", ""}};
  table.clock = "wall clock";
  table.machine = "a machine";
  table.rows = {
      {"good", {0.5, 2}, "default"}, {"other", {0.1234567, 3}, ""}, {"big", {1234567, kNone}, "off"}};
  return table;
}

const ReportHeading kHeading = {"What it costs", "A table."};

TEST(CostTable, markdownHasItsColumnsAndWhatThereIsNoValueForIsEmpty) {
  EXPECT_EQ(reportOf({twoColumns()}, ReportFormat::markdown, kHeading),
            "# What it costs\n\nA table.\n\n## Knobs, turned\n\nA \"knob\" against itself.\n\n"
            "Timed by wall clock on a machine.\n\n"
            "| | frame without it, ms | draws | |\n"
            "|---|---|---|---|\n"
            "| good | 0.5 | 2 | default |\n"
            "| other | 0.123 | 3 |  |\n"
            "| big | 1234567 |  | off |\n\n");
}

TEST(CostTable, jsonHoldsEveryNumberExactly) {
  CostTable table = twoColumns();
  table.rows[0].values[0] = std::numeric_limits<double>::infinity();
  const auto json = nlohmann::json::parse(reportOf({table}, ReportFormat::json, kHeading));
  EXPECT_EQ(json["schema"], 1);
  const auto& study = json["studies"].at(0);
  EXPECT_EQ(study["title"], "Knobs, turned");
  EXPECT_EQ(study["metrics"].at(0)["unit"], "ms");
  EXPECT_EQ(study["clock"], "wall clock");
  EXPECT_EQ(study["rows"].size(), 3u);
  EXPECT_TRUE(study["rows"].at(0)["values"].at(0).is_null());
  EXPECT_EQ(study["rows"].at(1)["values"].at(0), 0.1234567);
  EXPECT_EQ(study["rows"].at(2)["values"].at(0), 1234567);
  EXPECT_TRUE(study["rows"].at(2)["values"].at(1).is_null());
  EXPECT_EQ(study["rows"].at(0)["note"], "default");
}

TEST(CostTable, csvHasALineARowAndColumnAndQuotesWhatNeedsIt) {
  CostTable table = twoColumns();
  table.rows = {{"good", {0.5, 2}, "the \"default\""}, {"big", {1234567, kNone}, "off"}};
  EXPECT_EQ(reportOf({table}, ReportFormat::csv, kHeading),
            "study,label,metric,unit,error,cost,costUnit,clock,paretoOptimal,note\r\n"
            "\"Knobs, turned\",good,frame without it,ms,0.5,,,wall clock,,\"the \"\"default\"\"\"\r\n"
            "\"Knobs, turned\",good,draws,,2,,,wall clock,,\"the \"\"default\"\"\"\r\n"
            "\"Knobs, turned\",big,frame without it,ms,1234567,,,wall clock,,off\r\n"
            "\"Knobs, turned\",big,draws,,,,,wall clock,,off\r\n");
}

}  // namespace
}  // namespace skydrop::app
