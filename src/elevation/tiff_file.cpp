#include "elevation/tiff_file.h"

#include <geo_normalize.h>
#include <geotiff.h>
#include <geovalues.h>
#include <xtiffio.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string_view>

#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr std::size_t kMostAllocated = std::size_t{128} << 20;
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

struct KeysCloser {
  void operator()(GTIF* keys) const { GTIFFree(keys); }
};

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

}  // namespace

std::string packingName(std::uint16_t code) {
  switch (code) {
    case COMPRESSION_NONE:
      return "not compressed";
    case COMPRESSION_LZW:
      return "LZW";
    case COMPRESSION_ADOBE_DEFLATE:
    case COMPRESSION_DEFLATE:
      return "deflate";
    case COMPRESSION_JPEG:
      return "JPEG";
    default:
      return {};
  }
}

void TiffFile::Closer::operator()(TIFF* tiff) const { XTIFFClose(tiff); }

TiffFile::TiffFile(const std::filesystem::path& file)
    : name_(file.string()), fault_(std::make_unique<std::string>()) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw DataError(name_, "", error ? error.message() : "is not a regular file");
  static std::once_flag isSetUp;
  std::call_once(isSetUp, XTIFFInitialize);
  TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, static_cast<tmsize_t>(kMostAllocated));
  TIFFOpenOptionsSetErrorHandlerExtR(options, keepError, fault_.get());
  TIFFOpenOptionsSetWarningHandlerExtR(options, keepMendedBlocks, fault_.get());
  // m: not mapped into memory, where a file that becomes shorter ends the program.
  tiff_.reset(TIFFOpenExt(name_.c_str(), "rm", options));
  TIFFOpenOptionsFree(options);
  if (!tiff_) {
    const std::string_view said = *fault_;
    const bool namesFile = said.starts_with(name_ + ": ");
    throw DataError(name_, "header",
                    said.empty() ? "is not a TIFF" : said.substr(namesFile ? name_.size() + 2 : 0));
  }
  bytes_ = std::filesystem::file_size(file);
}

TiffBlocks TiffFile::blocks(std::size_t cellBytes, bool isPacked, std::size_t heldBytes,
                            std::size_t mostBytes) const {
  TiffBlocks blocks;
  blocks.cellBytes = cellBytes;
  blocks.isPacked = isPacked;
  if (!TIFFGetField(tiff(), TIFFTAG_IMAGEWIDTH, &blocks.width) ||
      !TIFFGetField(tiff(), TIFFTAG_IMAGELENGTH, &blocks.height))
    throw DataError(name_, "size", "is missing");
  if (blocks.width < 1 || blocks.height < 1 || blocks.width > kMostSide || blocks.height > kMostSide ||
      std::size_t{blocks.width} * blocks.height > kMostCells)
    throw DataError(name_, "size",
                    std::to_string(blocks.width) + " x " + std::to_string(blocks.height) +
                        " cells: must be 1 to " + std::to_string(kMostSide) + " a side and at most 2^30");
  blocks.isTiled = TIFFIsTiled(tiff()) != 0;
  if (blocks.isTiled) {
    TIFFGetField(tiff(), TIFFTAG_TILEWIDTH, &blocks.blockWidth);
    TIFFGetField(tiff(), TIFFTAG_TILELENGTH, &blocks.blockHeight);
  } else {
    blocks.blockWidth = blocks.width;
    blocks.blockHeight = std::min(fieldOr<std::uint32_t>(TIFFTAG_ROWSPERSTRIP, blocks.height), blocks.height);
  }
  if (blocks.blockWidth < 1 || blocks.blockHeight < 1 || blocks.blockWidth > kMostSide ||
      blocks.blockHeight > kMostSide || blocks.blockCells() * heldBytes > mostBytes)
    throw DataError(name_, blocks.word(),
                    "has no size or more than " + std::to_string(mostBytes / heldBytes) + " cells");
  const std::size_t there = blocks.isTiled ? TIFFNumberOfTiles(tiff()) : TIFFNumberOfStrips(tiff());
  const std::size_t wanted = std::size_t{blocks.across()} * blocks.down();
  if (there != wanted)
    throw DataError(name_, blocks.word(),
                    "there are " + std::to_string(there) + " of them and not " + std::to_string(wanted));
  return blocks;
}

