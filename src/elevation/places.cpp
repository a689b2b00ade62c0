#include "skydrop/elevation/places.h"

#include <set>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/json.h"

namespace skydrop::elevation {

using core::DataError;
using nlohmann::json;

std::vector<NamedPlace> readPlaces(const std::filesystem::path& path) {
  const std::string file = path.string();
  const json root = core::parseJson(core::readTextFile(path, std::size_t{1} << 20), file);
  if (!root.is_object()) throw DataError(file, "places", "is not an object");
  if (!root.contains("schema") || root["schema"] != 1) throw DataError(file, "schema", "is not 1");
  if (!root.contains("places") || !root["places"].is_array() || root.size() != 2)
    throw DataError(file, "places", "is not a list beside the schema, and nothing else");
  std::vector<NamedPlace> places;
  std::set<std::string> names;
  for (const json& entry : root["places"]) {
    const std::string at = "places[" + std::to_string(places.size()) + "]";
    if (!entry.is_object()) throw DataError(file, at, "is not an object");
    if (places.size() == 10000) throw DataError(file, "places", "there are more than 10000");
    NamedPlace place;
    for (const auto& [name, value] : entry.items()) {
      const std::string where = at + "." + name;
      if (name == "name")
        place.name = core::jsonText(value, file, where);
      else if (name == "latitude")
        place.place.latitude = core::jsonNumber(value, file, where, -90, 90);
      else if (name == "longitude")
        place.place.longitude = core::jsonNumber(value, file, where, -180, 180);
      else if (name == "heightM")
        place.heightM = core::jsonNumber(value, file, where, 0, 1e5);
      else
        throw DataError(file, where, "unknown member");
    }
    if (!entry.contains("latitude") || !entry.contains("longitude"))
      throw DataError(file, at, "has no latitude and longitude");
    if (place.name.empty() || place.name.find(',') != std::string::npos)
      throw DataError(file, at + ".name", "is empty or has a comma");
    if (!names.insert(place.name).second) throw DataError(file, at + ".name", "comes twice: " + place.name);
    places.push_back(std::move(place));
  }
  return places;
}

}  // namespace skydrop::elevation
