// Elevation files for tests, written by libtiff and by hand, never by the readers that they are for.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace skydrop::test {

struct TiffForm {
  enum class Packing { none, lzw, deflate };
  Packing packing = Packing::lzw;
  int predictor = 1;  // 1, 2, or 3 of floats
  int tileSide = 0;   // 0: strips
  int rowsPerStrip = 16;
  bool isFloat = true;      // or 16-bit whole numbers
  std::string nodata = {};  // of tag 42113; empty: none
  int epsg = 2056;          // of a map below 4000 or above 5000 ...; 4326: degrees
  bool isPoint = false;     // heights of points and not of areas
};

// Row-major from north-west; `corner` is the north-western corner of the area, or the first point.
void writeGeoTiff(const std::filesystem::path& file, int width, int height, glm::dvec2 corner,
                  glm::dvec2 cell, const std::vector<float>& heights, const TiffForm& form = {});

using HeightOf = std::function<double(double column, double row)>;
std::vector<float> heightsOf(int width, int height, const HeightOf& heightOf);

// The bytes of an SRTM tile of side x side posts.
std::string srtmBytes(int side, const std::function<int(int column, int row)>& heightOf);

}  // namespace skydrop::test
