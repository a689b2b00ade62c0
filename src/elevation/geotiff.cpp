// GeoTIFF through libtiff and libgeotiff: strips or tiles of 16-bit whole numbers or floats.
#include <geo_normalize.h>
#include <geotiff.h>
#include <geovalues.h>
#include <tiffio.h>
#include <xtiffio.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <utility>

#include "elevation/readers.h"
#include "skydrop/core/error.h"
#include "skydrop/core/lru_cache.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr std::size_t kMostBlockBytes = std::size_t{8} << 20;   // of a strip or tile that is read in parts
constexpr std::size_t kMostWholeBytes = std::size_t{64} << 20;  // else it is read once, and held
constexpr std::size_t kKeptBytes = std::size_t{4} << 20;        // decoded blocks that a file keeps
constexpr std::uint32_t kNodataTag = 42113;

// The first fault that libtiff reports.
int keepError(TIFF*, void* user, const char*, const char* form, va_list arguments) {
  auto& message = *static_cast<std::string*>(user);
  if (!message.empty()) return 1;
  std::array<char, 200> text{};
  std::vsnprintf(text.data(), text.size(), form, arguments);
  message = text.data();
  return 1;
}
// libtiff mends counts and places of strips and tiles that do not fit the size, and only warns of it: what it
// makes up would be flown over as land.
int keepMendedBlocks(TIFF* tiff, void* user, const char* module, const char* form, va_list arguments) {
  std::array<char, 200> text{};
  va_list copy;
  va_copy(copy, arguments);
  std::vsnprintf(text.data(), text.size(), form, copy);
  va_end(copy);
  const std::string_view said = text.data();
  const bool isOfBlocks = said.find("ByteCount") != std::string_view::npos ||
                          said.find("StripOffsets") != std::string_view::npos ||
                          said.find("TileOffsets") != std::string_view::npos;
  return isOfBlocks ? keepError(tiff, user, module, form, arguments) : 1;
}

struct TiffCloser {
  void operator()(TIFF* tiff) const { XTIFFClose(tiff); }
};
using TiffHandle = std::unique_ptr<TIFF, TiffCloser>;

struct KeysCloser {
  void operator()(GTIF* keys) const { GTIFFree(keys); }
};

std::string compressionName(std::uint16_t code) {
  switch (code) {
    case COMPRESSION_NONE:
      return "not compressed";
    case COMPRESSION_LZW:
      return "LZW";
    case COMPRESSION_ADOBE_DEFLATE:
    case COMPRESSION_DEFLATE:
      return "deflate";
    default:
      return {};
  }
}

class GeoTiff final : public Raster {
 public:
  struct Layout {
    std::uint32_t width = 0, height = 0;
    std::uint32_t blockWidth = 0, blockHeight = 0;
    bool isPacked = true, isTiled = false, isFloat = false, isSigned = false;
    int bytes = 0;  // of a sample
    std::optional<double> nodata;
    std::string form;
    Georeference georeference;
  };

  GeoTiff(std::string name, TiffHandle tiff, std::unique_ptr<std::string> message, const Layout& layout)
      : Raster(std::move(name), layout.form, static_cast<int>(layout.width), static_cast<int>(layout.height),
               layout.georeference),
        message_(std::move(message)),
        tiff_(std::move(tiff)),
        layout_(layout) {}

