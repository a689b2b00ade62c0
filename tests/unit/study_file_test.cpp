#include <gtest/gtest.h>

#include "skydrop/accuracy/result_file.h"
#include "skydrop/accuracy/study.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"

namespace skydrop::accuracy {
namespace {

const std::string kStudy =
    R"({"schema": 1, "title": "T", "method": "M", "subject": "picture", "scene": "fair",
 "cases": [{"name": "a", "pose": [1, 2, 3, 4, 5, 6]}, {"name": "b", "scene": "dome", "set": {"x.y": true}}],
 "axes": [{"path": "tier", "values": ["low", "high"]}, {"path": "rate", "values": [10, 20], "unit": "Hz"}],
 "reference": {"rate": 640}, "check": {"rate": 1280}, "metrics": ["flip", {"name": "bias", "floor": 1e-6}],
 "timed": "pass clouds", "order": "rate"})";

std::string changed(const std::string& what, const std::string& with) {
  std::string text = kStudy;
  text.replace(text.find(what), what.size(), with);
  return text;
}

std::string refusalOf(const std::string& text) {
  return test::refusalOf<core::DataError>([&] { parseStudy(text, "s.json"); });
}

TEST(StudyFile, isReadAsItStands) {
  const Study study = parseStudy(kStudy, "folder/my-study.json");
  EXPECT_EQ(study.name, "my-study");
  EXPECT_EQ(study.cases[0].scene, "fair");
  EXPECT_EQ((*study.cases[0].pose)[5], 6);
  EXPECT_EQ(study.cases[1].scene, "dome");
  EXPECT_EQ(study.cases[1].set, Assignments{"x.y=true"});
  ASSERT_EQ(study.points.size(), 4u);
  EXPECT_EQ(study.points[1].label, "low, 20 Hz");
  EXPECT_EQ(study.points[1].series, "low");
  EXPECT_EQ(study.points[1].set, (Assignments{"tier=low", "rate=20"}));
  EXPECT_DOUBLE_EQ(study.points[1].step.value(), 1.0 / 20) << "the reference has more: a rate";
  EXPECT_EQ(study.metrics[1].floor, 1e-6);
}

TEST(StudyFile, aFlightBeginsAtItsPose) {
  const std::string flown =
      changed("\"pose\": [1, 2, 3, 4, 5, 6]", "\"pose\": [1, 2, 3, 4, 5, 6], \"flight\": {\"frames\": 60}");
  const Study study = parseStudy(flown, "s.json");
  ASSERT_TRUE(study.cases[0].flight);
  EXPECT_EQ(study.cases[0].flight->frames, 60);
  EXPECT_EQ(study.cases[0].flight->speedMps, 70);
  EXPECT_EQ(refusalOf(changed("\"scene\": \"dome\"", "\"flight\": {}")),
            "s.json: cases.1.flight: needs a pose to begin at");
  EXPECT_EQ(refusalOf(changed("[1, 2, 3, 4, 5, 6]", "[1, 2, 3, 4, 5, 6], \"flight\": {\"frames\": 1.5}")),
            "s.json: cases.0.flight.frames: is not a whole number");
}

TEST(StudyFlight, isStraightWithoutBankAndACircleWithIt) {
  // After a second straight on it is as far as the speed says. With 60 degrees of bank the circle
  // has the radius v^2 / (g tan 60); half of it later the camera looks back from the other side.
  const std::array<double, 6> pose = {100, 900, -50, 40, 8, 0};
  const std::array<double, 6> straight = flownPose(pose, {70, 0, 24}, 60);
  EXPECT_NEAR(std::hypot(straight[0] - pose[0], straight[2] - pose[2]), 70, 1e-9);
  EXPECT_NEAR(straight[2] - pose[2], 70 * std::sin(40 * M_PI / 180), 1e-9) << "yaw grows from +x to +z";
  const int halfTurn = 600;  // frames
  const double speed = 9.81 * std::tan(M_PI / 3) * halfTurn / kFlightFramesPerSecond / M_PI;
  const double radius = speed * speed / (9.81 * std::tan(M_PI / 3));
  const std::array<double, 6> across = flownPose(pose, {speed, 60, 24}, halfTurn);
  EXPECT_NEAR(std::hypot(across[0] - pose[0], across[2] - pose[2]), 2 * radius, 1e-6);
  EXPECT_NEAR(across[3], pose[3] + 180, 1e-9);
  EXPECT_EQ(across[1], pose[1]);
  EXPECT_EQ(across[5], 60);
}

TEST(StudyFile, aLaterAssignmentOfAPathReplacesAnEarlierOne) {
  EXPECT_EQ(merged({"a=1", "b=2"}, {"a=3", "c=4"}), (Assignments{"b=2", "a=3", "c=4"}));
}

