// Files are opened, and JSON is parsed, in one place each, which hold them to their limits: read from the
// sources.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include "support/paths.h"

namespace {

namespace fs = std::filesystem;

TEST(ReaderRule, filesAreOpenedAndJsonIsParsedInOnePlace) {
  // Any other reader would wait for a pipe, or let depth and names through that the one refuses.
  const std::regex opens(R"(ifstream|\bfopen\s*\(|\bfdopen\s*\(|freopen)");
  const std::regex parses(R"(json::parse\s*\(|sax_parse\s*\(|json::accept\s*\()");
  const std::set<std::string> openers = {"file", "output_file",
                                         "system_info"};  // the last: /proc of this machine
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(skydrop::test::sourceDir()) / "src")) {
    if (!entry.is_regular_file()) continue;
    ++files;
    const std::string stem = entry.path().stem().string();
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      EXPECT_FALSE(!openers.contains(stem) && std::regex_search(line, opens)) << entry.path() << ": " << line;
      EXPECT_FALSE(stem != "json" && std::regex_search(line, parses)) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(files, 100) << "the sources were not found";
}

}  // namespace
