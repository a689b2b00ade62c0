#include "app/cli/accuracy_flags.h"

#include <algorithm>
#include <string>
#include <vector>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

using core::UsageError;

namespace {

void parsePart(const std::string& t, CommandLine& line) {
  const std::size_t slash = t.find('/');
  if (slash == std::string::npos) throw UsageError("--part: '" + t + "' is not K/N");
  line.parts = integer("--part", t.substr(slash + 1), 1, 10000);
  line.part = integer("--part", t.substr(0, slash), 1, line.parts);
}

// "N" or "A..B"

}  // namespace

void addAccuracyFlags(CLI::App& verb, CommandLine& line) {
  verb.add_option(
          "STUDY", line.studies,
          "studies by name, or files of the same form; or cost alone: what each effect costs; or "
          "calibrate alone: what a frame budget chooses from, for the cache folder; or judge alone: traces "
          "the light in clouds that clouds-model is held against, or with --size draws pictures of it beside "
          "those of the program; or stability alone: the hard cases and their margins. None named: all but "
          "those four")
      ->type_name("NAME|FILE");
  verb.add_option_function<std::vector<std::string>>(
          "--scene",
          [&line](const std::vector<std::string>& all) {
            if (std::ranges::find(all, "") != all.end()) throw UsageError("--scene: the name is empty");
            line.scenes = all;
          },
          "a scene that cost measures, and no others (all), may stand several times; or that of calibrate "
          "(fair); or of judge, by its own names (all)")
      ->type_name("NAME|FILE")
      ->allow_extra_args(false)
      ->expected(1, 1000);
  verb.add_flag("--quick", line.quick, "small pictures (160x90) and three repeats instead of five");
  addText(verb, "--out", "DIR|FILE|-",
          "the folder of results and report (accuracy); of cost a file (accuracy.md) or - for standard "
          "output; of "
          "stability a folder for its pages",
          [&line](const std::string& t) {
            if (t.empty()) throw UsageError("--out: the path is empty");
            line.out = t;
          });
  addText(verb, "--format", "markdown|json|csv", "of the report of cost (markdown)",
          [&line](const std::string& t) { line.reportFormat = parseReportFormat(t); });
  verb.add_flag("--resume", line.resume, "go on with the results in the folder");
  addText(verb, "--part", "K/N", "measure every Nth case, beginning with the Kth",
          [&line](const std::string& t) { parsePart(t, line); });
  verb.add_option_function<std::vector<std::string>>(
          "--merge",
          [&line](const std::vector<std::string>& all) { line.merge.assign(all.begin(), all.end()); },
          "make one report of these folders of shares")
      ->type_name("DIR..")
      ->expected(1, 1000);
  verb.preparse_callback([&line](std::size_t) { line.out.clear(); });
}

}  // namespace skydrop::app
