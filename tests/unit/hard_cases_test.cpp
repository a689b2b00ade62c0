// The list of numerically hard cases (tests/stability/cases.json) against the tests that there are.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "support/paths.h"

namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Ids that stand in test names: TEST(Stability, T01_...), in any folder of tests/.
std::set<std::string> testedIds() {
  std::set<std::string> ids;
  const std::regex name(R"(TEST(?:_F|_P)?\(\s*\w+,\s*((?:[A-Z]\d\d_)+))");
  const std::regex id(R"([A-Z]\d\d)");
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(skydrop::test::sourceDir()) / "tests")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = contentOf(entry.path());
    for (std::sregex_iterator test(text.begin(), text.end(), name), end; test != end; ++test) {
      const std::string names = (*test)[1];
      for (std::sregex_iterator i(names.begin(), names.end(), id); i != std::sregex_iterator(); ++i)
        ids.insert(i->str());
    }
  }
  return ids;
}

TEST(HardCases, everyRowIsTestedOrSaidToBePlanned) {
  // The list says "tested" of a row exactly when some test carries its id; "absent" needs a reason.
  const auto list =
      nlohmann::json::parse(contentOf(fs::path(skydrop::test::sourceDir()) / "tests/stability/cases.json"));
  std::map<std::string, std::string> status;
  for (const auto& row : list["cases"]) {
    const std::string id = row["id"], state = row["status"];
    status[id] = state == "absent" && !row.value("because", "").empty() ? "planned" : state;
  }
  EXPECT_GE(status.size(), 70u);
  const std::set<std::string> tested = testedIds();
  for (const auto& [id, state] : status) {
    EXPECT_EQ(state, tested.contains(id) ? "tested" : "planned") << id;
  }
  for (const std::string& id : tested) EXPECT_TRUE(status.contains(id)) << id << " is not in the list";
}

}  // namespace
