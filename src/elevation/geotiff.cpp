// GeoTIFF through libtiff and libgeotiff: strips or tiles of 16-bit whole numbers or floats.
#include <cmath>
#include <cstring>
#include <mutex>
#include <utility>

#include "elevation/readers.h"
#include "elevation/tiff_file.h"
#include "skydrop/core/error.h"
#include "skydrop/core/lru_cache.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr std::size_t kMostBlockBytes = std::size_t{8} << 20;   // of a strip or tile that is read in parts
constexpr std::size_t kMostWholeBytes = std::size_t{64} << 20;  // else it is read once, and held
constexpr std::size_t kKeptBytes = std::size_t{4} << 20;        // decoded blocks that a file keeps

class GeoTiff final : public Raster {
 public:
  struct Layout {
    TiffBlocks blocks;
    bool isFloat = false, isSigned = false;
    int bytes = 0;  // of a sample
    std::optional<double> nodata;
    std::string form;
    Georeference georeference;
  };

  GeoTiff(TiffFile file, const Layout& layout)
      : Raster(file.name(), layout.form, static_cast<int>(layout.blocks.width),
               static_cast<int>(layout.blocks.height), layout.georeference),
        file_(std::move(file)),
        layout_(layout) {}

  void read(int column, int row, int columns, int rows, float* out) const override {
    const int bw = static_cast<int>(layout_.blocks.blockWidth),
              bh = static_cast<int>(layout_.blocks.blockHeight);
    const std::scoped_lock lock(mutex_);
    for (int y = row / bh; y * bh < row + rows; ++y) {
      for (int x = column / bw; x * bw < column + columns; ++x) {
        const Block block = blockAt(x, y);
        const int left = std::max(column, x * bw), right = std::min(column + columns, (x + 1) * bw);
        for (int r = std::max(row, y * bh); r < std::min(row + rows, (y + 1) * bh); ++r) {
          const float* from = block->data() + static_cast<std::size_t>(r - y * bh) * bw + (left - x * bw);
          std::copy(from, from + (right - left),
                    out + static_cast<std::size_t>(r - row) * columns + (left - column));
        }
      }
    }
  }

  int rowsTogether() const override { return static_cast<int>(layout_.blocks.blockHeight); }
  void rest() const override {
    const std::scoped_lock lock(mutex_);
    blocks_.clear();
  }
  std::size_t heldBytes() const override {
    const std::scoped_lock lock(mutex_);
    return blocks_.statistics().bytes;
  }

 private:
  using Block = std::shared_ptr<const std::vector<float>>;

  Block blockAt(int x, int y) const {
    const std::uint64_t key = static_cast<std::uint64_t>(y) << 32 | static_cast<std::uint32_t>(x);
    if (const Block* kept = blocks_.find(key)) return *kept;
    auto block = std::make_shared<const std::vector<float>>(decode(x, y));
    blocks_.insert(key, block, block->size() * sizeof(float));
    return block;
  }

  std::vector<float> decode(int x, int y) const {
    const std::vector<std::byte> raw =
        file_.read(layout_.blocks, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
    const std::size_t samples = layout_.blocks.blockCells();
    std::vector<float> heights(samples);
    for (std::size_t i = 0; i < samples; ++i) heights[i] = heightAt(raw.data() + i * layout_.bytes);
    return heights;
  }

  float heightAt(const std::byte* at) const {
    double value = 0;
    if (layout_.isFloat && layout_.bytes == 8) {
      std::memcpy(&value, at, 8);
    } else if (layout_.isFloat) {
      float single = 0;
      std::memcpy(&single, at, 4);
      // The tag has the decimals of a double, the cells the nearest float.
      if (layout_.nodata && single == static_cast<float>(*layout_.nodata)) return heightOrVoid(NAN);
      value = single;
    } else if (layout_.isSigned) {
      std::int16_t whole = 0;
      std::memcpy(&whole, at, 2);
      if (whole == -32768) return heightOrVoid(NAN);
      value = whole;
    } else {
      std::uint16_t whole = 0;
      std::memcpy(&whole, at, 2);
      value = whole;
    }
    if (layout_.nodata && value == *layout_.nodata) return heightOrVoid(NAN);
    return heightOrVoid(value);
  }

  mutable std::mutex mutex_;  // of all below
  TiffFile file_;
  Layout layout_;
  mutable core::LRUCache<std::uint64_t, Block> blocks_{kKeptBytes};
};

GeoTiff::Layout layoutOf(const TiffFile& file) {
  GeoTiff::Layout layout;
  const std::string& name = file.name();
  const auto bands = file.fieldOr<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto bits = file.fieldOr<std::uint16_t>(TIFFTAG_BITSPERSAMPLE, 1);
  const auto kind = file.fieldOr<std::uint16_t>(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  layout.isFloat = kind == SAMPLEFORMAT_IEEEFP;
  layout.isSigned = kind == SAMPLEFORMAT_INT;
  layout.bytes = bits / 8;
  const bool isKnown = layout.isFloat ? bits == 32 || bits == 64
                                      : bits == 16 && (kind == SAMPLEFORMAT_INT || kind == SAMPLEFORMAT_UINT);
  if (bands != 1 || !isKnown)
    throw DataError(name, "samples",
                    std::to_string(bands) + " of " + std::to_string(bits) +
                        " bits a cell: heights are one float32, float64, int16 or uint16 a cell");
  const auto compression = file.fieldOr<std::uint16_t>(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const std::string packing = packingName(compression);
  if (packing.empty() || compression == COMPRESSION_JPEG)  // lossy: no heights
    throw DataError(name, "compression", std::to_string(compression) + " is none of: none, LZW, deflate");
  layout.blocks = file.blocks(static_cast<std::size_t>(layout.bytes), compression != COMPRESSION_NONE,
                              sizeof(float), kMostWholeBytes);
  const TiffBlocks& blocks = layout.blocks;
  const std::size_t blockBytes = blocks.blockCells() * sizeof(float);
  if (blockBytes > kMostBlockBytes && std::size_t{blocks.width} * blocks.height > kMostHeldCells)
    throw DataError(name, blocks.word(), "has more than 2^21 cells: write the file in tiles");
  layout.nodata = file.nodata();
  const auto predictor =
      compression == COMPRESSION_NONE ? 1 : file.fieldOr<std::uint16_t>(TIFFTAG_PREDICTOR, 1);
  layout.form = std::string("GeoTIFF, ") +
                (layout.isFloat    ? "float"
                 : layout.isSigned ? "int"
                                   : "uint") +
                std::to_string(bits) + ", " + packing +
                (predictor > 1 ? ", predictor " + std::to_string(predictor) : "") + ", " + blocks.word() +
                "s of " + std::to_string(blocks.blockWidth) + " x " + std::to_string(blocks.blockHeight);
  layout.georeference = file.georeference();
  return layout;
}

}  // namespace

std::shared_ptr<const Raster> openGeoTiff(const std::filesystem::path& path) {
  TiffFile file(path);
  const GeoTiff::Layout layout = layoutOf(file);
  file.requireBlocks(layout.blocks);
  const bool isInParts = layout.blocks.blockCells() * sizeof(float) <= kMostBlockBytes;
  auto raster = std::make_shared<GeoTiff>(std::move(file), layout);
  if (isInParts) return raster;
  std::vector<float> all(std::size_t{layout.blocks.width} * layout.blocks.height);
  raster->read(0, 0, raster->width(), raster->height(), all.data());
  return makeHeldRaster(raster->name(), layout.form, raster->width(), raster->height(), layout.georeference,
                        std::move(all));
}

}  // namespace skydrop::elevation
