// Results reach standard output through one function that notices a full disk: read from the sources.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "support/paths.h"

namespace {

namespace fs = std::filesystem;

TEST(PrintRule, nothingButStandardOutputWritesToStandardOutput) {
  // Every other way to print would lose a result without a word.
  const std::regex unchecked(R"(\b(printf|puts|putchar)\s*\(|\bstdout\b|std::cout)");
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(skydrop::test::sourceDir()) / "src")) {
    if (!entry.is_regular_file() || entry.path().stem() == "standard_output") continue;
    ++files;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);) {
      line = line.substr(0, line.find("//"));
      EXPECT_FALSE(std::regex_search(line, unchecked)) << entry.path() << ": " << line;
    }
  }
  EXPECT_GT(files, 100) << "the sources were not found";
}

}  // namespace
