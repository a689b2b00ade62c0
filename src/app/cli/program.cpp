#include <cstdio>

#include "app/cli/command_line_parser.h"
#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/standard_output.h"
#include "app/session/model_reading.h"
#include "app/session/run_config.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

constexpr int kFailed = 1, kUsage = 2, kNoGraphics = 3;
constexpr int kReaderGone = 141;  // as shells report a program that SIGPIPE ended

int runVerb(const CommandLine& line) {
  switch (line.verb) {
    case Verb::fly:
      return fly(line);
    case Verb::render:
      return render(line);
    case Verb::simulate:
      return simulate(line);
    case Verb::accuracy:
      return accuracy(line);
    case Verb::noise:
      return noise(line);
    case Verb::sky:
      return sky(line);
    case Verb::weather:
      return weather(line);
    case Verb::lab:
      return lab(line);
    case Verb::elevation:
      return checkElevation(line);
    case Verb::info:
      return info(line);
    case Verb::compare:
      return compare(line);
    case Verb::settings:
      return listSettings(line);
  }
  return kFailed;
}

int refuse(int exitCode, const char* reason) {
  warn(reason);
  return exitCode;
}

}  // namespace

int runProgram(int argc, const char* const* argv) {
  if (argc == 3 && argv[1] == kReadModelWord) return readModelForParent(argv[2]);
  prepareStandardStreams();
  readForeignModelsApart();
  try {
    const ParsedCommandLine parsed = parseCommandLine(argc, argv);
    if (parsed.answer) {
      print("%s", parsed.answer->c_str());
      finishStandardOutput();
      for (const std::string& complaint : parsed.complaints) warn(complaint);
      return parsed.complaints.empty() ? 0 : kFailed;
    }
    const int exitCode = runVerb(withPreset(parsed.commandLine));
    finishStandardOutput();
    return exitCode;
  } catch (const core::ClosedPipe&) {
    return kReaderGone;
  } catch (const core::UsageError& error) {
    return refuse(kUsage, error.what());
  } catch (const core::GraphicsUnavailable& error) {
    return refuse(kNoGraphics, error.what());
  } catch (const std::exception& error) {
    return refuse(kFailed, error.what());
  }
}

}  // namespace skydrop::app