  void read(int column, int row, int columns, int rows, float* out) const override {
    const int bw = static_cast<int>(layout_.blockWidth), bh = static_cast<int>(layout_.blockHeight);
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

  int rowsTogether() const override { return static_cast<int>(layout_.blockHeight); }
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
    const std::uint32_t bw = layout_.blockWidth, bh = layout_.blockHeight;
    const std::size_t samples = static_cast<std::size_t>(bw) * bh;
    std::vector<std::byte> raw(samples * static_cast<std::size_t>(layout_.bytes));
    const auto left = static_cast<std::uint32_t>(x) * bw, top = static_cast<std::uint32_t>(y) * bh;
    const std::uint32_t there = std::min(bh, layout_.height - top);  // rows of the last strip
    message_->clear();
    const auto wanted = static_cast<tmsize_t>(layout_.isTiled ? raw.size()
                                                              : static_cast<std::size_t>(there) * bw *
                                                                    static_cast<std::size_t>(layout_.bytes));
    const tmsize_t got =
        layout_.isTiled
            ? TIFFReadEncodedTile(tiff_.get(), TIFFComputeTile(tiff_.get(), left, top, 0, 0), raw.data(),
                                  wanted)
            : TIFFReadEncodedStrip(tiff_.get(), TIFFComputeStrip(tiff_.get(), top, 0), raw.data(), wanted);
    if (got < wanted)
      throw DataError(name(),
                      (layout_.isTiled ? "tile" : "strip") + (" at column " + std::to_string(left)) +
                          ", row " + std::to_string(top),
                      message_->empty() ? "is cut off" : *message_);
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
  std::unique_ptr<std::string> message_;
  TiffHandle tiff_;
  Layout layout_;
  mutable core::LRUCache<std::uint64_t, Block> blocks_{kKeptBytes};
};

template <class Value>
Value fieldOr(TIFF* tiff, std::uint32_t tag, Value otherwise) {
  Value value{};
  return TIFFGetFieldDefaulted(tiff, tag, &value) ? value : otherwise;
}

// The first fault that libgeotiff reports, which it would print otherwise.
void keepKeyError(GTIF* keys, int level, const char* form, ...) {
  auto& fault = *static_cast<std::string*>(GTIFGetUserData(keys));
  if (level != LIBGEOTIFF_ERROR || !fault.empty()) return;
  std::array<char, 200> text{};
  va_list arguments;
  va_start(arguments, form);
  std::vsnprintf(text.data(), text.size(), form, arguments);
  va_end(arguments);
  fault = text.data();
}

std::string crsOf(GTIF* keys, const std::string& name) {
  unsigned short code = 0;
  for (const geokey_t key : {ProjectedCSTypeGeoKey, GeographicTypeGeoKey}) {
    if (GTIFKeyGetSHORT(keys, key, &code, 0, 1) && code > 0 && code != KvUserDefined)
      return "EPSG:" + std::to_string(code);
  }
  GTIFDefn definition{};
  if (GTIFGetDefn(keys, &definition)) {
    if (char* text = GTIFGetProj4Defn(&definition)) {
      std::string crs = text;
      std::free(text);  // libgeotiff allocates it so
      if (!crs.empty() && crs.find("unknown") == std::string::npos) return crs;
    }
  }
  throw DataError(name, "reference system", "the GeoTIFF names none that is known");
}

Georeference georeferenceOf(TIFF* tiff, const std::string& name) {
  std::string fault;
  const std::unique_ptr<GTIF, KeysCloser> keys(GTIFNewEx(tiff, keepKeyError, &fault));
  if (!keys || !fault.empty())
    throw DataError(name, "georeference", fault.empty() ? "there are no GeoTIFF keys" : fault);
  std::uint16_t count = 0;
  double *scale = nullptr, *tie = nullptr, *matrix = nullptr;
  Georeference place;
  glm::dvec2 corner{};
  if (TIFFGetField(tiff, TIFFTAG_GEOPIXELSCALE, &count, &scale) && count >= 2) {
    place.cell = {scale[0], scale[1]};
    if (!TIFFGetField(tiff, TIFFTAG_GEOTIEPOINTS, &count, &tie) || count < 6)
      throw DataError(name, "georeference", "there is no tie point");
    corner = {tie[3] - tie[0] * place.cell.x, tie[4] + tie[1] * place.cell.y};
  } else if (TIFFGetField(tiff, TIFFTAG_GEOTRANSMATRIX, &count, &matrix) && count == 16) {
    if (matrix[1] != 0 || matrix[4] != 0) throw DataError(name, "georeference", "the raster is rotated");
    place.cell = {matrix[0], -matrix[5]};
    corner = {matrix[3], matrix[7]};
  } else {
    throw DataError(name, "georeference", "says neither size nor place of the cells");
  }
  unsigned short type = RasterPixelIsArea;
  GTIFKeyGetSHORT(keys.get(), GTRasterTypeGeoKey, &type, 0, 1);
  const double toCentre = type == RasterPixelIsPoint ? 0 : 0.5;
  place.first = {corner.x + toCentre * place.cell.x, corner.y - toCentre * place.cell.y};
  place.crs = crsOf(keys.get(), name);
  return place;
}

GeoTiff::Layout layoutOf(TIFF* tiff, const std::string& name) {
  GeoTiff::Layout layout;
  if (!TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &layout.width) ||
      !TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &layout.height))
    throw DataError(name, "size", "is missing");
  if (layout.width < 1 || layout.height < 1 || layout.width > kMostSide || layout.height > kMostSide ||
      std::size_t{layout.width} * layout.height > kMostCells)
    throw DataError(name, "size",
                    std::to_string(layout.width) + " x " + std::to_string(layout.height) +
                        " cells: must be 1 to " + std::to_string(kMostSide) + " a side and at most 2^30");
  const auto bands = fieldOr<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  const auto bits = fieldOr<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  const auto kind = fieldOr<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  layout.isFloat = kind == SAMPLEFORMAT_IEEEFP;
  layout.isSigned = kind == SAMPLEFORMAT_INT;
  layout.bytes = bits / 8;
  const bool isKnown = layout.isFloat ? bits == 32 || bits == 64
                                      : bits == 16 && (kind == SAMPLEFORMAT_INT || kind == SAMPLEFORMAT_UINT);
  if (bands != 1 || !isKnown)
    throw DataError(name, "samples",
                    std::to_string(bands) + " of " + std::to_string(bits) +
                        " bits a cell: heights are one float32, float64, int16 or uint16 a cell");
  const auto compression = fieldOr<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
  const std::string packing = compressionName(compression);
  if (packing.empty())
    throw DataError(name, "compression", std::to_string(compression) + " is none of: none, LZW, deflate");
  layout.isPacked = compression != COMPRESSION_NONE;
  layout.isTiled = TIFFIsTiled(tiff) != 0;
  if (layout.isTiled) {
    TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &layout.blockWidth);
    TIFFGetField(tiff, TIFFTAG_TILELENGTH, &layout.blockHeight);
  } else {
    layout.blockWidth = layout.width;
    layout.blockHeight =
        std::min(fieldOr<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, layout.height), layout.height);
  }
  const std::size_t blockBytes = std::size_t{layout.blockWidth} * layout.blockHeight * sizeof(float);
  const char* const block = layout.isTiled ? "tile" : "strip";
  if (layout.blockWidth < 1 || layout.blockHeight < 1 || layout.blockWidth > kMostSide ||
      layout.blockHeight > kMostSide || blockBytes > kMostWholeBytes)
    throw DataError(name, block, "has no size or more than 2^24 cells");
  const std::size_t across = (layout.width + layout.blockWidth - 1) / layout.blockWidth;
  const std::size_t down = (layout.height + layout.blockHeight - 1) / layout.blockHeight;
  const std::size_t there = layout.isTiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  if (there != across * down)
    throw DataError(
        name, block,
        "there are " + std::to_string(there) + " of them and not " + std::to_string(across * down));
  if (blockBytes > kMostBlockBytes && std::size_t{layout.width} * layout.height > kMostHeldCells)
    throw DataError(name, block, "has more than 2^21 cells: write the file in tiles");
  char* nodata = nullptr;
  std::uint16_t count = 0;
  std::uint32_t length = 0;
  // A private tag: libtiff gives its count first, as it is not one of its own.
  const TIFFField* field = TIFFFindField(tiff, kNodataTag, TIFF_ANY);
  if (field != nullptr && TIFFFieldPassCount(field)) {
    const bool isFound = TIFFFieldReadCount(field) == TIFF_VARIABLE2
                             ? TIFFGetField(tiff, kNodataTag, &length, &nodata) != 0
                             : TIFFGetField(tiff, kNodataTag, &count, &nodata) != 0;
    const std::size_t size = length > 0 ? length : count;
    if (isFound && nodata != nullptr) {
      const std::string text(nodata, strnlen(nodata, size));
      char* end = nullptr;
      const double value = std::strtod(text.c_str(), &end);
      if (end != text.c_str()) layout.nodata = value;
    }
  }
  const auto predictor =
      compression == COMPRESSION_NONE ? 1 : fieldOr<std::uint16_t>(tiff, TIFFTAG_PREDICTOR, 1);
  layout.form = std::string("GeoTIFF, ") +
                (layout.isFloat    ? "float"
                 : layout.isSigned ? "int"
                                   : "uint") +
                std::to_string(bits) + ", " + packing +
                (predictor > 1 ? ", predictor " + std::to_string(predictor) : "") + ", " + block + "s of " +
                std::to_string(layout.blockWidth) + " x " + std::to_string(layout.blockHeight);
  layout.georeference = georeferenceOf(tiff, name);
  return layout;
}

