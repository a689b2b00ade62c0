#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "app/studies/study.h"

namespace skydrop::app {
namespace {

// Two metrics and four rows, of which `slow` is worse than `good` in everything and `even` equals it.
StudyResult twoMetrics() {
  StudyResult result;
  result.title = "Knobs, turned";
  result.method = "A \"knob\" against itself.";
  result.metrics = {{"position error", "m"}, {"attitude error", "degrees"}};
  result.cost = {"ms a frame", "wall clock"};
  result.machine = "a machine";
  result.rows = {{"good", {0.5, 2}, 10, "default"},
                 {"slow", {0.6, 2}, 11, ""},
                 {"even", {0.5, 2}, 10, ""},
                 {"other", {0.1234567, 3}, 12, ""}};
  return result;
}

const ReportHeading kHeading = {"What it costs", "A table."};

TEST(StudyReport, aRowIsParetoOptimalUnlessAnotherIsBetterInSomethingAndWorseInNothing) {
  const StudyResult result = twoMetrics();
  std::vector<bool> optimal;
  for (const StudyRow& row : result.rows) optimal.push_back(isParetoOptimal(row, result.rows));
  EXPECT_EQ(optimal, (std::vector<bool>{true, false, true, true}));
}

TEST(StudyReport, markdownHasAColumnAMetric) {
  const std::string report = studyReport({twoMetrics()}, ReportFormat::markdown, kHeading);
  EXPECT_TRUE(report.starts_with("# What it costs\n\nA table.\n\n")) << report;
  EXPECT_TRUE(
      report.ends_with("## Knobs, turned\n\n"
                       "A \"knob\" against itself.\n\n"
                       "Timed by wall clock on a machine.\n\n"
                       "| | position error, m | attitude error, degrees | ms a frame | Pareto-optimal | |\n"
                       "|---|---|---|---|---|---|\n"
                       "| good | 0.5 | 2 | 10 | yes | default |\n"
                       "| slow | 0.6 | 2 | 11 |  |  |\n"
                       "| even | 0.5 | 2 | 10 | yes |  |\n"
                       "| other | 0.123 | 3 | 12 | yes |  |\n\n"))
      << report;
}

TEST(StudyReport, jsonHoldsEveryNumberExactly) {
  StudyResult result = twoMetrics();
  result.rows[1].errors[0] = std::numeric_limits<double>::infinity();
  const auto json = nlohmann::json::parse(studyReport({result}, ReportFormat::json, kHeading));
  EXPECT_EQ(json["schema"], 1);
  const auto& study = json["studies"].at(0);
  EXPECT_EQ(study["title"], "Knobs, turned");
  EXPECT_EQ(study["metrics"].at(1)["unit"], "degrees");
  EXPECT_EQ(study["cost"]["clock"], "wall clock");
  EXPECT_EQ(study["rows"].size(), 4u);
  EXPECT_EQ(study["rows"].at(3)["errors"].at(0), 0.1234567);
  EXPECT_EQ(study["rows"].at(0)["note"], "default");
  EXPECT_EQ(study["rows"].at(0)["paretoOptimal"], true);
  EXPECT_TRUE(study["rows"].at(1)["errors"].at(0).is_null());
}

TEST(StudyReport, csvHasALineARowAndMetricAndQuotesWhatNeedsIt) {
  StudyResult result = twoMetrics();
  result.rows.resize(1);
  result.rows[0].note = "the \"default\"";
  EXPECT_EQ(studyReport({result}, ReportFormat::csv, kHeading),
            "study,label,metric,unit,error,cost,costUnit,clock,paretoOptimal,note\r\n"
            "\"Knobs, turned\",good,position error,m,0.5,10,ms a frame,wall clock,yes,"
            "\"the \"\"default\"\"\"\r\n"
            "\"Knobs, turned\",good,attitude error,degrees,2,10,ms a frame,wall clock,yes,"
            "\"the \"\"default\"\"\"\r\n");
}

TEST(StudyReport, aTableWithoutATradeOffHasItsMetricsAndNoMore) {
  // No cost, no Pareto-optimum; what there is no value for is empty, and null in JSON. A report may begin
  // otherwise than that of accuracy.
  StudyResult result = twoMetrics();
  result.isTradeOff = false;
  result.metrics[1].unit = "";
  result.rows = {{"big", {1234567, std::numeric_limits<double>::quiet_NaN()}, 0, "off"}};
  EXPECT_EQ(studyReport({result}, ReportFormat::markdown, kHeading),
            "# What it costs\n\nA table.\n\n## Knobs, turned\n\nA \"knob\" against itself.\n\n"
            "Timed by wall clock on a machine.\n\n"
            "| | position error, m | attitude error | |\n"
            "|---|---|---|---|\n"
            "| big | 1234567 |  | off |\n\n");
  const auto json = nlohmann::json::parse(studyReport({result}, ReportFormat::json, kHeading));
  const auto& study = json["studies"].at(0);
  EXPECT_EQ(study["clock"], "wall clock");
  EXPECT_FALSE(study.contains("cost"));
  EXPECT_EQ(study["rows"].at(0)["values"].at(0), 1234567);
  EXPECT_TRUE(study["rows"].at(0)["values"].at(1).is_null());
  EXPECT_FALSE(study["rows"].at(0).contains("paretoOptimal"));
  EXPECT_EQ(studyReport({result}, ReportFormat::csv, kHeading),
            "study,label,metric,unit,error,cost,costUnit,clock,paretoOptimal,note\r\n"
            "\"Knobs, turned\",big,position error,m,1234567,,ms a frame,wall clock,,off\r\n"
            "\"Knobs, turned\",big,attitude error,,,,ms a frame,wall clock,,off\r\n");
}

}  // namespace
}  // namespace skydrop::app
