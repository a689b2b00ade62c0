#include <algorithm>
#include <cstdio>

#include "app/accuracy/study.h"
#include "app/verbs.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::app {
namespace {

std::vector<const Study*> chosenStudies(const std::vector<std::string>& names) {
  std::vector<const Study*> chosen;
  for (const std::string& name : names) {
    const auto found =
        std::find_if(studies().begin(), studies().end(), [&](const Study& study) { return study.name == name; });
    if (found == studies().end()) {
      std::string known;
      for (const Study& study : studies()) known += (known.empty() ? "" : ", ") + std::string(study.name);
      throw core::UsageError("accuracy: there is no study '" + name + "'; there are: " + known);
    }
    chosen.push_back(&*found);
  }
  if (chosen.empty()) {
    for (const Study& study : studies()) chosen.push_back(&study);
  }
  return chosen;
}

}  // namespace

int accuracy(const CommandLine& line) {
  std::vector<StudyResult> results;
  for (const Study* study : chosenStudies(line.studies)) {
    std::fprintf(stderr, "%s: %s\n", std::string(study->name).c_str(), std::string(study->description).c_str());
    results.push_back(study->run());
  }
  core::writeFileAtomically(line.out, studyReport(results));
  std::printf("%s\n", line.out.c_str());
  return 0;
}

}  // namespace skydrop::app