// All strips or tiles lie in the file, and what is not packed has its size.
void requireBlocks(TIFF* tiff, const GeoTiff::Layout& layout, std::uintmax_t fileBytes,
                   const std::string& name) {
  const std::uint32_t count = layout.isTiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
  for (std::uint32_t i = 0; i < count; ++i) {
    int isWrong = 0;
    const std::uint64_t offset = TIFFGetStrileOffsetWithErr(tiff, i, &isWrong);
    const std::uint64_t bytes = isWrong ? 0 : TIFFGetStrileByteCountWithErr(tiff, i, &isWrong);
    const std::uint64_t rows = layout.isTiled
                                   ? layout.blockHeight
                                   : std::min(layout.blockHeight, layout.height - i * layout.blockHeight);
    const std::uint64_t least =
        layout.isPacked ? 1 : rows * layout.blockWidth * static_cast<std::uint64_t>(layout.bytes);
    const bool isOutside = bytes < least || offset == 0 || offset > fileBytes || bytes > fileBytes - offset;
    if (isWrong || isOutside)
      throw DataError(name, (layout.isTiled ? "tile " : "strip ") + std::to_string(i),
                      "does not lie in the file: it is cut off, or the counts are wrong");
  }
}

}  // namespace

std::shared_ptr<const Raster> openGeoTiff(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw DataError(name, "", error ? error.message() : "is not a regular file");
  static std::once_flag isSetUp;
  std::call_once(isSetUp, XTIFFInitialize);
  auto message = std::make_unique<std::string>();
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(2 * kMostWholeBytes));
  TIFFOpenOptionsSetErrorHandlerExtR(options, keepError, message.get());
  TIFFOpenOptionsSetWarningHandlerExtR(options, keepMendedBlocks, message.get());
  // m: not mapped into memory, where a file that becomes shorter ends the program.
  TiffHandle tiff(TIFFOpenExt(name.c_str(), "rm", options));
  TIFFOpenOptionsFree(options);
  if (!tiff) {
    const std::string_view said = *message;
    const bool namesFile = said.starts_with(name + ": ");
    throw DataError(name, "header",
                    said.empty() ? "is not a TIFF" : said.substr(namesFile ? name.size() + 2 : 0));
  }
  const GeoTiff::Layout layout = layoutOf(tiff.get(), name);
  requireBlocks(tiff.get(), layout, std::filesystem::file_size(file), name);
  if (!message->empty()) throw DataError(name, layout.isTiled ? "tiles" : "strips", *message);
  const bool isInParts =
      std::size_t{layout.blockWidth} * layout.blockHeight * sizeof(float) <= kMostBlockBytes;
  auto raster = std::make_shared<GeoTiff>(name, std::move(tiff), std::move(message), layout);
  if (isInParts) return raster;
  std::vector<float> all(std::size_t{layout.width} * layout.height);
  raster->read(0, 0, raster->width(), raster->height(), all.data());
  return makeHeldRaster(name, layout.form, raster->width(), raster->height(), layout.georeference,
                        std::move(all));
}

}  // namespace skydrop::elevation
