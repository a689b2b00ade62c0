#include "skydrop/sky/instant.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>

#include "skydrop/core/error.h"

namespace skydrop::sky {
namespace {

constexpr std::int64_t kMsPerDay = 86'400'000;
constexpr std::int64_t kJ2000Ms = 946'728'000'000;  // 2000-01-01T12:00:00Z

constexpr std::int64_t dayNumber(int year, unsigned month, unsigned day) {
  using namespace std::chrono;
  return sys_days(year_month_day(std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)))
      .time_since_epoch()
      .count();
}

constexpr std::array<std::string_view, 12> kMonths = {"January",   "February", "March",    "April",
                                                      "May",       "June",     "July",     "August",
                                                      "September", "October",  "November", "December"};

constexpr int daysOfMonth(int year, int month) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month == 2 && std::chrono::year(year).is_leap() ? 29 : kDays[static_cast<std::size_t>(month - 1)];
}

constexpr const char* kForm = "is not an instant such as 2026-06-21T12:00:00Z";

// Takes pieces off the front of a text.
struct Reader {
  std::string_view rest;

  bool take(char c) {
    if (rest.empty() || rest.front() != c) return false;
    rest.remove_prefix(1);
    return true;
  }
  // Exactly so many digits.
  std::optional<int> digits(std::size_t count) {
    if (rest.size() < count) return std::nullopt;
    int value = 0;
    for (const char c : rest.substr(0, count)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = value * 10 + (c - '0');
    }
    rest.remove_prefix(count);
    return value;
  }
};

std::string outside(const char* what, int value, int most) {
  return std::string("has ") + what + " " + std::to_string(value) + ", which is not within 0 to " +
         std::to_string(most);
}

// "12:00", "12:00:00", "12:00:00.25": milliseconds of the day.
std::string readTime(Reader& reader, std::int64_t& ms) {
  const std::optional<int> hour = reader.digits(2);
  if (!hour || !reader.take(':')) return kForm;
  const std::optional<int> minute = reader.digits(2);
  if (!minute) return kForm;
  int second = 0, thousandths = 0;
  if (reader.take(':')) {
    const std::optional<int> given = reader.digits(2);
    if (!given) return kForm;
    second = *given;
    if (reader.take('.')) {
      int weight = 100, count = 0;
      for (; !reader.rest.empty() && reader.rest[0] >= '0' && reader.rest[0] <= '9'; ++count, weight /= 10) {
        thousandths += weight * (reader.rest[0] - '0');
        reader.rest.remove_prefix(1);
      }
      if (count == 0) return kForm;
    }
  }
  if (*hour > 23) return outside("hour", *hour, 23);
  if (*minute > 59) return outside("minute", *minute, 59);
  if (second == 60) return "has second 60: leap seconds are not counted";
  if (second > 59) return outside("second", second, 59);
  ms = ((*hour * 60 + *minute) * 60 + second) * std::int64_t{1000} + thousandths;
  return "";
}

// "Z", "+02:00", or nothing: how far the clock is ahead of UTC.
std::string readZone(Reader& reader, std::int64_t& ms) {
  ms = 0;
  if (reader.rest.empty() || reader.take('Z') || reader.take('z')) return "";
  const bool ahead = reader.take('+');
  if (!ahead && !reader.take('-')) return kForm;
  const std::optional<int> hours = reader.digits(2);
  if (!hours) return kForm;
  const bool more = reader.take(':') || !reader.rest.empty();
  const std::optional<int> minutes = more ? reader.digits(2) : std::optional(0);
  if (!minutes) return kForm;
  if (*hours > 18) return outside("a zone with hour", *hours, 18);
  if (*minutes > 59) return outside("a zone with minute", *minutes, 59);
  ms = (*hours * 60 + *minutes) * std::int64_t{60'000} * (ahead ? 1 : -1);
  return "";
}

std::string yearReason(int year) {
  return "is in the year " + std::to_string(year) + ", which is not within " + std::to_string(kFirstYear) +
         " to " + std::to_string(kLastYear);
}

// Terrestrial time less universal time at the beginning of a year. To 2025 IERS and the tables of Espenak and
// Meeus; 2050 is a guess between "as it is" and their parabola, which reality has left behind since 2005.
struct DeltaT {
  double year, seconds;
};
constexpr DeltaT kDeltaT[] = {
    {1000, 1570},  {1100, 1090},  {1200, 740},   {1300, 490},   {1400, 320},   {1500, 200},   {1600, 120},
    {1700, 9},     {1750, 13},    {1800, 14},    {1850, 7},     {1900, -3},    {1910, 10.4},  {1920, 21.2},
    {1930, 24.0},  {1940, 24.3},  {1950, 29.07}, {1955, 31.07}, {1960, 33.15}, {1965, 35.73}, {1970, 40.18},
    {1975, 45.48}, {1980, 50.54}, {1985, 54.34}, {1990, 56.86}, {1995, 60.78}, {2000, 63.83}, {2005, 64.69},
    {2010, 66.07}, {2015, 67.64}, {2020, 69.36}, {2025, 69.14}, {2050, 71.5},  {2100, 110},   {2200, 442},
    {2500, 1460},  {3000, 4436},
};

}  // namespace

