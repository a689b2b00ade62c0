// What a weather file says, in SI units and UTC, before anything is made of it. Plain values; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::forecast {

enum class Provider { meteoblue, openMeteo, metar };
inline constexpr std::array<std::string_view, 3> kProviderNames = {"meteoblue", "Open-Meteo", "METAR"};

// The quantities of an hour that are numbers.
enum class Quantity {
  temperatureC,     // 2 m above the ground
  dewPointC,        // there
  humidity,         // relative, 0 .. 1
  pressureHpa,      // at the sea's level
  windMps,          // 10 m above the ground
  windFromDeg,      // by compass where it comes from, [0, 360); interpolated the shorter way round
  gustMps,          // speed of the gusts there
  precipitationMm,  // of the preceding hour, as water
  convectiveMm,     // of it, from showers
  snowShare,        // of it, that falls as snow, 0 .. 1
  totalCover,       // of the sky by all clouds, 0 .. 1
  lowCover,         // by those below 2 km
  middleCover,      // by those of 2 to 7 km
  highCover,        // by those above
  visibilityM,      //
  fogProbability,   // 0 .. 1
  count_
};
inline constexpr std::size_t kQuantities = static_cast<std::size_t>(Quantity::count_);
inline constexpr std::array<std::string_view, kQuantities> kQuantityNames = {
    "temperature",    "dew point",     "humidity",
    "pressure",       "wind speed",    "wind direction",
    "gusts",          "precipitation", "convective precipitation",
    "share of snow",  "total cover",   "low cover",
    "middle cover",   "high cover",    "visibility",
    "fog probability"};

// What a code of the present weather says beyond the numbers.
struct Phenomena {
  bool thunder = false;
  bool hail = false;
  bool towers = false;  // showers, or towering clouds without rain
  bool fog = false;     // or stratus on the ground

  bool operator==(const Phenomena&) const = default;
};

struct WindAloft {
  double heightM = 0;  // above the sea
  double speedMps = 0;
  double fromDeg = 0;

  bool operator==(const WindAloft&) const = default;
};

// A layer that an observer has seen.
struct SeenLayer {
  double cover = 0;  // 0 .. 1
  double baseM = 0;  // above the ground
  bool cumulonimbus = false, toweringCumulus = false;

  bool operator==(const SeenLayer&) const = default;
};

struct Hour {
  std::int64_t utcMs = 0;
  std::array<std::optional<double>, kQuantities> values{};
  std::optional<Phenomena> phenomena;
  std::vector<WindAloft> aloft;                  // ascending
  std::optional<std::vector<SeenLayer>> layers;  // of an observation, ascending; then covers follow from them

  std::optional<double>& operator[](Quantity q) { return values[static_cast<std::size_t>(q)]; }
  const std::optional<double>& operator[](Quantity q) const { return values[static_cast<std::size_t>(q)]; }
};

struct Report {
  Provider provider = Provider::meteoblue;
  std::string file;   // as messages name it
  std::string place;  // its name or station; may be empty
  std::optional<double> latitudeDegrees, longitudeDegrees;
  double elevationM = 0;           // of the ground, above the sea
  std::vector<Hour> hours;         // times ascend strictly; at least one
  std::vector<std::string> notes;  // what was understood with a doubt, a line each
};

// Of each quantity that some hours lack: in how many.
struct Missing {
  Quantity quantity{};
  std::size_t hours = 0;
};
std::vector<Missing> missingIn(const Report& report);

// Fills what an hour lacks from the hours around it that have it: linearly in time, held before the first and
// after the last, wind the shorter way round. What no hour has stays missing.
void fillGaps(Report& report);

}  // namespace skydrop::forecast
