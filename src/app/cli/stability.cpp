#include <filesystem>

#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "app/measure/system_info.h"
#include "app/types/version.h"
#include "skydrop/core/file.h"
#include "skydrop/stability/hard_case_report.h"

namespace skydrop::app {

int printStability(const CommandLine& line) {
  const stability::HardCaseReport report{stability::loadHardCases(), stability::measureAll(), programName(),
                                         machineName()};
  if (line.out.empty()) {
    print("%s", stability::plainTable(report).c_str());
  } else {
    const std::filesystem::path folder = line.out;
    core::makeFolder(folder);
    const auto write = [&](const char* name, const std::string& text) {
      core::writeFileAtomically(folder / name, text);
      print("%s\n", (folder / name).c_str());
    };
    write("hard-cases.md", stability::markdownTable(report));
    write("hard-cases.html", stability::htmlTable(report));
    write("hard-cases.json", stability::jsonTable(report));
  }
  bool holds = true;
  for (const stability::Measured& of : report.now) {
    if (stability::keeps(of.figure, of.check.limit)) continue;
    warn(std::string("accuracy: ") + of.check.id + ": " + of.check.what +
         " is beyond its limit on this machine");
    holds = false;
  }
  return holds ? 0 : 1;
}

}  // namespace skydrop::app
