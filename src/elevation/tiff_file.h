// A GeoTIFF as a file of strips or tiles, whatever a cell of it is: libtiff's and libgeotiff's faults in one
// line, and nothing that these would mend or make up.
#pragma once

#include <tiffio.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "skydrop/elevation/raster.h"

namespace skydrop::elevation {

// Size and layout in cells.
struct TiffBlocks {
  std::uint32_t width = 0, height = 0;
  std::uint32_t blockWidth = 0, blockHeight = 0;  // of a strip or tile
  bool isTiled = false, isPacked = true;
  std::size_t cellBytes = 0;

  const char* word() const { return isTiled ? "tile" : "strip"; }
  std::size_t blockCells() const { return std::size_t{blockWidth} * blockHeight; }
  std::uint32_t across() const { return (width + blockWidth - 1) / blockWidth; }
  std::uint32_t down() const { return (height + blockHeight - 1) / blockHeight; }
};

// Of the tag for compression, for people; empty for what is not read.
std::string packingName(std::uint16_t code);

// One thread at a time. All throw core::DataError with file, place and reason.
class TiffFile {
 public:
  explicit TiffFile(const std::filesystem::path& file);

  const std::string& name() const { return name_; }
  TIFF* tiff() const { return tiff_.get(); }

  // Their sizes and number, of cells of so many bytes; at most `mostBytes` when unpacked, `heldBytes` a cell.
  TiffBlocks blocks(std::size_t cellBytes, bool isPacked, std::size_t heldBytes, std::size_t mostBytes) const;
  // All strips or tiles lie in the file, and what is not packed has its size.
  void requireBlocks(const TiffBlocks& blocks) const;
  Georeference georeference() const;
  // Of the tag that GDAL writes, 42113.
  std::optional<double> nodata() const;
  // Unpacked: blockCells() of cellBytes, of which the last strip has fewer rows and zeros after them.
  std::vector<std::byte> read(const TiffBlocks& blocks, std::uint32_t x, std::uint32_t y) const;

  template <class Value>
  Value fieldOr(std::uint32_t tag, Value otherwise) const {
    Value value{};
    return TIFFGetFieldDefaulted(tiff(), tag, &value) ? value : otherwise;
  }

 private:
  struct Closer {
    void operator()(TIFF* tiff) const;
  };

  std::string name_;
  std::uintmax_t bytes_ = 0;
  std::unique_ptr<std::string> fault_;  // the first one that libtiff reported
  std::unique_ptr<TIFF, Closer> tiff_;
};

}  // namespace skydrop::elevation
