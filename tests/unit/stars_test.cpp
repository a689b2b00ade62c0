#include "skydrop/sky/stars.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/sky/almanac.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/refusal.h"

namespace skydrop::sky {
namespace {

const std::vector<Star>& catalogue() {
  static const std::vector<Star> stars = readStars(test::sourceDir() + "/assets/stars/stars.bin");
  return stars;
}

const Star& star(std::uint32_t hipparcos) {
  const auto found = std::ranges::find(catalogue(), hipparcos, &Star::hipparcos);
  if (found == catalogue().end()) throw std::runtime_error("no such star");
  return *found;
}
constexpr std::uint32_t kPolaris = 11767, kSirius = 32349, kVega = 91262, kBetelgeuse = 27989;

double daysOf(std::string_view utc) { return daysSinceJ2000(parseInstant(utc)); }

Horizontal seen(const Star& star, double days, const Place& place) {
  return horizontalOf(j2000ToWorld(days, place) * star.direction);
}

TEST(Stars, areThoseThatTheEyeSees) {
  // 5044 down to magnitude 6, as many as other catalogues have within a few per cent (Hoffleit: 5080
  // to 6.00).
  EXPECT_EQ(catalogue().size(), 5044u);
  EXPECT_EQ(catalogue().front().hipparcos, kSirius);
  EXPECT_NEAR(star(kSirius).magnitude, -1.44, 1e-9);
  EXPECT_EQ(catalogue().back().magnitude, 6);
  EXPECT_NEAR(star(kVega).colorIndex, 0, 0.01);
  EXPECT_NEAR(star(kBetelgeuse).colorIndex, 1.5, 0.05);
  for (const Star& each : catalogue()) ASSERT_NEAR(glm::length(each.direction), 1, 1e-12);
}

TEST(Stars, polarisStandsByThePoleAsHighAsTheLatitude) {
  // 44 minutes of arc off the pole in 2000, and for all of a day.
  for (const double latitude : {90.0, 51.5, 20.0, 0.0, -10.0}) {
    for (int hour = 0; hour < 24; ++hour) {
      const Horizontal place = seen(star(kPolaris), daysOf("2026-01-01") + hour / 24.0, {latitude, 10});
      const glm::dvec3 pole = worldDirection({0, latitude});
      EXPECT_GT(glm::dot(worldDirection(place), pole), std::cos(glm::radians(0.75)))
          << latitude << ' ' << hour;
    }
  }
}

TEST(Stars, siriusCulminatesInTheSouthAtItsDeclination) {
  // When the sidereal time is its right ascension (6h 45m 9s of 2000, 6h 46m 18s in 2026), at 90 - latitude
  // - 16.75 degrees: precession has moved it by 0.03 since 2000. Its own motion, left out, is 0.009.
  const Place place{40, 15};
  double days = daysOf("2026-02-01T18:00"), highest = -90, at = 0;
  for (int minute = 0; minute < 1440; ++minute) {
    const double time = days + minute / 1440.0, elevation = seen(star(kSirius), time, place).elevationDegrees;
    if (elevation > highest) highest = elevation, at = time;
  }
  EXPECT_NEAR(highest, 50 - 16.75, 0.02);
  EXPECT_NEAR(seen(star(kSirius), at, place).azimuthDegrees, 180, 0.3) << "a minute is 0.25 degrees";
  EXPECT_NEAR(siderealDegrees(at, 15), 15 * (6 + 46 / 60.0 + 18 / 3600.0), 0.2);
}

TEST(Stars, turnAsSkyfieldHasThem) {
  // Skyfield (without aberration and proper motion: a fixed direction of the catalogue's position through its
  // precession, nutation and rotation), 2050-07-01T03:00 UT1 at 33.9 S 151.2 E and 1950-01-01 at 60 N 0:
  // within 0.001 degrees, the nutation's error and what separates IAU 1976 from IAU 2006.
  struct Row {
    std::uint32_t hipparcos;
    const char* utc;
    Place place;
    Horizontal where;
  };
  const Row rows[] = {{11767, "2050-07-01T03:00", {-33.9, 151.2}, {359.445012, -33.610639}},
                      {32349, "2050-07-01T03:00", {-33.9, 151.2}, {320.879786, 68.905329}},
                      {91262, "2050-07-01T03:00", {-33.9, 151.2}, {64.336882, -76.292873}},
                      {27989, "2050-07-01T03:00", {-33.9, 151.2}, {324.153809, 41.855819}},
                      {68702, "2050-07-01T03:00", {-33.9, 151.2}, {147.075067, 26.188178}},
                      {11767, "1950-01-01T00:00", {60, 0}, {358.128257, 60.271107}},
                      {32349, "1950-01-01T00:00", {60, 0}, {179.357171, 13.337568}},
                      {91262, "1950-01-01T00:00", {60, 0}, {0.994934, 8.743161}},
                      {27989, "1950-01-01T00:00", {60, 0}, {194.836653, 36.629606}},
                      {68702, "1950-01-01T00:00", {60, 0}, {121.446789, -56.732885}}};
  double worst = 0;
  for (const Row& row : rows) {
    const glm::dvec3 a = worldDirection(seen(star(row.hipparcos), daysOf(row.utc), row.place));
    const double off = glm::degrees(glm::length(a - worldDirection(row.where)));
    worst = std::max(worst, off);
    EXPECT_LT(off, 0.001) << row.hipparcos << ' ' << row.utc;
  }
  std::printf("stars: at most %.5f degrees\n", worst);
}

TEST(Stars, theRotationIsARotation) {
  for (const double days : {-365000.0, 0.0, 9600.3, 365000.0}) {
    const glm::dmat3 turn = j2000ToWorld(days, {-35, 100});
    EXPECT_NEAR(glm::determinant(turn), 1, 1e-12);
    EXPECT_NEAR(glm::length(turn * glm::dvec3(1, 2, 3)), std::sqrt(14.0), 1e-12);
  }
}

std::string refusal(const std::string& content, std::vector<Star>* stars = nullptr) {
  std::vector<std::byte> bytes(content.size());
  if (!content.empty()) std::memcpy(bytes.data(), content.data(), content.size());
  return test::refusalOf<core::DataError>([&] {
    const std::vector<Star> read = decodeStars(bytes, "a.bin");
    if (stars) *stars = read;
  });
}

std::string corpusFile(const std::filesystem::path& file) { return core::readTextFile(file); }

TEST(Stars, filesOfTheCorpusAreReadOrRefusedInOneLine) {
  int good = 0, bad = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::sourceDir() + "/tests/corpus/stars")) {
    const std::string name = entry.path().filename().string();
    const std::string line = refusal(corpusFile(entry.path()));
    if (name.starts_with("good")) {
      EXPECT_EQ(line, "") << name;
      ++good;
    } else {
      EXPECT_TRUE(test::isOneLineAbout(line, "a.bin")) << name << ": " << line;
      ++bad;
    }
  }
  EXPECT_GE(good, 2);
  EXPECT_GE(bad, 15);
}

