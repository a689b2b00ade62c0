// The runner on studies of functions whose errors and times are known.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>

#include "skydrop/accuracy/report.h"
#include "skydrop/accuracy/runner.h"
#include "skydrop/core/error.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::accuracy {
namespace {

using test::TemporaryFolder;

// The midpoint rule for the integral of exp over [0, 1] in n intervals: of order 2. Its time is n ms. A
// reference of `wrong` is off by a constant; "nan" gives a picture with one.
class Quadrature final : public Subject {
 public:
  Assignments checked(const Experiment& experiment) const override {
    for (const auto& [path, value] : valuesOf(experiment)) {
      if (path != "n" && path != "wrong" && path != "nan")
        throw core::RangeError("unknown setting '" + path + "'");
      if (path == "n" && (value < 1 || value > 4096)) throw core::RangeError("n: out of range 1 to 4096");
    }
    return experiment.set;
  }
  Observation observe(const Experiment& experiment) override {
    auto values = valuesOf(experiment);
    ++observed;
    const int n = static_cast<int>(values["n"]);
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += std::exp((i + 0.5) / n) / n;
    Observation o;
    o.values = {sum + (n >= 1000 ? values["wrong"] * n : 0), 1, 1};
    o.unit = "m";
    if (values["nan"] > 0) {
      o.width = o.height = 1;
      o.display = core::Image(1, 1);
      if (n == 2) o.values[1] = std::numeric_limits<double>::quiet_NaN();
      o.seen = {0, 0, 0};
    }
    return o;
  }
  double timeOnce(const Experiment& experiment) override {
    const auto n = static_cast<int>(valuesOf(experiment)["n"]);
    if (experiment.timed == "pass nothing") return 0;
    timed.push_back(n);
    if (failAfter > 0 && static_cast<int>(timed.size()) > failAfter) throw std::runtime_error("cut off");
    return n;
  }
  std::string clock(const Experiment&) const override { return "a clock"; }
  std::string machine() const override { return "a machine"; }

  int observed = 0, failAfter = 0;
  std::vector<int> timed;

 private:
  static std::map<std::string, double> valuesOf(const Experiment& experiment) {
    std::map<std::string, double> values;
    for (const std::string& one : experiment.set) {
      const std::size_t equals = one.find('=');
      values[one.substr(0, equals)] = std::stod(one.substr(equals + 1));
    }
    return values;
  }
};

Study studyOf(const std::string& change = "", const std::string& with = "") {
  std::string text = R"({
    "schema": 1, "title": "Midpoints", "method": "exp over [0, 1].", "subject": "quadrature",
    "set": {"wrong": 0, "nan": 0}, "cases": [{"name": "first"}, {"name": "second"}],
    "axes": [{"path": "n", "values": [2, 4, 8, 16]}],
    "reference": {"n": 1024}, "check": {"n": 2048}, "metrics": ["worst"], "timed": "cpu", "order": "n",
    "shipped": [{"name": "default", "set": {"n": 8}}]})";
  if (!change.empty()) text.replace(text.find(change), change.size(), with);
  return parseStudy(text, "midpoints.json");
}

struct Trial {
  Quadrature subject;
  RunOptions options{.quick = true};
  SubjectSource source() {
    return [this](std::string_view name) -> Subject* { return name == "quadrature" ? &subject : nullptr; };
  }
  Results results(const Study& study, const TemporaryFolder& folder, Results before = {}) {
    if (before.digest.empty())
      before.digest = digestOf({study}, options), before.allCases = study.cases.size();
    ResultWriter writer(folder.path(), std::move(before));
    accuracy::run({study}, source(), options, writer,
                  [&](const RunProgress& p) { told.push_back(progressText(p)); });
    return writer.results();
  }
  std::vector<std::string> told;
};

TEST(StudyRunner, reportsTheOrderOfAFunctionThatIsKnown) {
  // The midpoint rule is of order 2 in its step.
  const TemporaryFolder folder;
  Trial run;
  const Results results = run.results(studyOf(), folder);
  ASSERT_EQ(results.cases.size(), 2u);
  const auto orders = observedOrders(results.cases[0], 0);
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_NEAR(orders[0].order, 2, 0.01);
  EXPECT_TRUE(doubts(results.cases[0]).empty());
  EXPECT_NE(markdownReport(results).find("Observed order in steps of n: 2"), std::string::npos);
}