TEST(StudyFile, whatIsWrongIsNamedInOneLine) {
  EXPECT_EQ(refusalOf(kStudy), "");
  EXPECT_EQ(refusalOf(changed("\"schema\": 1", "\"schema\": 2")), "s.json: schema: is not 1");
  EXPECT_EQ(refusalOf(changed("\"title\"", "\"titel\"")), "s.json: titel: unknown member");
  EXPECT_EQ(refusalOf(changed("\"flip\"", "\"flop\"")),
            "s.json: metrics.0: unknown metric 'flop'; the nearest are 'flip', 'relativeRmse' and "
            "'relativeEnergy'");
  EXPECT_EQ(refusalOf(changed("[10, 20]", "[10, 10]")), "s.json: points: 'low, 10 Hz' is there twice");
  EXPECT_EQ(refusalOf(changed("[10, 20]", "[]")),
            "s.json: axes.1.values: is not a list with something in it");
  EXPECT_EQ(refusalOf(changed("[10, 20]", "[null]")), "s.json: axes.1.values: is no number, flag or name");
  EXPECT_EQ(refusalOf(changed("{\"rate\": 1280}", "{}")),
            "s.json: check: sets nothing: the reference has to be doubled");
  EXPECT_EQ(refusalOf(changed("pass clouds", "clouds")),
            "s.json: timed: 'clouds' is not one of frame, cpu and pass NAME");
  EXPECT_EQ(refusalOf(changed("[1, 2, 3, 4, 5, 6]", "[1, 2, 3]")),
            "s.json: cases.0.pose: is not a list of six numbers");
  EXPECT_EQ(refusalOf(changed("\"order\": \"rate\"", "\"order\": \"fps\"")),
            "s.json: order: is the path of none of the axes");
  EXPECT_EQ(refusalOf(changed("\"name\": \"b\"", "\"name\": \"a\"")), "s.json: cases: 'a' is there twice");
  EXPECT_EQ(refusalOf(changed("\"name\": \"b\"", "\"name\": \"b/c\"")),
            "s.json: cases.1.name: holds a slash");
}

Results oneCase() {
  Results results;
  results.program = "skydrop 1", results.digest = "d", results.allCases = 1;
  CaseResult of;
  of.study = "s", of.name = "a", of.title = "T \"<\"", of.method = "M", of.machine = "m", of.clock = "c";
  of.metrics = {{"rmse", "RMSE", "m", 0}};
  of.references = {{"n=9", {1e-9}, "pictures/s-a-reference0.png"}};
  PointResult point;
  point.label = "p", point.set = {"n=1"}, point.errors = {0.1}, point.ms = {1.0 / 3, 2};
  of.points = {point};
  results.cases = {of};
  return results;
}

TEST(ResultFile, comesBackToTheSameBits) {
  const std::string text = resultText(oneCase());
  const Results back = parseResults(text, "r");
  EXPECT_EQ(resultText(back), text);
  EXPECT_EQ(back.cases[0].points[0].ms[0], 1.0 / 3);
}

TEST(ResultFile, aLastLineThatWasCutOffIsLeftOut) {
  const std::string text = resultText(oneCase());
  bool cutOff = false;
  const Results back = parseResults(text.substr(0, text.size() - 7), "r", &cutOff);
  EXPECT_TRUE(cutOff);
  EXPECT_EQ(back.cases[0].points[0].ms.size(), 1u);
  EXPECT_FALSE((parseResults(text, "r", &cutOff), cutOff));
}

TEST(ResultFile, damageIsNamedByItsLine) {
  const std::string text = resultText(oneCase());
  const auto refusal = [](const std::string& damaged) {
    return test::refusalOf<core::DataError>([&] { parseResults(damaged, "r"); });
  };
  const auto with = [&](const std::string& what, const std::string& by) {
    std::string damaged = text;
    return damaged.replace(damaged.find(what), what.size(), by);
  };
  EXPECT_EQ(refusal(""), "r: line 1: the head is missing");
  EXPECT_EQ(refusal(with("{\"line\":\"head\"", "\"head\"")), "r: line 1: is damaged: no whole line of JSON");
  EXPECT_EQ(refusal(with("\"schema\":1", "\"schema\":7")), "r: line 1: schema: is not 1");
  EXPECT_EQ(refusal(with("\"reference\":0,\"changes\"", "\"reference\":9,\"changes\"")),
            "r: line 3: reference: is out of range");
  EXPECT_EQ(refusal(with("\"errors\":[0.1]", "\"errors\":[0.1,2]")),
            "r: line 5: errors: has not one number a metric");
  EXPECT_EQ(refusal(with("pictures/s-a-reference0.png", "/etc/passwd")),
            "r: picture: '/etc/passwd' is not in the folder pictures");
  EXPECT_EQ(refusal(with("\"line\":\"clock\"", "\"line\":\"klock\"")),
            "r: line 4: line: unknown kind 'klock'");
}

}  // namespace
}  // namespace skydrop::accuracy
