#include "app/cli/elevation_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/trigonometric.hpp>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/nearest_names.h"
#include "skydrop/elevation/places.h"

namespace skydrop::app {
namespace {

using core::UsageError;

std::vector<std::string> partsOf(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

// A name, or degrees; with a height at the end where `hasHeight` says so.
PlaceRequest placeOf(const std::string& flag, const std::string& text, bool hasHeight) {
  const std::vector<std::string> parts = partsOf(text);
  const bool isNamed = !parts[0].empty() && !wholeText<double>(parts[0]);
  const std::size_t words = isNamed ? 1 : 2;
  if (parts.size() < words || parts.size() > words + (hasHeight ? 1 : 0))
    throw UsageError(flag + ": '" + text + "' is not of the form LAT,LON" + (hasHeight ? "[,HEIGHT]" : "") +
                     ", and no name of a place");
  PlaceRequest request;
  if (isNamed) {
    const std::vector<elevation::NamedPlace> places = elevation::readPlaces(core::assetPath("places.json"));
    std::vector<std::string_view> names;
    for (const elevation::NamedPlace& place : places) names.emplace_back(place.name);
    const auto found = std::ranges::find(names, std::string_view(parts[0]));
    if (found == names.end())
      throw UsageError(flag + ": there is no place '" + parts[0] + "'" + core::nearestText(parts[0], names));
    const elevation::NamedPlace& place = places[static_cast<std::size_t>(found - names.begin())];
    request = {place.place, hasHeight ? place.heightM : std::nullopt};
  } else {
    request.place = {number(flag, parts[0], -90, 90), number(flag, parts[1], -180, 180)};
  }
  if (parts.size() > words) request.heightM = number(flag, parts[words], 0, 1e5);
  return request;
}

std::string row(const char* path, double value) {
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%s=%.9f", path, value);
  return text.data();
}

}  // namespace

void ElevationFlags::addLand(CLI::App& verb, CommandLine& line, bool views) {
  addFiles(
      verb, "--elevation", "--elevation",
      "land of elevation data: SRTM, GeoTIFF, ESRI ASCII, XYZ, terrain-RGB, Terrarium; several files are "
      "one land",
      line.elevationFiles)
      ->type_name("FILE..")
      ->expected(1, 1000);
  addText(
      verb, "--place", "LAT,LON|NAME[,HEIGHT]",
      "what lies at the world's origin, in degrees or by a name of assets/places.json; the sky is that of "
      "there. With a HEIGHT above the ground, or with --look-at, a camera stands there",
      [&line](const std::string& t) { line.start = placeOf("--place", t, true); });
  if (!views) return;
  addFiles(
      verb, "--image", "--image",
      "colours of the land from above: GeoTIFF, or PNG or JPEG with a world file beside it; of several the "
      "first has the say",
      line.imageFiles)
      ->type_name("FILE..")
      ->expected(1, 1000);
  addText(verb, "--image-corners", "W,S,E,N",
          "of one --image as PNG or JPEG: where its edges are, in degrees or LV95",
          [&line](const std::string& t) {
            const std::vector<std::string> parts = partsOf(t);
            if (parts.size() != 4)
              throw UsageError("--image-corners: '" + t + "' is not of the form W,S,E,N");
            const auto part = [&](std::size_t i) { return number("--image-corners", parts[i], -1e9, 1e9); };
            line.imageCorners = {part(0), part(1), part(2), part(3)};
          });
  addText(verb, "--look-at", "LAT,LON|NAME", "of --place: where the camera looks, level",
          [&line](const std::string& t) { line.lookAt = placeOf("--look-at", t, false).place; });
}

void ElevationFlags::addCheck(CLI::App& verb, CommandLine& line) {
  verb.add_option_function<std::string>(
          "WHAT",
          [](const std::string& t) {
            if (t != "check") throw UsageError("elevation: '" + t + "' is not check");
          },
          "check: extent, reference system, cell size and voids of each file")
      ->required();
  addFiles(verb, "FILE", "elevation", "elevation files", line.elevation.files)->expected(1, 1000);
  verb.add_option_function<std::vector<std::string>>(
          "--at",
          [&line](const std::vector<std::string>& all) {
            for (const std::string& text : all) {
              const std::vector<std::string> parts = partsOf(text);
              if (parts.size() != 2)
                throw UsageError("--at: '" + text + "' is not of the form LAT,LON or E,N");
              line.elevation.at.emplace_back(number("--at", parts[0], -1e9, 1e9),
                                             number("--at", parts[1], -1e9, 1e9));
            }
          },
          "the height there: degrees, or coordinates of the first file's system; may stand several times")
      ->type_name("LAT,LON|E,N")
      ->allow_extra_args(false)
      ->expected(1, 1000);
  verb.add_flag("--json", line.asJson, "as JSON");
}

void ElevationFlags::finish(CommandLine& line, bool hasCamera) const {
  if (line.lookAt && !line.start) throw UsageError("--look-at belongs to --place, which is not given");
  if (line.verb == Verb::elevation && line.elevation.files.empty())
    throw UsageError("elevation check: there is no file to check");
  if (line.imageCorners && line.imageFiles.size() != 1)
    throw UsageError("--image-corners belongs to one --image");
  if (!line.start) return;
  if (line.replay) throw UsageError("--replay brings its own place: --place cannot be given with it");
  const elevation::GeoPlace& place = line.start->place;
  const std::vector<std::string> rows = {
      "elevation.atCentre=false", row("elevation.latitude", place.latitude),
      row("elevation.longitude", place.longitude), row("render.sun.latitudeDegrees", place.latitude),
      row("render.sun.longitudeDegrees", place.longitude)};
  line.set.insert(line.set.begin(), rows.begin(), rows.end());
  const bool stands =
      (line.lookAt || line.start->heightM) && (line.verb == Verb::fly || line.verb == Verb::render);
  if (!stands) return;
  if (hasCamera) {
    if (line.lookAt) throw UsageError("--look-at and a camera exclude each other");
    return;
  }
  constexpr double kEyeM = 2;
  Pose pose{{0, line.start->heightM.value_or(kEyeM), 0}, 0, 0, 0, true};
  if (line.lookAt) {
    const glm::dvec2 to = elevation::LocalPlane(place).positionOf(*line.lookAt);
    pose.yawDegrees = glm::degrees(std::atan2(to.y, to.x));
  }
  line.pose = pose;
}

}  // namespace skydrop::app
