// Answers of weather services, made for a test.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace skydrop::test {

// An answer of meteoblue of these local times, with arrays of the same length added by `set`.
struct WeatherAnswer {
  nlohmann::json root = {{"metadata", {{"utc_timeoffset", 0}, {"height", 500}}},
                         {"units", {{"time", "YYYY-MM-DD hh:mm"}, {"windspeed", "ms-1"}}},
                         {"data_1h", nlohmann::json::object()}};

  explicit WeatherAnswer(const std::vector<std::string>& times) { root["data_1h"]["time"] = times; }
  WeatherAnswer& set(const std::string& name, const nlohmann::json& values) {
    root["data_1h"][name] = values;
    return *this;
  }
  std::string text() const { return root.dump(); }
};

}  // namespace skydrop::test
