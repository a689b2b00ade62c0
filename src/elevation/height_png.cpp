// Heights in the colours of a PNG: terrain-RGB (h = -10000 + 0.1 (65536 R + 256 G + B)) and Terrarium
// (h = 256 R + G + B / 256 - 32768).
#include <charconv>
#include <cmath>
#include <numbers>

#include "elevation/readers.h"
#include "skydrop/core/error.h"
#include "skydrop/core/image.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

// The highest and lowest land, with half a kilometre to spare: no height of one form is inside it when it is
// read as the other, since 500 m are R = 1 in one and R = 129 in the other.
constexpr double kLowest = -11500, kHighest = 9000;

double terrainRgb(const std::uint8_t* p) { return -10000 + 0.1 * (65536 * p[0] + 256 * p[1] + p[2]); }
double terrarium(const std::uint8_t* p) { return 256 * p[0] + p[1] + p[2] / 256.0 - 32768; }

double shareInside(const core::Image& image, double (*heightOf)(const std::uint8_t*)) {
  std::size_t inside = 0, all = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    if (image.rgba[i + 3] == 0) continue;
    const double height = heightOf(image.rgba.data() + i);
    inside += height >= kLowest && height <= kHighest;
    ++all;
  }
  return all > 0 ? static_cast<double>(inside) / static_cast<double>(all) : 1;
}

// Of .../z/x/y.png: a tile of the web's maps (EPSG:3857).
std::optional<Georeference> tileOf(const std::filesystem::path& file, const core::Image& image) {
  const auto whole = [](const std::string& text) -> std::optional<int> {
    int value = 0;
    const auto [past, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || past != text.data() + text.size() || value < 0) return std::nullopt;
    return value;
  };
  const auto y = whole(file.stem().string()), x = whole(file.parent_path().filename().string());
  const auto z = whole(file.parent_path().parent_path().filename().string());
  if (!x || !y || !z || *z > 24 || *x >= 1 << *z || *y >= 1 << *z) return std::nullopt;
  const double half = std::numbers::pi * 6378137, side = 2 * half / (1 << *z);
  const glm::dvec2 cell{side / image.width, side / image.height};
  return Georeference{"EPSG:3857", {-half + *x * side + cell.x / 2, half - *y * side - cell.y / 2}, cell};
}

}  // namespace

std::shared_ptr<const Raster> readHeightPng(const std::filesystem::path& file,
                                            std::span<const std::byte> bytes,
                                            const std::optional<std::string>& crs) {
  const std::string name = file.string();
  const core::Image image = core::decodePng(bytes, name);
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (count > kMostHeldCells) throw DataError(name, "size", "more than 2^24 cells");
  const double asRgb = shareInside(image, terrainRgb), asTerrarium = shareInside(image, terrarium);
  if (std::max(asRgb, asTerrarium) < 0.99)
    throw DataError(name, "colours",
                    "are neither terrain-RGB nor Terrarium: most heights are none of this earth");
  const auto heightOf = asTerrarium > asRgb ? terrarium : terrainRgb;
  std::optional<Georeference> place = tileOf(file, image);
  if (auto world = worldFileBeside(file)) {
    place = world;
    const glm::dvec2 south = centreOf(*place, 0, image.height - 1),
                     east = centreOf(*place, image.width - 1, 0);
    const auto guess = guessedCrs({place->first.x, south.y}, {east.x, place->first.y});
    if (!crs && !guess)
      throw DataError(name, "reference system", "is not told by the coordinates: put a .prj file beside it");
    place->crs = crs.value_or(guess.value_or(""));
  }
  if (!place)
    throw DataError(name, "georeference",
                    "there is no world file (.pgw) beside it, and its path is not z/x/y.png");
  std::vector<float> heights(count);
  for (std::size_t i = 0; i < count; ++i)
    heights[i] =
        image.rgba[4 * i + 3] == 0 ? heightOrVoid(NAN) : heightOrVoid(heightOf(image.rgba.data() + 4 * i));
  return makeHeldRaster(name, asTerrarium > asRgb ? "PNG, Terrarium" : "PNG, terrain-RGB", image.width,
                        image.height, *place, std::move(heights));
}

}  // namespace skydrop::elevation
