// Elevation files as anybody may hand them in: those that are kept, and mutants of the good ones.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/elevation/survey.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "support/instrumented.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::elevation {
namespace {

namespace fs = std::filesystem;

fs::path corpus() { return fs::path(test::sourceDir()) / "tests/corpus/elevation"; }

bool isReader(const fs::path& file) { return file.extension() != ".pgw" && file.extension() != ".prj"; }

// Opens it and looks at every cell, as land would; the refusal, if there is one.
std::string lookAt(const fs::path& file) {
  return test::refusalOf<core::DataError>([&] {
    const auto raster = openRaster(file);
    const Survey survey(*raster);
    ASSERT_TRUE(std::isfinite(survey.mean()));
    ASSERT_GE(survey.all().lowest, kLowestHeight);
    ASSERT_LE(survey.all().highest, kHighestHeight);
    const Projection projection(raster->georeference().crs, raster->name());
  });
}

TEST(ElevationCorpus, goodFilesAreReadAndBadOnesRefusedInOneLine) {
  std::size_t good = 0, bad = 0;
  for (const auto& entry : fs::directory_iterator(corpus())) {
    const std::string name = entry.path().filename().string();
    if (!isReader(entry.path())) continue;
    const std::string refusal = lookAt(entry.path());
    if (name.starts_with("good")) {
      ++good;
      EXPECT_EQ(refusal, "") << name;
    } else {
      ++bad;
      EXPECT_TRUE(test::isOneLineAbout(refusal, name)) << name << ": " << refusal;
    }
  }
  EXPECT_GE(good, 8u);
  EXPECT_GE(bad, 20u);
}

TEST(ElevationCorpus, mutantsAreReadOrRefusedInOneLine) {
  // Never a crash, another exception, or a height of no earth; some of each kind are refused and some are
  // read.
  const test::TemporaryFolder folder;
  std::set<std::string> refused, read;
  for (const auto& entry : fs::directory_iterator(corpus())) {
    const std::string name = entry.path().filename().string();
    // Of 4 KiB of zip unpack 2.9 MB each.
    const bool isLarge = entry.path().extension() == ".zip";
    if (!name.starts_with("good") || !isReader(entry.path())) continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    if (entry.path().extension() == ".png")
      folder.write(entry.path().stem().string() + ".pgw", "10\n0\n0\n-10\n2600005\n1200075\n");
    const fs::path file = folder.path() / name;
    test::forEachMutant(content, test::repetitions(isLarge ? 60 : 600), [&](const std::string& mutant) {
      test::writePlainly(file, mutant);
      const std::string refusal = lookAt(file);
      (refusal.empty() ? read : refused).insert(name);
      if (!refusal.empty()) {
        EXPECT_TRUE(test::isOneLineAbout(refusal, name)) << refusal;
      }
    });
    EXPECT_TRUE(refused.contains(name)) << name << ": truncated, and read";
  }
  EXPECT_GE(read.size(), 2u);
}

}  // namespace
}  // namespace skydrop::elevation
