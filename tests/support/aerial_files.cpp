#include "support/aerial_files.h"

#include <geotiff.h>
#include <geovalues.h>
#include <gtest/gtest.h>
#include <tiffio.h>
#include <xtiffio.h>

#include <algorithm>
#include <vector>

namespace skydrop::test {

void writeAerialTiff(const std::filesystem::path& file, int side, glm::dvec2 corner, double cellM,
                     const std::function<std::array<std::uint8_t, 4>(int column, int row)>& colourAt,
                     const AerialForm& form) {
  constexpr std::array<int, 4> kPackings{COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE,
                                         COMPRESSION_JPEG};
  TIFF* tiff = XTIFFOpen(file.c_str(), "w");
  ASSERT_NE(tiff, nullptr);
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, side);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, side);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, form.bands);
  const bool isJpeg = form.packing == AerialForm::Packing::jpeg;
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, kPackings[static_cast<std::size_t>(form.packing)]);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, isJpeg ? PHOTOMETRIC_YCBCR : PHOTOMETRIC_RGB);
  if (isJpeg) TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
  if (form.bands == 4) TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
  const std::array<double, 3> scale{cellM, cellM, 0};
  const std::array<double, 6> tie{0, 0, 0, corner.x, corner.y, 0};
  TIFFSetField(tiff, TIFFTAG_GEOPIXELSCALE, 3, scale.data());
  TIFFSetField(tiff, TIFFTAG_GEOTIEPOINTS, 6, tie.data());
  GTIF* keys = GTIFNew(tiff);
  GTIFKeySet(keys, GTModelTypeGeoKey, TYPE_SHORT, 1, ModelTypeProjected);
  GTIFKeySet(keys, GTRasterTypeGeoKey, TYPE_SHORT, 1, RasterPixelIsArea);
  GTIFKeySet(keys, ProjectedCSTypeGeoKey, TYPE_SHORT, 1, 2056);
  GTIFWriteKeys(keys);
  GTIFFree(keys);
  const int columns = form.tileSide > 0 ? form.tileSide : side, rows = form.tileSide > 0 ? form.tileSide : 16;
  if (form.tileSide > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, columns);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, rows);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, rows);
  }
  for (int y = 0; y < side; y += rows) {
    for (int x = 0; x < side; x += columns) {
      std::vector<std::uint8_t> raw;
      for (int r = 0; r < (form.tileSide > 0 ? rows : std::min(rows, side - y)); ++r) {
        for (int c = 0; c < columns; ++c) {
          const auto colour = colourAt(std::min(x + c, side - 1), std::min(y + r, side - 1));
          raw.insert(raw.end(), colour.begin(), colour.begin() + form.bands);
        }
      }
      const auto bytes = static_cast<tmsize_t>(raw.size());
      if (form.tileSide > 0)
        TIFFWriteEncodedTile(tiff, TIFFComputeTile(tiff, x, y, 0, 0), raw.data(), bytes);
      else
        TIFFWriteEncodedStrip(tiff, TIFFComputeStrip(tiff, y, 0), raw.data(), bytes);
    }
  }
  XTIFFClose(tiff);
}

}  // namespace skydrop::test
