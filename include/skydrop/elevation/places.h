// Places with names, from a file: a JSON object {"schema": 1, "places": [{"name": "Gurten", "latitude": 46.9,
// "longitude": 7.4, "heightM": 20}, ..]}; heightM, above the ground, may be missing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/elevation/projection.h"

namespace skydrop::elevation {

struct NamedPlace {
  std::string name;
  GeoPlace place;
  std::optional<double> heightM;  // of an eye there, above the ground, [0, 1e5]
};

// At most 10 000, each name once. Throws core::DataError.
std::vector<NamedPlace> readPlaces(const std::filesystem::path& file);

}  // namespace skydrop::elevation
