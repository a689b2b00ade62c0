#include <algorithm>
#include <cstdio>

#include "app/cli/verbs.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/studies/study.h"
#include "skydrop/core/error.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {
namespace {

std::vector<const Study*> chosenStudies(const std::vector<std::string>& names) {
  std::vector<const Study*> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(studies().begin(), studies().end(),
                                    [&](const Study& study) { return study.name == name; });
    if (found == studies().end()) {
      std::string known;
      for (const Study& study : studies()) known += (known.empty() ? "" : ", ") + std::string(study.name);
      throw core::UsageError("accuracy: there is no study '" + name + "'; there are: " + known);
    }
    chosen.push_back(&*found);
  }
  if (chosen.empty()) {
    for (const Study& study : studies()) {
      if (!study.onlyByName) chosen.push_back(&study);
    }
  }
  return chosen;
}

void checkOptions(const CommandLine& line, const std::vector<const Study*>& chosen) {
  if (line.scenes.empty() && !line.quick) return;
  if (std::ranges::any_of(chosen, &Study::takesOptions)) return;
  throw core::UsageError(std::string("accuracy: ") + (line.quick ? "--quick" : "--scene") +
                         " belongs to the study cost, which is not named");
}

}  // namespace

int accuracy(const CommandLine& line) {
  const std::vector<const Study*> chosen = chosenStudies(line.studies);
  checkOptions(line, chosen);
  for (const std::string& scene : line.scenes)
    scene::loadScene(scene);  // refused before anything is measured
  core::OutputFile out = openOutput(line.out).value();
  std::vector<StudyResult> results;
  for (const Study* study : chosen) {
    const std::string name(study->name);
    std::fprintf(stderr, "%s: %s\n", name.c_str(), std::string(study->description).c_str());
    Progress progress("accuracy", line.progress);
    const std::vector<StudyResult> tables =
        study->run({line.scenes, line.quick}, [&](std::size_t done, std::size_t all) {
          progress.show(name + ", " + std::to_string(done) + " of " + std::to_string(all));
        });
    results.insert(results.end(), tables.begin(), tables.end());
  }
  const ReportHeading* heading = chosen.size() == 1 ? chosen.front()->heading : nullptr;
  out.write(studyReport(results, line.reportFormat, heading ? *heading : kAccuracyHeading));
  if (!out.isStandardOutput()) print("%s\n", line.out.c_str());
  return 0;
}

}  // namespace skydrop::app
