// The command line, a word a line, and the settings that it sets.
#include "app/cli/command_line_parser.h"
#include "app/settings/settings.h"
#include "fuzz/fuzz_input.h"

using namespace skydrop;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static app::Settings settings;
  static const core::SettingsTable table(settings);
  std::vector<std::string> words = fuzz::linesOf(data, size);
  words.insert(words.begin(), "skydrop");
  for (std::string& word : words) word = word.c_str();  // as exec() hands them over
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  fuzz::accepts("", [&] {
    const app::ParsedCommandLine parsed =
        app::parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
    app::applyOverrides(table, parsed.commandLine.set);
  });
  return 0;
}