void TiffFile::requireBlocks(const TiffBlocks& blocks) const {
  const std::uint32_t count = blocks.across() * blocks.down();
  for (std::uint32_t i = 0; i < count; ++i) {
    int isWrong = 0;
    const std::uint64_t offset = TIFFGetStrileOffsetWithErr(tiff(), i, &isWrong);
    const std::uint64_t bytes = isWrong ? 0 : TIFFGetStrileByteCountWithErr(tiff(), i, &isWrong);
    const std::uint64_t rows = blocks.isTiled
                                   ? blocks.blockHeight
                                   : std::min(blocks.blockHeight, blocks.height - i * blocks.blockHeight);
    const std::uint64_t least = blocks.isPacked ? 1 : rows * blocks.blockWidth * blocks.cellBytes;
    const bool isOutside = bytes < least || offset == 0 || offset > bytes_ || bytes > bytes_ - offset;
    if (isWrong || isOutside)
      throw DataError(name_, blocks.word() + (" " + std::to_string(i)),
                      "does not lie in the file: it is cut off, or the counts are wrong");
  }
  if (!fault_->empty()) throw DataError(name_, blocks.isTiled ? "tiles" : "strips", *fault_);
}

Georeference TiffFile::georeference() const {
  TIFF* const tiff = tiff_.get();
  std::string fault;
  const std::unique_ptr<GTIF, KeysCloser> keys(GTIFNewEx(tiff, keepKeyError, &fault));
  if (!keys || !fault.empty())
    throw DataError(name_, "georeference", fault.empty() ? "there are no GeoTIFF keys" : fault);
  std::uint16_t count = 0;
  double *scale = nullptr, *tie = nullptr, *matrix = nullptr;
  Georeference place;
  glm::dvec2 corner{};
  if (TIFFGetField(tiff, TIFFTAG_GEOPIXELSCALE, &count, &scale) && count >= 2) {
    place.cell = {scale[0], scale[1]};
    if (!TIFFGetField(tiff, TIFFTAG_GEOTIEPOINTS, &count, &tie) || count < 6)
      throw DataError(name_, "georeference", "there is no tie point");
    corner = {tie[3] - tie[0] * place.cell.x, tie[4] + tie[1] * place.cell.y};
  } else if (TIFFGetField(tiff, TIFFTAG_GEOTRANSMATRIX, &count, &matrix) && count == 16) {
    if (matrix[1] != 0 || matrix[4] != 0) throw DataError(name_, "georeference", "the raster is rotated");
    place.cell = {matrix[0], -matrix[5]};
    corner = {matrix[3], matrix[7]};
  } else {
    throw DataError(name_, "georeference", "says neither size nor place of the cells");
  }
  unsigned short type = RasterPixelIsArea;
  GTIFKeyGetSHORT(keys.get(), GTRasterTypeGeoKey, &type, 0, 1);
  const double toCentre = type == RasterPixelIsPoint ? 0 : 0.5;
  place.first = {corner.x + toCentre * place.cell.x, corner.y - toCentre * place.cell.y};
  place.crs = crsOf(keys.get(), name_);
  return place;
}

std::optional<double> TiffFile::nodata() const {
  char* text = nullptr;
  std::uint16_t count = 0;
  std::uint32_t length = 0;
  // A private tag: libtiff gives its count first, as it is not one of its own.
  const TIFFField* field = TIFFFindField(tiff(), kNodataTag, TIFF_ANY);
  if (field == nullptr || !TIFFFieldPassCount(field)) return std::nullopt;
  const bool isFound = TIFFFieldReadCount(field) == TIFF_VARIABLE2
                           ? TIFFGetField(tiff(), kNodataTag, &length, &text) != 0
                           : TIFFGetField(tiff(), kNodataTag, &count, &text) != 0;
  if (!isFound || text == nullptr) return std::nullopt;
  const std::string number(text, strnlen(text, length > 0 ? length : count));
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  return end != number.c_str() ? std::optional(value) : std::nullopt;
}

std::vector<std::byte> TiffFile::read(const TiffBlocks& blocks, std::uint32_t x, std::uint32_t y) const {
  std::vector<std::byte> raw(blocks.blockCells() * blocks.cellBytes);
  const std::uint32_t left = x * blocks.blockWidth, top = y * blocks.blockHeight;
  const std::uint32_t there = std::min(blocks.blockHeight, blocks.height - top);  // rows of the last strip
  fault_->clear();
  const auto wanted = static_cast<tmsize_t>(
      blocks.isTiled ? raw.size() : std::size_t{there} * blocks.blockWidth * blocks.cellBytes);
  const tmsize_t got =
      blocks.isTiled
          ? TIFFReadEncodedTile(tiff(), TIFFComputeTile(tiff(), left, top, 0, 0), raw.data(), wanted)
          : TIFFReadEncodedStrip(tiff(), TIFFComputeStrip(tiff(), top, 0), raw.data(), wanted);
  if (got < wanted)
    throw DataError(name_,
                    blocks.word() + (" at column " + std::to_string(left)) + ", row " + std::to_string(top),
                    fault_->empty() ? "is cut off" : *fault_);
  return raw;
}

}  // namespace skydrop::elevation
