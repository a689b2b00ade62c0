#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/studies/cost_study.h"
#include "app/studies/subjects.h"
#include "app/types/version.h"
#include "skydrop/accuracy/report.h"
#include "skydrop/accuracy/result_file.h"
#include "skydrop/accuracy/runner.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {
namespace {

namespace fs = std::filesystem;
using core::UsageError;

constexpr Size kQuickSize{160, 90}, kDefaultSize{320, 180};
constexpr int kLargestPicture = 1024;  // of judge, whose pixels take .01 s of a core each
constexpr const char* kCost = "cost";
constexpr const char* kCalibrate = "calibrate";
constexpr const char* kJudge = "judge";
constexpr const char* kStability = "stability";

void refuseWith(bool given, const std::string& flag, const std::string& with) {
  if (given) throw UsageError("accuracy: " + flag + " does not go with " + with);
}

int costReport(const CommandLine& line) {
  if (line.studies.size() > 1)
    throw UsageError("accuracy: cost is measured by itself, without other studies");
  refuseWith(line.resume, "--resume", "cost");
  refuseWith(line.parts > 1, "--part", "cost");
  refuseWith(line.size.has_value(), "--size", "cost");
  for (const std::string& scene : line.scenes)
    scene::loadScene(scene);  // refused before anything is measured
  const std::string path = line.out.empty() ? "accuracy.md" : line.out;
  core::OutputFile out = openOutput(path).value();
  Progress progress("accuracy", line.progress);
  const std::vector<CostTable> tables =
      costStudy({line.scenes, line.quick}, [&](std::size_t done, std::size_t all) {
        progress.show("cost, " + std::to_string(done) + " of " + std::to_string(all));
      });
  progress.clear();
  out.write(reportOf(tables, line.reportFormat, kCostHeading));
  if (!out.isStandardOutput()) print("%s\n", path.c_str());
  return 0;
}

int calibrate(const CommandLine& line) {
  if (line.studies.size() > 1)
    throw UsageError("accuracy: calibrate is done by itself, without other studies");
  if (line.scenes.size() > 1) throw UsageError("accuracy: calibrate takes one --scene");
  refuseWith(line.resume, "--resume", "calibrate");
  refuseWith(line.parts > 1, "--part", "calibrate");
  refuseWith(!line.merge.empty(), "--merge", "calibrate");
  refuseWith(line.quick, "--quick", "calibrate");
  refuseWith(!line.out.empty(), "--out", "calibrate, whose results belong to the cache folder");
  return calibrateBudget(line);
}

int judge(const CommandLine& line) {
  if (line.studies.size() > 1) throw UsageError("accuracy: judge is done by itself, without other studies");
  refuseWith(line.resume, "--resume", "judge");
  refuseWith(line.parts > 1, "--part", "judge");
  refuseWith(!line.merge.empty(), "--merge", "judge");
  if (line.size && std::max(line.size->width, line.size->height) > kLargestPicture)
    throw UsageError("accuracy: judge draws pictures of at most " + std::to_string(kLargestPicture) +
                     " a side");
  return judgeLight(line);
}

int stabilityTable(const CommandLine& line) {
  if (line.studies.size() > 1) throw UsageError("accuracy: stability is printed by itself, without studies");
  refuseWith(!line.scenes.empty(), "--scene", "stability");
  refuseWith(line.resume, "--resume", "stability");
  refuseWith(line.parts > 1, "--part", "stability");
  refuseWith(!line.merge.empty(), "--merge", "stability");
  refuseWith(line.quick, "--quick", "stability");
  refuseWith(line.size.has_value(), "--size", "stability");
  return printStability(line);
}

// Writes the report; a line for each case that failed, or whose reference is not justified, and then 1.
int finish(const accuracy::Results& results, const fs::path& folder) {
  for (const fs::path& file : accuracy::writeReport(results, folder)) print("%s\n", file.c_str());
  bool isWhole = true;
  for (const accuracy::CaseResult& of : results.cases) {
    if (!of.failure.empty()) warn("accuracy: " + of.id() + " failed: " + of.failure);
    const std::vector<accuracy::Doubt> doubts = accuracy::doubts(of);
    for (const accuracy::Doubt& doubt : doubts)
      warn("accuracy: " + of.id() + ": " + accuracy::doubtText(of, doubt));
    isWhole = isWhole && of.failure.empty() && doubts.empty();
  }
  return isWhole ? 0 : 1;
}

int mergeReport(const CommandLine& line, const fs::path& folder) {
  refuseWith(!line.studies.empty(), "a study", "--merge");
  refuseWith(line.resume, "--resume", "--merge");
  refuseWith(line.parts > 1, "--part", "--merge");
  core::requireFolder(folder);
  const accuracy::Results results = accuracy::mergeResults(line.merge, folder);
  if (results.cases.size() < results.allCases) {
    warn("accuracy: " + std::to_string(results.allCases - results.cases.size()) + " of " +
         std::to_string(results.allCases) + " cases are in none of the folders");
  }
  core::writeFileAtomically(folder / accuracy::kResultFile, accuracy::resultText(results));
  return finish(results, folder);
}

std::vector<accuracy::Study> chosenStudies(const std::vector<std::string>& names) {
  std::vector<accuracy::Study> studies;
  for (const std::string& name : names.empty() ? accuracy::listStudies() : names)
    studies.push_back(accuracy::loadStudy(name));
  return studies;
}

// What the folder has, where the run is to go on with it.
accuracy::Results resultsBefore(const CommandLine& line, const fs::path& folder,
                                const accuracy::Results& fresh) {
  const fs::path file = folder / accuracy::kResultFile;
  if (!fs::exists(file)) return fresh;
  if (!line.resume) {
    throw UsageError("accuracy: " + file.string() +
                     " has results already: --resume goes on with them, --out names another folder");
  }
  bool cutOff = false;
  accuracy::Results before = accuracy::readResults(folder, &cutOff);
  if (cutOff) warn(file.string() + ": the last line was cut off and is measured again");
  if (before.digest != fresh.digest)
    throw core::DataError(file.string(), "", "is of other studies, another size or another effort");
  return before;
}

}  // namespace