TEST(StudyRunner, repeatsRunInTurnsAfterAWarmUp) {
  // A round over all points before the next one, so that drift hits all alike; the first round is not kept.
  const TemporaryFolder folder;
  Trial run;
  const Results results = run.results(studyOf(), folder);
  std::vector<int> rounds;
  for (int i = 0; i < 2 * 4; ++i) rounds.insert(rounds.end(), {2, 4, 8, 16});
  EXPECT_EQ(run.subject.timed, rounds);
  for (const PointResult& point : results.cases[0].points) EXPECT_EQ(point.ms.size(), 3u);
  EXPECT_EQ(results.cases[0].points[2].medianMs(), 8);
  EXPECT_EQ(results.cases[0].points[2].shipped, std::vector<std::string>{"default"});
  EXPECT_EQ(results.cases[0].clock, "a clock");
  EXPECT_EQ((RunOptions{}.repeats()), 5);
  EXPECT_EQ(paretoFront(results.cases[0], 0), (std::vector<std::size_t>{0, 1, 2, 3}));
}

TEST(StudyRunner, aWrongReferenceIsFoundByDoublingIt) {
  // The reference is off by 1e-4 for each interval: doubling it changes it by as much again, and no row's
  // error is ten times that.
  const TemporaryFolder folder;
  Trial run;
  const Results results = run.results(studyOf("\"wrong\": 0", "\"wrong\": 1e-4"), folder);
  const auto found = doubts(results.cases[0]);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].change, 0.1024, 1e-3);
  EXPECT_NE(
      markdownReport(results).find("Not justified: doubling the reference changes largest error by 0.102"),
      std::string::npos);
}

TEST(StudyRunner, anErrorThatTheReferenceDoesNotResolveIsABound) {
  // Off by 1e-6 for each interval, the reference resolves the coarse rows alone: a tenth of the finest one's
  // error is less than what doubling changes. Such an error is shown as a bound, in all forms of the report.
  const TemporaryFolder folder;
  Trial run;
  const Results results = run.results(studyOf("\"wrong\": 0", "\"wrong\": 1e-6"), folder);
  const CaseResult& of = results.cases[0];
  EXPECT_TRUE(doubts(of).empty());
  EXPECT_FALSE(boundOf(of, 0, of.points.front()));
  const std::optional<double> bound = boundOf(of, 0, of.points.back());
  ASSERT_TRUE(bound);
  const double error = of.points.back().errors[0];
  EXPECT_NEAR(*bound, error + 2 * 1024e-6, 1e-6);
  const Results right = Trial().results(studyOf(), TemporaryFolder());
  EXPECT_LT(right.cases[0].points.back().errors[0], *bound);
  std::array<char, 32> shown{};
  std::snprintf(shown.data(), shown.size(), "| \u2264 %.3g |", *bound);
  EXPECT_NE(markdownReport(results).find(shown.data()), std::string::npos);
  EXPECT_NE(jsonReport(results).find("\"bounds\": [\n      null"), std::string::npos);
  EXPECT_EQ(markdownReport(right).find("\u2264"), std::string::npos);
}

TEST(StudyRunner, aValueThatIsNotFiniteFailsItsCaseByName) {
  // The case with a NaN in its picture ends with study, case, point and pixel; the other is measured.
  const TemporaryFolder folder;
  Trial run;
  const Results results =
      run.results(studyOf(R"({"name": "first"})", R"({"name": "first", "set": {"nan": 1}})"), folder);
  EXPECT_EQ(results.cases[0].failure, "midpoints: first, 2: the value of pixel (0, 0) is not finite");
  EXPECT_EQ(results.cases[1].failure, "");
  EXPECT_TRUE(results.cases[1].points[3].isMeasured());
}

