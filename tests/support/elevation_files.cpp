#include "support/elevation_files.h"

#include <geotiff.h>
#include <geovalues.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <xtiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace skydrop::test {
namespace {

constexpr std::uint32_t kNodataTag = 42113;

void addNodataTag(TIFF* tiff) {
  static std::array<char, 12> name{"GDAL_NODATA"};
  static const std::array<TIFFFieldInfo, 1> fields{
      {{kNodataTag, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name.data()}}};
  TIFFMergeFieldInfo(tiff, fields.data(), 1);
}

std::vector<std::byte> bytesOf(const std::vector<float>& heights, bool isFloat) {
  std::vector<std::byte> bytes(heights.size() * (isFloat ? 4 : 2));
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto whole = static_cast<std::int16_t>(std::lround(isFloat ? 0 : heights[i]));
    isFloat ? std::memcpy(bytes.data() + 4 * i, &heights[i], 4)
            : std::memcpy(bytes.data() + 2 * i, &whole, 2);
  }
  return bytes;
}

}  // namespace

void writeGeoTiff(const std::filesystem::path& file, int width, int height, glm::dvec2 corner,
                  glm::dvec2 cell, const std::vector<float>& heights, const TiffForm& form) {
  TIFF* tiff = XTIFFOpen(file.c_str(), "w");
  ASSERT_NE(tiff, nullptr) << file;
  addNodataTag(tiff);
  const std::array<int, 3> packings{COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE};
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, form.isFloat ? 32 : 16);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, form.isFloat ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_INT);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, packings[static_cast<std::size_t>(form.packing)]);
  if (form.packing != TiffForm::Packing::none) TIFFSetField(tiff, TIFFTAG_PREDICTOR, form.predictor);
  if (!form.nodata.empty()) TIFFSetField(tiff, kNodataTag, form.nodata.c_str());
  const std::array<double, 3> scale{cell.x, cell.y, 0};
  const std::array<double, 6> tie{0, 0, 0, corner.x, corner.y, 0};
  TIFFSetField(tiff, TIFFTAG_GEOPIXELSCALE, 3, scale.data());
  TIFFSetField(tiff, TIFFTAG_GEOTIEPOINTS, 6, tie.data());
  GTIF* keys = GTIFNew(tiff);
  const bool isGeographic = form.epsg >= 4001 && form.epsg <= 4999;
  GTIFKeySet(keys, GTModelTypeGeoKey, TYPE_SHORT, 1, isGeographic ? ModelTypeGeographic : ModelTypeProjected);
  GTIFKeySet(keys, GTRasterTypeGeoKey, TYPE_SHORT, 1, form.isPoint ? RasterPixelIsPoint : RasterPixelIsArea);
  if (form.epsg > 0)
    GTIFKeySet(keys, isGeographic ? GeographicTypeGeoKey : ProjectedCSTypeGeoKey, TYPE_SHORT, 1, form.epsg);
  GTIFWriteKeys(keys);
  GTIFFree(keys);

  const std::size_t bytes = form.isFloat ? 4 : 2;
  if (form.tileSide > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, form.tileSide);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, form.tileSide);
    for (int y = 0; y < height; y += form.tileSide) {
      for (int x = 0; x < width; x += form.tileSide) {
        std::vector<float> tile;
        for (int r = 0; r < form.tileSide; ++r) {
          for (int c = 0; c < form.tileSide; ++c)
            tile.push_back(heights[static_cast<std::size_t>(std::min(y + r, height - 1)) * width +
                                   std::min(x + c, width - 1)]);
        }
        std::vector<std::byte> raw = bytesOf(tile, form.isFloat);
        TIFFWriteTile(tiff, raw.data(), static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0);
      }
    }
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, form.rowsPerStrip);
    std::vector<std::byte> raw = bytesOf(heights, form.isFloat);
    for (int y = 0; y < height; ++y)
      TIFFWriteScanline(tiff, raw.data() + static_cast<std::size_t>(y) * width * bytes,
                        static_cast<std::uint32_t>(y), 0);
  }
  XTIFFClose(tiff);
}

std::vector<float> heightsOf(int width, int height, const HeightOf& heightOf) {
  std::vector<float> heights;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column)
      heights.push_back(static_cast<float>(heightOf(column, row)));
  }
  return heights;
}

std::string srtmBytes(int side, const std::function<int(int column, int row)>& heightOf) {
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(2) * side * side);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const auto raw = static_cast<unsigned>(heightOf(column, row)) & 0xffffU;
      bytes.push_back(static_cast<char>(raw >> 8));
      bytes.push_back(static_cast<char>(raw & 0xff));
    }
  }
  return bytes;
}

}  // namespace skydrop::test
