// skydrop elevation check: what elevation files are, where they lie, what they lack, and heights at places.
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "skydrop/core/message.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/elevation/survey.h"
#include "skydrop/terrain/analytic_height_sources.h"

namespace skydrop::app {
namespace {

using Json = nlohmann::ordered_json;
using elevation::GeoPlace;
using elevation::Projection;
using elevation::Raster;

Json fileJson(const Raster& raster) {
  const elevation::Survey survey(raster);
  const elevation::Georeference& place = raster.georeference();
  const Projection projection(place.crs, raster.name());
  const glm::dvec2 southWest = centreOf(place, -0.5, raster.height() - 0.5);
  const glm::dvec2 northEast = centreOf(place, raster.width() - 0.5, -0.5);
  const GeoPlace centre = elevation::centreOf(raster);
  return {{"file", core::printable(raster.name())},
          {"form", raster.form()},
          {"columns", raster.width()},
          {"rows", raster.height()},
          {"referenceSystem", core::printable(projection.title())},
          {"unit", projection.isGeographic() ? "degrees" : "m"},
          {"cell", {place.cell.x, place.cell.y}},
          {"west", southWest.x},
          {"south", southWest.y},
          {"east", northEast.x},
          {"north", northEast.y},
          {"centre", {{"latitude", centre.latitude}, {"longitude", centre.longitude}}},
          {"lowestM", survey.all().lowest},
          {"highestM", survey.all().highest},
          {"voids", survey.voids()}};
}

Json heightsJson(const ElevationRequest& request, const std::vector<std::shared_ptr<const Raster>>& rasters) {
  Json heights = Json::array();
  const Projection projection(rasters[0]->georeference().crs, rasters[0]->name());
  for (const glm::dvec2& at : request.at) {
    const bool isDegrees = std::abs(at.x) <= 90 && std::abs(at.y) <= 360;
    const std::optional<GeoPlace> place = isDegrees ? GeoPlace{at.x, at.y} : projection.inverse(at);
    Json height = {{"at", {at.x, at.y}}};
    if (!place) {
      height["heightM"] = nullptr;
      heights.push_back(height);
      continue;
    }
    height["latitude"] = place->latitude;
    height["longitude"] = elevation::turnedNear(place->longitude, 0);
    if (const auto xy = projection.forward(*place)) height["inFirstSystem"] = {xy->x, xy->y};
    height["heightM"] = nullptr;
    // The place is the origin of a land of its own, so that none is too far away.
    std::vector<std::shared_ptr<const Raster>> near;
    for (const auto& raster : rasters) {
      if (elevation::holds(*raster, *place)) near.push_back(raster);
    }
    if (!near.empty()) {
      const auto land = elevation::makeElevationHeightSource(
          near, {false, place->latitude, place->longitude, 1}, terrain::makeFlatSource(0));
      if (land->hasData({0, 0})) height["heightM"] = land->height({0, 0});
    }
    heights.push_back(height);
  }
  return heights;
}

void printFile(const Json& file) {
  const bool degrees = file["unit"] == "degrees";
  const int digits = degrees ? 6 : 1;
  print("%s: %s\n", file["file"].get<std::string>().c_str(), file["form"].get<std::string>().c_str());
  print("  %s, %d x %d cells of %.*g x %.*g %s\n", file["referenceSystem"].get<std::string>().c_str(),
        file["columns"].get<int>(), file["rows"].get<int>(), 6, file["cell"][0].get<double>(), 6,
        file["cell"][1].get<double>(), degrees ? "degrees" : "m");
  print("  %s %.*f to %.*f, %s %.*f to %.*f; centre %.6f, %.6f\n", degrees ? "longitude" : "east", digits,
        file["west"].get<double>(), digits, file["east"].get<double>(), degrees ? "latitude" : "north",
        digits, file["south"].get<double>(), digits, file["north"].get<double>(),
        file["centre"]["latitude"].get<double>(), file["centre"]["longitude"].get<double>());
  const double cells = file["columns"].get<double>() * file["rows"].get<double>();
  const double voids = file["voids"].get<double>();
  print("  %.2f to %.2f m, %.0f voids (%.2f %%)\n", file["lowestM"].get<double>(),
        file["highestM"].get<double>(), voids, 100 * voids / cells);
}

}  // namespace

int checkElevation(const CommandLine& line) {
  std::vector<std::shared_ptr<const Raster>> rasters;
  Json files = Json::array();
  for (const std::filesystem::path& file : line.elevation.files) {
    rasters.push_back(elevation::openRaster(file));
    files.push_back(fileJson(*rasters.back()));
    rasters.back()->rest();
    if (!line.asJson) printFile(files.back());
  }
  const Json heights = heightsJson(line.elevation, rasters);
  if (line.asJson) {
    print("%s\n", Json({{"files", files}, {"heights", heights}}).dump(2).c_str());
    return 0;
  }
  for (const Json& height : heights) {
    print("%.10g, %.10g: ", height["at"][0].get<double>(), height["at"][1].get<double>());
    if (height["heightM"].is_null())
      print("no data\n");
    else
      print("%.2f m\n", height["heightM"].get<double>());
  }
  return 0;
}

}  // namespace skydrop::app
