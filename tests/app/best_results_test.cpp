// The best deliveries: kept, merged with what others wrote, and read from files that hold anything.
#include "app/settings/best_results.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "support/instrumented.h"
#include "support/margin.h"
#include "support/mutants.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

TEST(BestResults, theTenBestAreKeptInOrderFromFlightToFlight) {
  const test::TemporaryFolder folder;
  BestResults best(folder.path());
  EXPECT_EQ(best.load(), std::nullopt);
  EXPECT_EQ(best.add({500, 20, 60, "fair"}), 1u);
  EXPECT_EQ(best.add({700, 10, 50, "fair"}), 1u);
  EXPECT_EQ(best.add({500, 5, 90, "terrain"}), 3u) << "equal points stay behind";
  for (int i = 0; i < 10; ++i) best.add({600, 15, 70, "fair"});
  EXPECT_EQ(best.add({1, 99, 600, "fair"}), 0u);
  EXPECT_EQ(best.save(), std::nullopt);
  BestResults again(folder.path());
  EXPECT_EQ(again.load(), std::nullopt);
  EXPECT_EQ(again.all(), best.all());
  EXPECT_EQ(again.all().size(), BestResults::kKept);
  EXPECT_EQ(again.all()[0].points, 700);
}

TEST(BestResults, whatAnotherProgramWroteMeanwhileStays) {
  const test::TemporaryFolder folder;
  BestResults one(folder.path()), other(folder.path());
  one.load(), other.load();
  one.add({500, 20, 60, "fair"});
  one.save();
  other.add({800, 2, 40, "clear"});
  other.save();
  BestResults back(folder.path());
  back.load();
  ASSERT_EQ(back.all().size(), 2u);
  EXPECT_EQ(back.all()[0].scene, "clear");
}

TEST(BestResults, whatIsNoResultIsReportedInOneLineAndLeftOut) {
  const test::TemporaryFolder folder;
  folder.write("deliveries.json",
               R"({"schema": 1, "best": [{"points": 400, "distance": 3, "seconds": 4, "scene": "fair"},
                   {"points": -1, "distance": 3, "seconds": 4, "scene": "fair"}, 7,
                   {"points": 5.5, "distance": 3, "seconds": 4, "scene": "fair"},
                   {"points": 5, "distance": 3, "seconds": 1e9, "scene": "fair"}]})");
  BestResults best(folder.path());
  const auto line = best.load();
  ASSERT_TRUE(line);
  EXPECT_NE(line->find("best.1: is no result"), std::string::npos) << *line;
  EXPECT_EQ(line->find('\n'), std::string::npos);
  ASSERT_EQ(best.all().size(), 1u);
  EXPECT_EQ(best.all()[0].points, 400);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), -1.0, 1e9})
    EXPECT_EQ(best.add({500, bad, 60, "fair"}), 0u);
  EXPECT_EQ(best.add({0, 1, 60, "fair"}), 0u);
  EXPECT_EQ(best.add({500, 1, 60, ""}), 0u);
  EXPECT_EQ(best.add({500, 1, 60, std::string("a\nb")}), 0u);
}

TEST(BestResults, aBrokenFileIsSetAside) {
  const test::TemporaryFolder folder;
  folder.write("deliveries.json", "{\"schema\": 1, \"best\": [");
  BestResults best(folder.path());
  const auto line = best.load();
  ASSERT_TRUE(line);
  EXPECT_NE(line->find("the file is kept as"), std::string::npos) << *line;
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "deliveries.json.bad"));
  best.add({500, 20, 60, "fair"});
  EXPECT_EQ(best.save(), std::nullopt);
  BestResults again(folder.path());
  EXPECT_EQ(again.load(), std::nullopt);
  EXPECT_EQ(again.all().size(), 1u);
}

TEST(BestResults, G09_anyFileLeavesResultsThatAreOnes) {
  // Damaged copies of a whole file: read without a fault, and what is left are results, sorted, that can be
  // saved and read again.
  test::noFaults("G09", "results that are none");
  const test::TemporaryFolder folder;
  BestResults best(folder.path());
  for (int i = 1; i <= 5; ++i) best.add({100 * i, 10.0 * i, 20.0 * i, "fair"});
  best.save();
  const std::string good = core::readTextFile(bestResultsFile(folder.path()));
  int read = 0;
  test::forEachMutant(good, test::repetitions(1500), [&](const std::string& bad) {
    for (const char* name : {"deliveries.json", "deliveries.json.bad"})
      std::filesystem::remove(folder.path() / name);
    test::writePlainly(folder.path() / "deliveries.json", bad);
    BestResults mutant(folder.path());
    const auto line = mutant.load();
    if (line) {
      EXPECT_EQ(line->find('\n'), std::string::npos) << *line;
    }
    read += mutant.all().empty() ? 0 : 1;
    EXPECT_LE(mutant.all().size(), BestResults::kKept);
    for (std::size_t i = 0; i < mutant.all().size(); ++i) {
      const BestResult& r = mutant.all()[i];
      EXPECT_TRUE(r.points >= 1 && r.points <= 100000 && r.distanceM >= 0 && r.distanceM <= 1000) << bad;
      if (i > 0) {
        EXPECT_LE(r.points, mutant.all()[i - 1].points);
      }
    }
  });
  EXPECT_GT(read, 0);
}

}  // namespace
}  // namespace skydrop::app
