// Aerial images as GeoTIFF: grey or RGB of 8 bits, with alpha or without.
#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

#include "elevation/readers.h"
#include "elevation/tiff_file.h"
#include "skydrop/core/error.h"
#include "skydrop/elevation/aerial_image.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr std::size_t kMostBlockBytes = std::size_t{64} << 20;  // of a strip or tile as RGBA

enum class Alpha { none, straight, premultiplied };

struct Layout {
  TiffBlocks blocks;
  int bands = 3;
  bool isInverted = false;  // white is 0
  Alpha alpha = Alpha::none;
  std::optional<int> nodata;  // where all bands have it there is nothing
  std::string form;
};

class GeoTiffImage final : public AerialImage {
 public:
  GeoTiffImage(TiffFile file, const Layout& layout, const Georeference& georeference)
      : AerialImage(file.name(), layout.form, static_cast<int>(layout.blocks.width),
                    static_cast<int>(layout.blocks.height), georeference),
        file_(std::move(file)),
        layout_(layout) {}

  void scan(const std::function<void(const Part&)>& take) const override {
    const std::scoped_lock lock(mutex_);
    const TiffBlocks& blocks = layout_.blocks;
    std::vector<std::uint8_t> rgba(4 * blocks.blockCells());
    for (std::uint32_t y = 0; y < blocks.down(); ++y) {
      for (std::uint32_t x = 0; x < blocks.across(); ++x) {
        const std::vector<std::byte> raw = file_.read(blocks, x, y);
        const std::uint32_t left = x * blocks.blockWidth, top = y * blocks.blockHeight;
        const std::uint32_t columns = std::min(blocks.blockWidth, blocks.width - left);
        const std::uint32_t rows = std::min(blocks.blockHeight, blocks.height - top);
        for (std::uint32_t r = 0; r < rows; ++r) {
          for (std::uint32_t c = 0; c < columns; ++c)
            convert(raw.data() + (std::size_t{r} * blocks.blockWidth + c) * blocks.cellBytes,
                    rgba.data() + 4 * (std::size_t{r} * columns + c));
        }
        take({static_cast<int>(left), static_cast<int>(top), static_cast<int>(columns),
              static_cast<int>(rows), rgba.data()});
      }
    }
  }

 private:
  void convert(const std::byte* cell, std::uint8_t* out) const {
    const auto band = [&](int i) { return std::to_integer<int>(cell[i]); };
    const bool isGrey = layout_.bands < 3;
    const int colours = isGrey ? 1 : 3;
    bool isVoid = layout_.nodata.has_value();
    const int alpha = layout_.alpha == Alpha::none ? 255 : band(colours);
    for (int i = 0; i < 3; ++i) {
      int value = band(isGrey ? 0 : i);
      isVoid = isVoid && value == *layout_.nodata;
      if (layout_.isInverted) value = 255 - value;
      if (layout_.alpha == Alpha::premultiplied && alpha > 0) value = std::min(value * 255 / alpha, 255);
      out[i] = static_cast<std::uint8_t>(value);
    }
    out[3] = static_cast<std::uint8_t>(isVoid ? 0 : alpha);
  }

  mutable std::mutex mutex_;  // of the file
  TiffFile file_;
  Layout layout_;
};

Layout layoutOf(const TiffFile& file) {
  Layout layout;
  const auto bands = file.fieldOr<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto bits = file.fieldOr<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
  const auto kind = file.fieldOr<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const auto order = file.fieldOr<std::uint16_t>(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  if (bits != 8 || kind != SAMPLEFORMAT_UINT || bands < 1 || bands > 8 ||
      (order != PLANARCONFIG_CONTIG && bands > 1))
    throw DataError(file.name(), "samples",
                    std::to_string(bands) + " of " + std::to_string(bits) +
                        " bits a pixel: aerial images are 8 bits a band, bands together");
  const auto compression = file.fieldOr<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const std::string packing = packingName(compression);
  if (packing.empty())
    throw DataError(file.name(), "compression",
                    std::to_string(compression) + " is none of: none, LZW, deflate, JPEG");
  std::uint16_t colours = PHOTOMETRIC_MINISBLACK;
  if (!TIFFGetField(file.tiff(), TIFFTAG_PHOTOMETRIC, &colours))
    throw DataError(file.name(), "colours", "what the bands are is not said");
  const bool isYcc = colours == PHOTOMETRIC_YCBCR && compression == COMPRESSION_JPEG && bands == 3;
  if (isYcc) TIFFSetField(file.tiff(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  layout.isInverted = colours == PHOTOMETRIC_MINISWHITE;
  const bool isGrey = layout.isInverted || colours == PHOTOMETRIC_MINISBLACK;
  if (!(isGrey && bands <= 2) && !(colours == PHOTOMETRIC_RGB && bands >= 3) && !isYcc)
    throw DataError(file.name(), "colours",
                    "of kind " + std::to_string(colours) + " in " + std::to_string(bands) +
                        " bands: aerial images are grey or RGB, with alpha or without");
  layout.bands = bands;
  std::uint16_t extras = 0, *kinds = nullptr;
  const bool saysExtra = TIFFGetField(file.tiff(), TIFFTAG_EXTRASAMPLES, &extras, &kinds) != 0;
  if (saysExtra && extras > 0 && bands == (isGrey ? 1 : 3) + extras) {
    layout.alpha = kinds[0] == EXTRASAMPLE_UNASSALPHA   ? Alpha::straight
                   : kinds[0] == EXTRASAMPLE_ASSOCALPHA ? Alpha::premultiplied
                                                        : Alpha::none;
  }
  layout.blocks = file.blocks(bands, compression != COMPRESSION_NONE, 4, kMostBlockBytes);
  if (const auto nodata = file.nodata();
      nodata && *nodata >= 0 && *nodata <= 255 && *nodata == std::floor(*nodata))
    layout.nodata = static_cast<int>(*nodata);
  layout.form = std::string("GeoTIFF, ") + (isGrey ? "grey" : "RGB") +
                (layout.alpha == Alpha::none ? "" : " and alpha") + ", " + packing + ", " +
                layout.blocks.word() + "s of " + std::to_string(layout.blocks.blockWidth) + " x " +
                std::to_string(layout.blocks.blockHeight);
  return layout;
}

}  // namespace

std::shared_ptr<const AerialImage> openGeoTiffImage(const std::filesystem::path& path) {
  TiffFile file(path);
  const Layout layout = layoutOf(file);
  const Georeference place = file.georeference();
  file.requireBlocks(layout.blocks);
  return std::make_shared<GeoTiffImage>(std::move(file), layout, place);
}

}  // namespace skydrop::elevation