const Instant kFirstInstant{dayNumber(kFirstYear, 1, 1) * kMsPerDay};
const Instant kLastInstant{dayNumber(kLastYear + 1, 1, 1) * kMsPerDay - 1};

bool isAccurate(Instant instant) {
  return instant.utcMs >= dayNumber(kFirstAccurateYear, 1, 1) * kMsPerDay &&
         instant.utcMs < dayNumber(kLastAccurateYear + 1, 1, 1) * kMsPerDay;
}

std::string readInstant(std::string_view text, Instant& instant) {
  Reader reader{text};
  const std::optional<int> year = reader.digits(4);
  if (!year || !reader.take('-')) return kForm;
  const std::optional<int> month = reader.digits(2);
  if (!month || !reader.take('-')) return kForm;
  const std::optional<int> day = reader.digits(2);
  if (!day) return kForm;
  std::int64_t timeMs = 0, zoneMs = 0;
  if (!reader.rest.empty()) {
    if (!reader.take('T') && !reader.take('t') && !reader.take(' ')) return kForm;
    if (std::string reason = readTime(reader, timeMs); !reason.empty()) return reason;
    if (std::string reason = readZone(reader, zoneMs); !reason.empty()) return reason;
    if (!reader.rest.empty()) return kForm;
  }
  if (*year < kFirstYear || *year > kLastYear) return yearReason(*year);
  if (*month < 1 || *month > 12) {
    return "has month " + std::to_string(*month) + ", which is not within 1 to 12";
  }
  if (const int days = daysOfMonth(*year, *month); *day < 1 || *day > days) {
    return "has day " + std::to_string(*day) + ", but " +
           std::string(kMonths[static_cast<std::size_t>(*month - 1)]) + " " + std::to_string(*year) +
           " has " + std::to_string(days) + " days";
  }
  const Instant read{dayNumber(*year, static_cast<unsigned>(*month), static_cast<unsigned>(*day)) *
                         kMsPerDay +
                     timeMs - zoneMs};
  if (read < kFirstInstant) return yearReason(kFirstYear - 1);
  if (read > kLastInstant) return yearReason(kLastYear + 1);
  instant = read;
  return "";
}

Instant parseInstant(std::string_view text) {
  Instant instant;
  const std::string reason = readInstant(text, instant);
  if (!reason.empty()) throw core::RangeError("'" + std::string(text) + "' " + reason);
  return instant;
}

std::string instantText(Instant instant) {
  const std::int64_t ms = std::clamp(instant.utcMs, kFirstInstant.utcMs, kLastInstant.utcMs);
  const std::int64_t days = ms >= 0 ? ms / kMsPerDay : -((kMsPerDay - 1 - ms) / kMsPerDay);
  const auto ofDay = static_cast<int>(ms - days * kMsPerDay);
  const std::chrono::year_month_day date{std::chrono::sys_days(std::chrono::days(days))};
  char text[64];
  int length =
      std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02d", static_cast<int>(date.year()),
                    static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), ofDay / 3'600'000,
                    ofDay / 60'000 % 60, ofDay / 1000 % 60);
  std::string written(text, static_cast<std::size_t>(length));
  if (ofDay % 1000 != 0) {
    length = std::snprintf(text, sizeof text, ".%03d", ofDay % 1000);
    written.append(text, static_cast<std::size_t>(length));
  }
  return written + "Z";
}

const core::WrittenForm kInstantForm = {
    .write =
        [](double value) {
          const double first = static_cast<double>(kFirstInstant.utcMs),
                       last = static_cast<double>(kLastInstant.utcMs);
          return instantText({static_cast<std::int64_t>(std::clamp(value, first, last))});
        },
    .read =
        [](std::string_view text, double& value) {
          Instant instant;
          std::string reason = readInstant(text, instant);
          if (reason.empty()) value = static_cast<double>(instant.utcMs);
          return reason;
        }};

double julianDate(Instant instant) { return daysSinceJ2000(instant) + 2451545.0; }

double daysSinceJ2000(Instant instant, double secondsLater) {
  return (static_cast<double>(instant.utcMs - kJ2000Ms) + secondsLater * 1000) /
         static_cast<double>(kMsPerDay);
}

Instant instantAt(double daysSinceJ2000) {
  const double first = static_cast<double>(kFirstInstant.utcMs - kJ2000Ms),
               last = static_cast<double>(kLastInstant.utcMs - kJ2000Ms);
  const double ms = std::floor(daysSinceJ2000 * static_cast<double>(kMsPerDay) + 0.5);
  return {static_cast<std::int64_t>(std::clamp(ms, first, last)) + kJ2000Ms};
}

double deltaTSeconds(double daysSinceJ2000) {
  const double year = 2000 + daysSinceJ2000 / 365.25;
  const auto* after = std::upper_bound(std::begin(kDeltaT), std::end(kDeltaT), year,
                                       [](double y, const DeltaT& row) { return y < row.year; });
  if (after == std::begin(kDeltaT)) return std::begin(kDeltaT)->seconds;
  if (after == std::end(kDeltaT)) return std::prev(after)->seconds;
  const DeltaT &a = *std::prev(after), &b = *after;
  return a.seconds + (b.seconds - a.seconds) * (year - a.year) / (b.year - a.year);
}

}  // namespace skydrop::sky