TEST(StudyRunner, aPassThatNoFrameHasFailsItsCaseByName) {
  const TemporaryFolder folder;
  Trial run;
  const Results results = run.results(studyOf("\"timed\": \"cpu\"", "\"timed\": \"pass nothing\""), folder);
  EXPECT_NE(results.cases[0].failure.find("'pass nothing' takes no time"), std::string::npos)
      << results.cases[0].failure;
  EXPECT_TRUE(run.subject.timed.empty());
}

TEST(StudyRunner, goesOnWhereItWasCutOff) {
  // A run that ends within its repeats keeps what it has; the next one measures only the rest, and the errors
  // are those of a run at one go, bit for bit.
  const TemporaryFolder folder, whole;
  Trial cut;
  cut.subject.failAfter = 22;
  EXPECT_THROW(cut.results(studyOf(), folder), std::runtime_error);
  Trial rest;
  const Results before = readResults(folder.path());
  EXPECT_EQ(before.cases.size(), 2u);
  const Results results = rest.results(studyOf(), folder, before);
  Trial once;
  const Results all = once.results(studyOf(), whole);
  ASSERT_EQ(results.cases.size(), all.cases.size());
  for (std::size_t c = 0; c < 2; ++c) {
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(results.cases[c].points[i].errors, all.cases[c].points[i].errors);
      EXPECT_EQ(results.cases[c].points[i].ms.size(), 3u);
    }
  }
  EXPECT_LT(rest.subject.observed, once.subject.observed / 2);
  EXPECT_EQ(resultText(readResults(folder.path())), resultText(results));
}

TEST(StudyRunner, sharesAreDisjointAndMergeToTheWhole) {
  const TemporaryFolder one, two, whole, merged;
  Trial first, second, once;
  first.options.part = {1, 2};
  second.options.part = {2, 2};
  EXPECT_EQ(first.results(studyOf(), one).cases.size(), 1u);
  EXPECT_EQ(second.results(studyOf(), two).cases.size(), 1u);
  const Results all = once.results(studyOf(), whole);
  const Results joined = mergeResults({two.path(), one.path()}, merged.path());
  EXPECT_EQ(csvReport(joined), csvReport(all));
  EXPECT_THROW(mergeResults({one.path(), one.path()}, {}), core::DataError);
}

TEST(StudyRunner, tellsHowMuchIsLeft) {
  EXPECT_EQ(progressText({"clouds, from below", 12, 40, 83.2}), "clouds, from below: 12 of 40, 1:24 left");
  EXPECT_EQ(progressText({"clouds, from below", 0, 40, 0}), "clouds, from below: 0 of 40");
  const TemporaryFolder folder;
  Trial run;
  run.results(studyOf(), folder);
  EXPECT_EQ(run.told.front(), "midpoints, first: 0 of 36");
  EXPECT_EQ(run.told.back(), "midpoints, second: 36 of 36");
}

std::string refusalOf(const Study& study) {
  Trial run;
  return test::refusalOf<core::DataError>([&] { requireRunnable({study}, run.source(), run.options); });
}

TEST(StudyRunner, refusesBeforeAnythingIsMeasured) {
  EXPECT_EQ(refusalOf(studyOf()), "");
  EXPECT_EQ(refusalOf(studyOf("\"quadrature\"", "\"quadratur\"")),
            "midpoints.json: subject: there is no subject 'quadratur'");
  EXPECT_EQ(refusalOf(studyOf("\"wrong\"", "\"wring\"")), "midpoints.json: '2': unknown setting 'wring'");
  EXPECT_EQ(refusalOf(studyOf("[2, 4, 8, 16]", "[2, 5000]")),
            "midpoints.json: '5000': n: out of range 1 to 4096");
  EXPECT_EQ(refusalOf(studyOf("[2, 4, 8, 16]", "[2, 1024]")),
            "midpoints.json: reference: is the point '1024' itself");
  EXPECT_EQ(refusalOf(studyOf("\"check\": {\"n\": 2048}", "\"check\": {\"n\": 1024}")),
            "midpoints.json: check: sets what the reference has: nothing is doubled");
}

}  // namespace
}  // namespace skydrop::accuracy
