// Units and numbers of weather files. What is not known is a core::DataError that names file and place.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace skydrop::forecast {

// A linear unit: SI = value * factor + offset. Beaufort is the exception.
struct Unit {
  double factor = 1, offset = 0;
  bool beaufort = false;

  double toSi(double value) const;
};

Unit speedUnit(std::string_view name, std::string_view file, std::string_view place);
Unit temperatureUnit(std::string_view name, std::string_view file, std::string_view place);
Unit depthUnit(std::string_view name, std::string_view file, std::string_view place);   // to mm
Unit lengthUnit(std::string_view name, std::string_view file, std::string_view place);  // to m

// Where a wind comes from, [0, 360): degrees as a number, or one of the 16 points of the compass ("SSE").
double windDirection(const nlohmann::json& value, std::string_view file, std::string_view place);

// The point's degrees, or nothing.
std::optional<double> compassPoint(std::string_view text);

// [0, 360)
double turned(double degrees);

}  // namespace skydrop::forecast
