// The arrays of an answer: as many values as there are times, nulls among them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "forecast/units.h"
#include "skydrop/forecast/report.h"

namespace skydrop::forecast {

// An object's member, null where there is none.
const nlohmann::json* member(const nlohmann::json& object, std::string_view name);

class HourlyTable {
 public:
  // `root` and the texts outlive it. `group` is the object of the arrays ("hourly"), `units` that of their
  // units, by the same names. Throws core::DataError where the group is none, or has no times.
  HourlyTable(const nlohmann::json& root, std::string_view file, std::string_view group,
              std::string_view units);

  const nlohmann::json& times() const { return *times_; }

  // The name of the first of these arrays that is there; empty without.
  std::string first(std::initializer_list<std::string> names) const;
  // The array of this name, or null without. Throws core::DataError where it is none, or of another length.
  const nlohmann::json* array(std::string_view name) const;
  // Its unit, or another's where the file names none.
  std::string unitOf(std::string_view name, std::string_view otherwise) const;

  // Writes the values of an array that is there to the hours, by its unit, where they have none yet. Values
  // outside [least, most], as SI, are refused.
  void read(std::vector<Hour>& hours, Quantity quantity, std::string_view name, const Unit& unit,
            double least, double most) const;
  void readDirections(std::vector<Hour>& hours, std::string_view name) const;

  std::string placeOf(std::string_view name, std::size_t index) const;
  std::string_view file() const { return file_; }

 private:
  std::string_view file_, group_;
  const nlohmann::json* arrays_ = nullptr;
  const nlohmann::json* units_ = nullptr;
  const nlohmann::json* times_ = nullptr;
};

}  // namespace skydrop::forecast
