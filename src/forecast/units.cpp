#include "forecast/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "skydrop/core/angles.h"
#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::forecast {
namespace {

struct Named {
  std::string_view name;
  Unit unit;
};

constexpr double kMpsPerKnot = 1852.0 / 3600, kMpsPerMph = 1609.344 / 3600, kMPerFoot = 0.3048;

constexpr Named kSpeeds[] = {{"ms-1", {}},          {"m/s", {}},           {"kmh", {1 / 3.6}},
                             {"km/h", {1 / 3.6}},   {"mph", {kMpsPerMph}}, {"mp/h", {kMpsPerMph}},
                             {"kn", {kMpsPerKnot}}, {"kt", {kMpsPerKnot}}, {"bft", {1, 0, true}}};
constexpr Named kTemperatures[] = {
    {"C", {}}, {"°C", {}}, {"F", {5.0 / 9, -160.0 / 9}}, {"°F", {5.0 / 9, -160.0 / 9}}, {"K", {1, -273.15}}};
constexpr Named kDepths[] = {{"mm", {}}, {"inch", {25.4}}, {"cm", {10}}};
constexpr Named kLengths[] = {{"m", {}}, {"km", {1000}}, {"ft", {kMPerFoot}}};

constexpr std::array<std::string_view, 16> kPoints = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                      "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};

Unit find(std::span<const Named> units, std::string_view name, std::string_view file,
          std::string_view place) {
  for (const Named& unit : units) {
    if (unit.name == name) return unit.unit;
  }
  throw core::DataError(file, place, "the unit '" + std::string(name) + "' is not known");
}

}  // namespace

double Unit::toSi(double value) const {
  // The scale's definition: .836 m/s times Beaufort to 3/2 (WMO, Manual on Codes).
  const double si = beaufort ? 0.836 * value * std::sqrt(value) : value * factor + offset;
  return si + 0.0;  // -0 becomes 0
}

Unit speedUnit(std::string_view name, std::string_view file, std::string_view place) {
  return find(kSpeeds, name, file, place);
}
Unit temperatureUnit(std::string_view name, std::string_view file, std::string_view place) {
  return find(kTemperatures, name, file, place);
}
Unit depthUnit(std::string_view name, std::string_view file, std::string_view place) {
  return find(kDepths, name, file, place);
}
Unit lengthUnit(std::string_view name, std::string_view file, std::string_view place) {
  return find(kLengths, name, file, place);
}

double turned(double degrees) { return core::wrappedDegrees(degrees); }

std::optional<double> compassPoint(std::string_view text) {
  const auto found = std::ranges::find(kPoints, text);
  if (found == kPoints.end()) return std::nullopt;
  return 22.5 * static_cast<double>(found - kPoints.begin());
}

double windDirection(const nlohmann::json& value, std::string_view file, std::string_view place) {
  if (!value.is_string()) return turned(core::jsonNumber(value, file, place, -360, 720));
  const auto text = value.get<std::string>();
  if (const std::optional<double> point = compassPoint(text)) return *point;
  throw core::DataError(file, place, "'" + text + "' is neither degrees nor a point of the compass");
}

}  // namespace skydrop::forecast