TEST(Stars, badFieldsAreNamed) {
  const auto of = [](const char* name) {
    return refusal(corpusFile(test::sourceDir() + "/tests/corpus/stars/" + name));
  };
  EXPECT_EQ(of("badEmpty.bin"), "a.bin: header: 0 bytes instead of 12");
  EXPECT_EQ(of("badMagic.bin"), "a.bin: magic number: not a star catalogue");
  EXPECT_EQ(of("badNone.bin"), "a.bin: number of stars: 0 is out of range 1 to 100000");
  EXPECT_EQ(of("badHugeCount.bin"), "a.bin: number of stars: 4294967295 is out of range 1 to 100000");
  EXPECT_EQ(of("badTruncatedStar.bin"), "a.bin: stars: 47 bytes where the header says 48");
  EXPECT_EQ(of("badTrailingByte.bin"), "a.bin: stars: 49 bytes where the header says 48");
  EXPECT_EQ(of("badAscension360.bin"), "a.bin: star 3: right ascension 3600000 is out of range 0 to 3599999");
  EXPECT_EQ(of("badDeclinationBeyondThePole.bin"),
            "a.bin: star 3: declination 900001 is out of range -900000 to 900000");
  EXPECT_EQ(of("badOrder.bin"), "a.bin: star 3: is brighter than the one before it");
  EXPECT_EQ(test::refusalOf<core::DataError>([] { readStars("/nowhere/stars.bin"); }),
            "/nowhere/stars.bin: cannot open: No such file or directory");
}

TEST(Stars, damagedCopiesAreRefusedOrHoldStars) {
  int refused = 0;
  for (const char* name : {"goodThree.bin", "goodOne.bin"}) {
    test::forEachMutant(corpusFile(test::sourceDir() + "/tests/corpus/stars/" + name), 3000,
                        [&](const std::string& mutant) {
                          std::vector<Star> stars;
                          const std::string line = refusal(mutant, &stars);
                          refused += !line.empty();
                          if (!line.empty()) {
                            ASSERT_TRUE(test::isOneLineAbout(line, "a.bin")) << line;
                            return;
                          }
                          for (const Star& each : stars) {
                            ASSERT_NEAR(glm::length(each.direction), 1, 1e-12);
                            ASSERT_TRUE(each.magnitude >= -2 && each.magnitude <= 8);
                          }
                        });
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace skydrop::sky
