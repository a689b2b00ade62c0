// Whether statistics are as docs/schemas/stats.schema.json publishes them.
#pragma once

#include <filesystem>
#include <string>

#include "support/paths.h"
#include "support/process.h"

namespace skydrop::test {

// Debian's, which has the package.
inline constexpr const char* kSystemPython = "/usr/bin/python3";

inline bool canCheckStatistics() {
  return runProcess({kSystemPython, "-c", "import jsonschema"}).exitCode == 0;
}

// A line for each place that is not as the schema says; empty: all is.
inline std::string faultsOfStatistics(const std::filesystem::path& file) {
  const char* const kScript =
      "import json, sys, jsonschema\n"
      "schema = json.load(open(sys.argv[1]))\n"
      "jsonschema.Draft202012Validator.check_schema(schema)\n"
      "for e in jsonschema.Draft202012Validator(schema).iter_errors(json.load(open(sys.argv[2]))):\n"
      "    print(e.json_path, e.message)\n";
  const ProcessResult result =
      runProcess({kSystemPython, "-c", kScript, sourceDir() + std::string("/docs/schemas/stats.schema.json"),
                  file.string()});
  return result.exitCode == 0 ? result.out : "the script failed: " + result.err;
}

}  // namespace skydrop::test
