// Instants of time and their ISO 8601 text. Values and pure functions, from any thread.
//
// An instant is UTC in the proleptic Gregorian calendar with days of 86 400 s: leap seconds are not counted.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::sky {

struct Instant {
  std::int64_t utcMs = 0;  // since 1970-01-01T00:00:00Z
  auto operator<=>(const Instant&) const = default;
};

// Years that can be written and read. The positions of sun and moon keep their accuracy (almanac.h) from
// 1950-01-01 to 2050-12-31; outside of that they drift slowly, mostly by the rotation of the earth.
inline constexpr int kFirstYear = 1000, kLastYear = 3000;
inline constexpr int kFirstAccurateYear = 1950, kLastAccurateYear = 2050;
extern const Instant kFirstInstant, kLastInstant;  // of those that can be written

bool isAccurate(Instant instant);

// "2026-06-21", "2026-06-21T12:00", "2026-06-21T12:00:00.25Z", "2026-06-21T14:00:00+02:00": a space may take
// the place of the T, and without a zone it is UTC. More than milliseconds are dropped. Returns nothing and
// sets the instant, or returns why the text cannot be read ("has day 30, but February 2023 has 28 days").
std::string readInstant(std::string_view text, Instant& instant);

// The same, but throws core::RangeError: "'2023-02-30' has day 30, ...".
Instant parseInstant(std::string_view text);

// "2026-06-21T12:00:00Z"; with milliseconds where there are some. Not before kFirstInstant nor after
// kLastInstant: these are written in their place.
std::string instantText(Instant instant);

// The same two for a described setting that holds milliseconds.
extern const core::WrittenForm kInstantForm;

// Julian date (days since noon UTC of the first day of -4712).
double julianDate(Instant instant);

// Days since 2000-01-01T12:00:00Z, `secondsLater` than the instant: what the almanac counts in. Exact to
// 1e-11 days (a microsecond) within a thousand years.
double daysSinceJ2000(Instant instant, double secondsLater = 0);
// The instant nearest to it, within the years that can be written.
Instant instantAt(double daysSinceJ2000);

// Terrestrial time less UTC, seconds, piecewise linear between the values of a table: to 1 s from 1950 to
// 2026 (IERS), extrapolated after that; from there to 2050 it is uncertain by about 5 s, which moves the sun
// by 0.2 and the moon by 3 seconds of arc. (Espenak, Meeus, "Five millennium canon of solar eclipses", 2006,
// before 1950 and after 2100.)
double deltaTSeconds(double daysSinceJ2000);

}  // namespace skydrop::sky
