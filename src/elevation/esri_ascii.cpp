// ESRI ASCII grids: a header of words and numbers, then rows from north.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "elevation/readers.h"
#include "elevation/text_scan.h"
#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

std::string lower(std::string_view word) {
  std::string out(word);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

struct Header {
  std::optional<double> columns, rows, cornerX, cornerY, centreX, centreY, cell;
  double nodata = -9999;
};

std::optional<double>* memberOf(Header& header, const std::string& word) {
  if (word == "ncols") return &header.columns;
  if (word == "nrows") return &header.rows;
  if (word == "xllcorner") return &header.cornerX;
  if (word == "yllcorner") return &header.cornerY;
  if (word == "xllcenter") return &header.centreX;
  if (word == "yllcenter") return &header.centreY;
  if (word == "cellsize") return &header.cell;
  return nullptr;
}

Header readHeader(TextScan& scan, const std::string& name) {
  Header header;
  for (scan.skip(true); !scan.atEnd() && std::isalpha(static_cast<unsigned char>(*scan.peek()));
       scan.skip(true)) {
    const std::string line = "line " + std::to_string(scan.line());
    const std::string word = lower(scan.word());
    scan.skip(false);
    const auto value = scan.number();
    if (!value) throw DataError(name, line, word + " has no number");
    if (word == "nodata_value")
      header.nodata = *value;
    else if (std::optional<double>* member = memberOf(header, word))
      *member = *value;
    else
      throw DataError(name, line, "unknown word " + word);
  }
  return header;
}

int sideOf(const std::optional<double>& value, const std::string& name, const char* word) {
  if (!value || *value != std::floor(*value) || *value < 1 || *value > kMostSide)
    throw DataError(name, word, "must be a whole number of 1 to " + std::to_string(kMostSide));
  return static_cast<int>(*value);
}

}  // namespace

bool looksLikeEsriAscii(std::string_view text) {
  TextScan scan(text.substr(0, 256));
  scan.skip(true);
  const std::string word = lower(scan.word());
  return word == "ncols" || word == "nrows";
}

std::shared_ptr<const Raster> readEsriAscii(const std::string& name, std::string_view text,
                                            const std::optional<std::string>& crs) {
  TextScan scan(text);
  const Header header = readHeader(scan, name);
  const int columns = sideOf(header.columns, name, "ncols"), rows = sideOf(header.rows, name, "nrows");
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  if (count > kMostHeldCells)
    throw DataError(name, "size",
                    std::to_string(columns) + " x " + std::to_string(rows) +
                        " cells: a text may have 2^24; write a GeoTIFF in tiles");
  if (text.size() <
      2 * count - 1)  // a digit and what parts it from the next, each: before anything is allocated
    throw DataError(name, "", "is cut off: it has not as many numbers as cells");
  if (!header.cell || !(*header.cell > 0)) throw DataError(name, "cellsize", "must be above 0");
  const double half = *header.cell / 2;
  const bool hasX = header.cornerX || header.centreX, hasY = header.cornerY || header.centreY;
  if (!hasX || !hasY) throw DataError(name, "xllcorner, yllcorner", "are missing");
  const double west = header.cornerX ? *header.cornerX + half : *header.centreX;
  const double south = header.cornerY ? *header.cornerY + half : *header.centreY;
  Georeference place{"", {west, south + (rows - 1) * *header.cell}, {*header.cell, *header.cell}};
  const auto guess = guessedCrs({west, south}, centreOf(place, columns - 1, 0));
  if (!crs && !guess)
    throw DataError(name, "reference system", "is not told by the coordinates: put a .prj file beside it");
  place.crs = crs.value_or(guess.value_or(""));
  std::vector<float> heights;
  heights.reserve(count);
  while (heights.size() < count) {
    scan.skip(true);
    const std::string line = "line " + std::to_string(scan.line());
    if (scan.atEnd())
      throw DataError(
          name, line,
          "is cut off: there are " + std::to_string(heights.size()) + " heights of " + std::to_string(count));
    const auto value = scan.number();
    if (!value) throw DataError(name, line, "is no height");
    heights.push_back(*value == header.nodata ? heightOrVoid(NAN) : heightOrVoid(*value));
  }
  scan.skip(true);
  if (!scan.atEnd())
    throw DataError(name, "line " + std::to_string(scan.line()), "there is more than ncols x nrows heights");
  return makeHeldRaster(name, "ESRI ASCII", columns, rows, place, std::move(heights));
}

}  // namespace skydrop::elevation
