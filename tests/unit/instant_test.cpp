#include "skydrop/sky/instant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/hash.h"
#include "support/refusal.h"

namespace skydrop::sky {
namespace {

std::string reasonOf(const std::string& text) {
  Instant instant;
  return readInstant(text, instant);
}

TEST(Instant, everyFormOfIso8601IsTheSameInstant) {
  const Instant noon = parseInstant("2026-06-21T12:00:00Z");
  EXPECT_EQ(noon.utcMs, 1782043200000);
  for (const char* text :
       {"2026-06-21T12:00", "2026-06-21 12:00:00", "2026-06-21t12:00:00z", "2026-06-21T12:00:00.000Z",
        "2026-06-21T14:00+02:00", "2026-06-21T07:30:00-0430", "2026-06-22T01:00:00+13"}) {
    EXPECT_EQ(parseInstant(text), noon) << text;
  }
  EXPECT_EQ(parseInstant("2026-06-21").utcMs, noon.utcMs - 43200000);
  EXPECT_EQ(parseInstant("1970-01-01").utcMs, 0);
  EXPECT_EQ(parseInstant("1969-12-31T23:59:59.2509Z").utcMs, -750) << "after the milliseconds nothing counts";
}

TEST(Instant, datesThatDoNotExistAreRefusedWithTheReason) {
  // The rule of leap years of 400 and 100 years too.
  for (const auto& [text, reason] : {
           std::pair("2023-02-29", "has day 29, but February 2023 has 28 days"),
           std::pair("1900-02-29", "has day 29, but February 1900 has 28 days"),
           std::pair("2026-04-31T10:00", "has day 31, but April 2026 has 30 days"),
           std::pair("2026-01-00", "has day 0, but January 2026 has 31 days"),
           std::pair("2026-13-01", "has month 13, which is not within 1 to 12"),
           std::pair("2026-00-01", "has month 0, which is not within 1 to 12"),
           std::pair("2026-01-01T24:00", "has hour 24, which is not within 0 to 23"),
           std::pair("2026-01-01T10:60", "has minute 60, which is not within 0 to 59"),
           std::pair("2016-12-31T23:59:60Z", "has second 60: leap seconds are not counted"),
           std::pair("2016-12-31T23:59:61Z", "has second 61, which is not within 0 to 59"),
           std::pair("2026-01-01T10:00+19:00", "has a zone with hour 19, which is not within 0 to 18"),
           std::pair("0999-12-31", "is in the year 999, which is not within 1000 to 3000"),
           std::pair("3001-01-01", "is in the year 3001, which is not within 1000 to 3000"),
           std::pair("1000-01-01T00:00+01:00", "is in the year 999, which is not within 1000 to 3000"),
           std::pair("3000-12-31T23:30-01:00", "is in the year 3001, which is not within 1000 to 3000"),
       }) {
    EXPECT_EQ(reasonOf(text), reason) << text;
  }
  for (const char* good : {"2024-02-29", "2000-02-29", "1000-01-01", "3000-12-31T23:59:59.999Z"})
    EXPECT_EQ(reasonOf(good), "") << good;
  EXPECT_EQ(test::refusalOf<core::RangeError>([] { parseInstant("2023-02-30"); }),
            "'2023-02-30' has day 30, but February 2023 has 28 days");
}

TEST(Instant, anythingElseIsNoInstant) {
  for (const char* text : {"",
                           " ",
                           "now",
                           "2026",
                           "2026-6-1",
                           "2026-06-21T",
                           "2026-06-21T12",
                           "2026-06-21T12:0",
                           "2026-06-21T12:00:",
                           "2026-06-21T12:00:00.",
                           "2026-06-21T12:00Zulu",
                           "2026-06-21T12:00Z ",
                           " 2026-06-21",
                           "-2026-06-21",
                           "2026/06/21",
                           "2026-06-21T12:00+",
                           "2026-06-21T12:00+2",
                           "2026-06-21T12:00:00+02:",
                           "nan",
                           "2026-06-21T1 :00",
                           "+026-06-21"}) {
    EXPECT_EQ(reasonOf(text), "is not an instant such as 2026-06-21T12:00:00Z") << '[' << text << ']';
  }
}

TEST(Instant, textReadsBackToTheSameMillisecond) {
  // Ten thousand of the two thousand years, and the ends.
  core::RandomStream random{20260614, 0};
  const double span = static_cast<double>(kLastInstant.utcMs - kFirstInstant.utcMs);
  for (int i = 0; i < 10000; ++i) {
    const Instant instant{kFirstInstant.utcMs + static_cast<std::int64_t>(random.nextUnit() * span)};
    const std::string text = instantText(instant);
    EXPECT_EQ(parseInstant(text), instant) << text;
  }
  EXPECT_EQ(instantText(kFirstInstant), "1000-01-01T00:00:00Z");
  EXPECT_EQ(instantText(kLastInstant), "3000-12-31T23:59:59.999Z");
  EXPECT_EQ(instantText({-1}), "1969-12-31T23:59:59.999Z");
  EXPECT_EQ(instantText({kLastInstant.utcMs + 5}), instantText(kLastInstant));
}

TEST(Instant, julianDatesAreThoseOfMeeus) {
  // Chapter 7, examples 7.a and 7.c and the table after them (Gregorian dates).
  for (const auto& [text, date] :
       {std::pair("1957-10-04T19:26:24", 2436116.31), std::pair("2000-01-01T12:00", 2451545.0),
        std::pair("1987-01-27", 2446822.5), std::pair("1600-12-31", 2305812.5),
        std::pair("1987-06-19T12:00", 2446966.0)}) {
    EXPECT_NEAR(julianDate(parseInstant(text)), date, 1e-9) << text;
  }
  EXPECT_EQ(daysSinceJ2000(parseInstant("2000-01-02T12:00"), 43200), 1.5);
  EXPECT_EQ(instantAt(1.5), parseInstant("2000-01-03T00:00"));
  EXPECT_EQ(instantAt(-1e9), kFirstInstant);
  EXPECT_EQ(instantAt(1e9), kLastInstant);
}

TEST(Instant, deltaTIsThatOfTheTablesAndContinuous) {
  // IERS: 33.15 s at the beginning of 1960, 63.83 of 2000, 69.36 of 2020. A step a day changes it by at most
  // 0.05 s even where the early tables are steepest.
  const auto at = [](const char* text) { return deltaTSeconds(daysSinceJ2000(parseInstant(text))); };
  EXPECT_NEAR(at("1960-01-01"), 33.15, 0.01);
  EXPECT_NEAR(at("2000-01-01"), 63.83, 0.01);
  EXPECT_NEAR(at("2020-01-01"), 69.36, 0.01);
  double before = deltaTSeconds(daysSinceJ2000(kFirstInstant));
  for (double days = daysSinceJ2000(kFirstInstant); days < daysSinceJ2000(kLastInstant); days += 1) {
    const double now = deltaTSeconds(days);
    ASSERT_NEAR(now, before, 0.05) << days;
    before = now;
  }
  EXPECT_TRUE(isAccurate(parseInstant("1950-01-01")) && isAccurate(parseInstant("2050-12-31T23:59:59.999Z")));
  EXPECT_FALSE(isAccurate(parseInstant("1949-12-31T23:59")) || isAccurate(parseInstant("2051-01-01")));
}

}  // namespace
}  // namespace skydrop::sky
