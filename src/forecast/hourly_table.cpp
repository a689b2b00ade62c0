#include "forecast/hourly_table.h"

#include <array>
#include <cstdio>

#include "skydrop/core/error.h"
#include "skydrop/core/json.h"
#include "skydrop/forecast/read_report.h"

namespace skydrop::forecast {
namespace {

std::string shortText(double value) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%g", value);
  return digits.data();
}

}  // namespace

const nlohmann::json* member(const nlohmann::json& object, std::string_view name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

HourlyTable::HourlyTable(const nlohmann::json& root, std::string_view file, std::string_view group,
                         std::string_view units)
    : file_(file), group_(group), arrays_(member(root, group)), units_(member(root, units)) {
  if (!arrays_) throw core::DataError(file, group, "is missing");
  if (!arrays_->is_object()) throw core::DataError(file, group, "is not an object");
  if (units_ && !units_->is_object()) throw core::DataError(file, units, "is not an object");
  times_ = member(*arrays_, "time");
  const std::string place = std::string(group) + ".time";
  if (!times_) throw core::DataError(file, place, "is missing");
  if (!times_->is_array()) throw core::DataError(file, place, "is not a list");
  if (times_->empty()) throw core::DataError(file, place, "is empty");
  if (times_->size() > kMostHours)
    throw core::DataError(file, place, "has more than " + std::to_string(kMostHours) + " hours");
}

std::string HourlyTable::first(std::initializer_list<std::string> names) const {
  for (const std::string& name : names) {
    if (const nlohmann::json* found = member(*arrays_, name); found && !found->is_null()) return name;
  }
  return {};
}

const nlohmann::json* HourlyTable::array(std::string_view name) const {
  const nlohmann::json* found = member(*arrays_, name);
  if (!found || found->is_null()) return nullptr;
  const std::string place = std::string(group_) + "." + std::string(name);
  if (!found->is_array()) throw core::DataError(file_, place, "is not a list");
  if (found->size() != times_->size()) {
    throw core::DataError(
        file_, place,
        "has " + std::to_string(found->size()) + " values for " + std::to_string(times_->size()) + " times");
  }
  return found;
}

std::string HourlyTable::unitOf(std::string_view name, std::string_view otherwise) const {
  const nlohmann::json* unit = units_ ? member(*units_, name) : nullptr;
  if (!unit || unit->is_null()) return std::string(otherwise);
  return core::jsonText(*unit, file_, "unit of " + std::string(name));
}

std::string HourlyTable::placeOf(std::string_view name, std::size_t index) const {
  return std::string(group_) + "." + std::string(name) + "[" + std::to_string(index) + "]";
}

void HourlyTable::read(std::vector<Hour>& hours, Quantity quantity, std::string_view name, const Unit& unit,
                       double least, double most) const {
  const nlohmann::json* values = array(name);
  if (!values) return;
  constexpr double kAny = 1e12;
  for (std::size_t i = 0; i < hours.size(); ++i) {
    const nlohmann::json& value = (*values)[i];
    std::optional<double>& target = hours[i][quantity];
    if (value.is_null() || target) continue;
    const double given = value.is_number() ? value.get<double>() : -2 * kAny;
    const double si = given > -kAny && given < kAny ? unit.toSi(given) : given;
    if (si >= least && si <= most) {
      target = si;
      continue;
    }
    const std::string place = placeOf(name, i);
    core::jsonNumber(value, file_, place, -kAny, kAny);  // says what else it is
    throw core::DataError(file_, place,
                          value.dump() + " is beyond any weather: " + shortText(least) + " to " +
                              shortText(most) + " in SI units");
  }
}

void HourlyTable::readDirections(std::vector<Hour>& hours, std::string_view name) const {
  const nlohmann::json* values = array(name);
  if (!values) return;
  for (std::size_t i = 0; i < hours.size(); ++i) {
    std::optional<double>& target = hours[i][Quantity::windFromDeg];
    if ((*values)[i].is_null() || target) continue;
    target = windDirection((*values)[i], file_, placeOf(name, i));
  }
}

}  // namespace skydrop::forecast
