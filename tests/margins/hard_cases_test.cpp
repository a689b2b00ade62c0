// The record of the hard cases (assets/stability/hard_cases.json, docs/hard-cases.md) against what the suites
// of this build measured. ctest runs it after them; by hand it takes whatever figures lie in tests/margins of
// the build.
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "app/measure/system_info.h"
#include "app/types/version.h"
#include "skydrop/core/file.h"
#include "skydrop/stability/hard_case_report.h"
#include "support/margin.h"
#include "support/paths.h"

namespace skydrop {
namespace {

namespace fs = std::filesystem;
using stability::HardCase, stability::HardCaseRecord, stability::HeldFigure;

// A figure of a test of this build.
struct Figure {
  HeldFigure held;
  bool isFixed = true;  // the limit does not depend on what is measured
};
using FiguresOfRows = std::map<std::string, std::vector<Figure>>;

fs::path inSource(const char* path) { return fs::path(test::sourceDir()) / path; }

nlohmann::json listedCases() {
  return nlohmann::json::parse(core::readTextFile(inSource("tests/stability/cases.json")))["cases"];
}

// "Suite.name" of all tests in the sources: files of tests that were renamed since are left over in the
// build.
std::set<std::string> testsInSources() {
  std::set<std::string> names;
  const std::regex test(R"(TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\))");
  for (const auto& entry : fs::recursive_directory_iterator(inSource("tests"))) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = core::readTextFile(entry.path());
    for (std::sregex_iterator i(text.begin(), text.end(), test), end; i != end; ++i)
      names.insert((*i)[1].str() + "." + (*i)[2].str());
  }
  return names;
}

FiguresOfRows measuredFigures() {
  FiguresOfRows all;
  const std::set<std::string> tests = testsInSources();
  if (!fs::exists(test::marginFolder())) return all;
  for (const auto& entry : fs::directory_iterator(test::marginFolder())) {
    const nlohmann::json file = nlohmann::json::parse(core::readTextFile(entry.path()));
    const std::string test = file["test"];
    // "Instance/Suite.name/3"
    const std::string plain = std::regex_replace(test, std::regex("^[^./]*/(?=[^.]*\\.)|/[^./]*$"), "");
    if (!tests.contains(plain)) continue;
    for (const nlohmann::json& of : file["figures"]) {
      Figure figure;
      figure.held.test = plain;
      figure.held.unit = of["unit"];
      figure.held.figure =
          of["figure"].is_null() ? std::numeric_limits<double>::quiet_NaN() : of["figure"].get<double>();
      figure.held.limit = {stability::senseOf(of["sense"].get<std::string>()).value(), of["limit"]};
      figure.isFixed = of["isFixed"];
      all[of["id"]].push_back(figure);
    }
  }
  return all;
}

// What has the least margin; what is exact only where nothing else is measured.
HeldFigure tightestOf(const std::vector<Figure>& figures) {
  const auto rank = [](const Figure& of) {
    return std::pair(of.held.limit.sense == stability::Sense::none && of.held.figure == 0, of.held.margin());
  };
  return std::ranges::min_element(figures, {}, rank)->held;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16];
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

HardCaseRecord recordOf(const FiguresOfRows& measured) {
  HardCaseRecord record;
  record.program = app::programName();
  record.machine = app::machineName();
  record.renderer = "llvmpipe (Mesa)";
  record.date = today();
  for (const nlohmann::json& listed : listedCases()) {
    HardCase row{listed["id"],
                 listed["area"],
                 listed["input"],
                 listed["mustHold"],
                 listed.value("reason", listed.value("because", "")),
                 std::nullopt,
                 0};
    if (const auto found = measured.find(row.id); found != measured.end()) {
      row.held = tightestOf(found->second);
      row.figures = static_cast<int>(found->second.size());
    }
    record.cases.push_back(std::move(row));
  }
  return record;
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  core::writeFileAtomically(file, text);
}

// All pages of a record, beside each other: the page that docs has, a page for a browser, and for programs.
void writePages(const HardCaseRecord& record, const fs::path& folder) {
  const stability::HardCaseReport report{record, {}, record.program, record.machine};
  write(folder / "hard-cases.md", stability::markdownTable(report));
  write(folder / "hard-cases.html", stability::htmlTable(report));
  write(folder / "hard-cases.json", stability::jsonTable(report));
}

TEST(HardCaseMargins, everyRowHasAFigureAndAMarginOfTwoOrAReason) {
  // One line a row that lacks something. SKYDROP_UPDATE_HARD_CASES=1 then writes the record and its page.
  const FiguresOfRows measured = measuredFigures();
  ASSERT_FALSE(measured.empty()) << "no figures in " << test::marginFolder()
                                 << ": run the suites of this build first (ctest)";
  for (const nlohmann::json& listed : listedCases()) {
    const std::string id = listed["id"];
    if (listed["status"] == "absent") continue;
    const auto found = measured.find(id);
    if (found == measured.end()) {
      ADD_FAILURE() << id << ": no test of this row gave a figure: call test::holds(\"" << id
                    << "\", ...) or test::noFaults(\"" << id << "\", ...) (tests/support/margin.h)";
      continue;
    }
    const HeldFigure held = tightestOf(found->second);
    const double margin = held.margin();
    EXPECT_GE(margin, 1) << id << ": " << held.test << " gave " << held.figure << ' ' << held.unit
                         << ", beyond its limit of " << held.limit.value;
    if (margin < stability::kWantedMargin) {
      EXPECT_NE(listed.value("reason", ""), "")
          << id << ": margin " << margin << " (" << held.figure << " of " << held.limit.value << ' '
          << held.unit << ", " << held.test
          << "): better it, or give the row a \"reason\" in tests/stability/cases.json";
    }
  }
  const HardCaseRecord record = recordOf(measured);
  writePages(record, fs::path(test::binaryDir()) / "artifacts");
  if (std::getenv("SKYDROP_UPDATE_HARD_CASES") && !HasFailure()) {
    write(inSource("assets/stability/hard_cases.json"), stability::hardCasesText(record));
    write(inSource("docs/hard-cases.md"),
          stability::markdownTable({record, {}, record.program, record.machine}));
  }
}

TEST(HardCaseMargins, theRecordIsOfTheseRowsAndLimits) {
  // Texts and reasons are those of the list; what a row is held by is what its tests assert, unit and limit
  // (where that does not depend on what is measured). Digits of figures may differ: machines, drivers and
  // times do.
  const FiguresOfRows measured = measuredFigures();
  const HardCaseRecord now = recordOf(measured), kept = stability::loadHardCases();
  const char* hint = ": SKYDROP_UPDATE_HARD_CASES=1 writes it anew (docs/contributing.md)";
  ASSERT_EQ(now.cases.size(), kept.cases.size()) << "rows of assets/stability/hard_cases.json" << hint;
  for (std::size_t i = 0; i < now.cases.size(); ++i) {
    const HardCase &a = now.cases[i], &b = kept.cases[i];
    EXPECT_TRUE(a.id == b.id && a.area == b.area && a.input == b.input && a.mustHold == b.mustHold &&
                a.reason == b.reason)
        << a.id << ": the record has other words" << hint;
    if (!a.held || !b.held) {
      EXPECT_EQ(a.held.has_value(), b.held.has_value()) << a.id << hint;
      continue;
    }
    const bool isAsserted = std::ranges::any_of(measured.at(a.id), [&](const Figure& of) {
      return of.held.unit == b.held->unit && of.held.limit.sense == b.held->limit.sense &&
             of.held.test == b.held->test && (!of.isFixed || of.held.limit.value == b.held->limit.value);
    });
    EXPECT_TRUE(isAsserted) << b.id << ": no test asserts " << b.held->limit.value << ' ' << b.held->unit
                            << " as the record says" << hint;
  }
}

TEST(HardCaseMargins, thePageIsThatOfTheRecord) {
  // docs/hard-cases.md is made of the record that the program ships, and read back the record is the same.
  const HardCaseRecord kept = stability::loadHardCases();
  EXPECT_EQ(core::readTextFile(inSource("docs/hard-cases.md")),
            stability::markdownTable({kept, {}, kept.program, kept.machine}));
  EXPECT_EQ(stability::hardCasesText(stability::parseHardCases(stability::hardCasesText(kept), "a.json")),
            core::readTextFile(inSource("assets/stability/hard_cases.json")));
}

}  // namespace
}  // namespace skydrop
