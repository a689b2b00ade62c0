// Elevation files of whatever form as one thing: rows and columns of heights that lie somewhere on the earth
// (docs/elevation.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

namespace skydrop::elevation {

// Where the cells of a raster lie. Rows go from north to south, columns from west to east, along the axes of
// the reference system.
struct Georeference {
  std::string crs;   // coordinate reference system, in words that PROJ understands: "EPSG:2056"
  glm::dvec2 first;  // centre of the north-western cell: east (m) or longitude (degrees), north or latitude
  glm::dvec2 cell;   // distance of centres, > 0: m or degrees
};

// What a file may hold; more is refused before anything is allocated.
inline constexpr int kMostSide = 65536;                          // cells along a side
inline constexpr std::size_t kMostCells = std::size_t{1} << 30;  // of a raster that is read in parts
inline constexpr std::size_t kMostHeldCells = std::size_t{1}
                                              << 24;  // of one that can only be held as a whole
// Heights of anything on earth, with room: what lies outside is no height, and counts as a void.
inline constexpr double kLowestHeight = -12000, kHighestHeight = 9000;  // m

// Immutable; any thread may read.
class Raster {
 public:
  virtual ~Raster() = default;

  int width() const { return width_; }    // columns, 1 .. kMostSide
  int height() const { return height_; }  // rows
  const Georeference& georeference() const { return georeference_; }
  const std::string& name() const { return name_; }  // of the file, for messages
  const std::string& form() const { return form_; }  // "SRTM", "GeoTIFF, LZW", ... for people

  // Heights of columns x rows cells from (column, row) on, which lie inside; row-major. A void is NaN, all
  // else finite and within kLowestHeight .. kHighestHeight. Throws core::DataError where the file does not
  // give them (any more).
  virtual void read(int column, int row, int columns, int rows, float* out) const = 0;

  // Rows that are best read together, because the file packs them so.
  virtual int rowsTogether() const { return 1; }

  // Bytes that it holds while nobody reads; and gives up those that it only keeps to read them faster again.
  virtual std::size_t heldBytes() const { return 0; }
  virtual void rest() const {}

 protected:
  // Throws core::DataError where size or georeference are beyond the limits.
  Raster(std::string name, std::string form, int width, int height, Georeference georeference);

 private:
  std::string name_, form_;
  int width_, height_;
  Georeference georeference_;
};

// The coordinates of a cell's centre.
inline glm::dvec2 centreOf(const Georeference& place, double column, double row) {
  return {place.first.x + column * place.cell.x, place.first.y - row * place.cell.y};
}

// Opens a file of any form that docs/elevation.md lists; what is in it decides, and for SRTM, which has
// nothing in it but heights, the name. Cells finer than kFinestCellM are averaged to that. Throws
// core::DataError.
inline constexpr double kFinestCellM = 2;
std::shared_ptr<const Raster> openRaster(const std::filesystem::path& file);

// Names of files that say where a file lies which does not say so itself, whether they exist or not: its
// world file, its reference system.
std::vector<std::filesystem::path> filesBeside(const std::filesystem::path& file);

// Of a file's content: that a replay is flown over the same land. Throws core::DataError.
std::uint64_t contentDigest(const std::filesystem::path& file);

}  // namespace skydrop::elevation
