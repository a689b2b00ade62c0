#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "elevation/readers.h"
#include "elevation/text_scan.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/hash.h"
#include "skydrop/elevation/projection.h"

namespace skydrop::elevation {
namespace {

// Of files beside others that have no place of their own.
constexpr const char* kSystemEnding = ".prj";
constexpr std::array kWorldFileEndings{".pgw", ".pngw", ".jgw", ".jpgw", ".tfw", ".wld"};

using core::DataError;

constexpr std::size_t kMostTextBytes = std::size_t{512} << 20;

std::shared_ptr<const Raster> readText(const std::filesystem::path& file, std::string_view text) {
  const std::string name = file.string();
  if (text.substr(0, 4096).find('\0') != std::string_view::npos)
    throw DataError(name, "", "is no elevation file: none of SRTM, GeoTIFF, ESRI ASCII, XYZ, PNG");
  const auto crs = crsBeside(file);
  return looksLikeEsriAscii(text) ? readEsriAscii(name, text, crs) : readXyz(name, text, crs);
}

std::shared_ptr<const Raster> openAsItIs(const std::filesystem::path& file) {
  const std::string head = core::readFileStart(file, 1024);
  const auto begins = [&](std::string_view with) { return head.starts_with(with); };
  if (isTiff(head)) return openGeoTiff(file);
  if (begins("\x89PNG")) return readHeightPng(file, core::readFile(file), crsBeside(file));
  if (begins("PK")) {
    Unpacked inner = unpackZip(file);
    if (isSrtmName(inner.name)) return readSrtm(file.string(), inner.name, std::move(inner.bytes));
    return readText(file, {reinterpret_cast<const char*>(inner.bytes.data()), inner.bytes.size()});
  }
  if (isSrtmName(file.filename().string())) return openSrtm(file);
  if (head.empty()) throw DataError(file.string(), "", "is empty");
  return readText(file, core::readTextFile(file, kMostTextBytes));
}

// Metres that a cell has at least along its shorter side.
double finenessOf(const Raster& raster) {
  const Georeference& place = raster.georeference();
  const double shorter = std::min(place.cell.x, place.cell.y);
  if (!isGeographic(place.crs, raster.name())) return shorter;
  constexpr double kMetresPerDegree = 111320, kRadians = 0.017453292519943295;
  // Near a pole columns have no width: there rows decide.
  const double latitude = std::min(std::abs(centreOf(place, 0, 0.5 * raster.height()).y), 80.0);
  return kMetresPerDegree * std::min(place.cell.y, place.cell.x * std::cos(latitude * kRadians));
}

}  // namespace

bool isTiff(std::string_view head) {
  const auto begins = [&](const char* with) { return head.starts_with(std::string_view(with, 4)); };
  return begins("II*\0") || begins("MM\0*") || begins("II+\0") || begins("MM\0+");
}

std::optional<std::string> guessedCrs(glm::dvec2 lowest, glm::dvec2 highest) {
  const auto isWithin = [&](double west, double south, double east, double north) {
    return lowest.x >= west && lowest.y >= south && highest.x <= east && highest.y <= north;
  };
  if (isWithin(-181, -90, 361, 90)) return "EPSG:4326";
  if (isWithin(2480000, 1070000, 2840000, 1300000)) return "EPSG:2056";
  return std::nullopt;
}

std::vector<std::filesystem::path> filesBeside(const std::filesystem::path& file) {
  std::vector<std::filesystem::path> files;
  const auto add = [&](const char* ending) {
    files.emplace_back(file).replace_extension(ending);
    if (files.back() == file) files.pop_back();
  };
  add(kSystemEnding);
  for (const char* ending : kWorldFileEndings) add(ending);
  return files;
}

std::optional<std::string> crsBeside(const std::filesystem::path& file) {
  std::filesystem::path beside = file;
  beside.replace_extension(kSystemEnding);
  std::error_code error;
  if (!std::filesystem::is_regular_file(beside, error)) return std::nullopt;
  std::string text = core::readTextFile(beside, std::size_t{64} << 10);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
  if (text.empty()) throw DataError(beside.string(), "", "is empty");
  return text;
}

std::optional<Georeference> worldFileBeside(const std::filesystem::path& file) {
  for (const char* ending : kWorldFileEndings) {
    std::filesystem::path beside = file;
    beside.replace_extension(ending);
    std::error_code error;
    if (!std::filesystem::is_regular_file(beside, error)) continue;
    const std::string text = core::readTextFile(beside, std::size_t{4} << 10);
    TextScan scan(text);
    std::array<double, 6> values{};
    for (double& value : values) {
      scan.skip(true);
      const auto number = scan.atEnd() ? std::nullopt : scan.number();
      if (!number || !std::isfinite(*number))
        throw DataError(beside.string(), "line " + std::to_string(scan.line()), "is not one of six numbers");
      value = *number;
    }
    if (values[1] != 0 || values[2] != 0) throw DataError(beside.string(), "", "the picture is rotated");
    if (!(values[0] > 0) || !(values[3] < 0)) throw DataError(beside.string(), "", "cells have no size");
    return Georeference{"", {values[4], values[5]}, {values[0], -values[3]}};
  }
  return std::nullopt;
}

std::uint64_t contentDigest(const std::filesystem::path& file) {
  const std::vector<std::byte> bytes = core::readFile(file, std::size_t{4} << 30);
  core::StateHasher hasher;
  hasher.add(static_cast<std::uint64_t>(bytes.size()));
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    hasher.add(word);
  }
  return hasher.value();
}

std::shared_ptr<const Raster> openRaster(const std::filesystem::path& file) {
  std::shared_ptr<const Raster> raster = openAsItIs(file);
  // A hair is taken off, so that 0.5 m as a decimal fraction of a degree is averaged like 0.5 m.
  const double times = std::floor(kFinestCellM / finenessOf(*raster) + 1e-6);
  if (times < 2) return raster;
  if (times > 1024) throw DataError(file.string(), "cells", "are smaller than 2 mm");
  return averaged(std::move(raster), static_cast<int>(times));
}

}  // namespace skydrop::elevation