int accuracy(const CommandLine& line) {
  if (std::ranges::find(line.studies, kCost) != line.studies.end()) return costReport(line);
  if (std::ranges::find(line.studies, kCalibrate) != line.studies.end()) return calibrate(line);
  if (std::ranges::find(line.studies, kJudge) != line.studies.end()) return judge(line);
  if (std::ranges::find(line.studies, kStability) != line.studies.end()) return stabilityTable(line);
  if (!line.scenes.empty())
    throw UsageError("accuracy: --scene belongs to cost, calibrate and judge, which are not named");
  const fs::path folder = line.out.empty() ? "accuracy" : line.out;
  if (!line.merge.empty()) return mergeReport(line, folder);

  const std::vector<accuracy::Study> studies = chosenStudies(line.studies);
  const Size size = line.size.value_or(line.quick ? kQuickSize : kDefaultSize);
  const accuracy::RunOptions options{
      .quick = line.quick,
      .part = {line.part, line.parts},
      .effort = std::to_string(size.width) + "x" + std::to_string(size.height)};
  accuracy::Results fresh;
  fresh.program = programName();
  fresh.quick = line.quick;
  for (const accuracy::Study& study : studies) fresh.allCases += study.cases.size();
  fresh.digest = accuracy::digestOf(studies, options);
  core::requireFolder(folder);
  accuracy::Results before = resultsBefore(line, folder, fresh);
  Subjects subjects(size);
  accuracy::requireRunnable(studies, subjects.source(), options);
  core::makeFolder(folder);
  accuracy::ResultWriter writer(folder, std::move(before));

  Progress progress("accuracy", line.progress);
  accuracy::run(studies, subjects.source(), options, writer, [&](const accuracy::RunProgress& state) {
    if (progress.isDue()) progress.show(accuracy::progressText(state));
  });
  progress.clear();
  return finish(writer.results(), folder);
}

}  // namespace skydrop::app
