// The readers of each form. Each throws core::DataError with file, place and reason.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/elevation/raster.h"

namespace skydrop::elevation {

// Heights that are held in memory. `heights` may hold anything: what is no height becomes a void.
std::shared_ptr<const Raster> makeHeldRaster(std::string name, std::string form, int width, int height,
                                             const Georeference& georeference, std::vector<float> heights);

// What a height outside of kLowestHeight .. kHighestHeight becomes: NaN.
float heightOrVoid(double metres);

// SRTM by the name of the file (N46E007.hgt). The file is read in parts; or its bytes are held.
bool isSrtmName(std::string_view fileName);
std::shared_ptr<const Raster> openSrtm(const std::filesystem::path& file);
std::shared_ptr<const Raster> readSrtm(const std::string& name, std::string_view fileName,
                                       std::vector<std::byte> bytes);

// By the first bytes of a file.
bool isTiff(std::string_view head);
std::shared_ptr<const Raster> openGeoTiff(const std::filesystem::path& file);

class AerialImage;
std::shared_ptr<const AerialImage> openGeoTiffImage(const std::filesystem::path& file);

// Texts. A reference system that they do not name is that of a .prj file beside them, or told by their
// coordinates (guessedCrs).
std::shared_ptr<const Raster> readEsriAscii(const std::string& name, std::string_view text,
                                            const std::optional<std::string>& crs);
std::shared_ptr<const Raster> readXyz(const std::string& name, std::string_view text,
                                      const std::optional<std::string>& crs);
bool looksLikeEsriAscii(std::string_view text);

// Terrarium or terrain-RGB, by which of them has heights of this earth; placed by a world file or by
// .../z/x/y.png.
std::shared_ptr<const Raster> readHeightPng(const std::filesystem::path& file,
                                            std::span<const std::byte> bytes,
                                            const std::optional<std::string>& crs);

// The one elevation file in an archive: its name and content. At most kMostUnpackedBytes.
inline constexpr std::size_t kMostUnpackedBytes = std::size_t{64} << 20;
struct Unpacked {
  std::string name;
  std::vector<std::byte> bytes;
};
Unpacked unpackZip(const std::filesystem::path& file);

// By coordinates alone: degrees where all lie within them, LV95 within its rectangle; else nothing.
std::optional<std::string> guessedCrs(glm::dvec2 lowest, glm::dvec2 highest);

// Text of the .prj file beside it, if there is one.
std::optional<std::string> crsBeside(const std::filesystem::path& file);

// Where a picture lies by the world file beside it (.pgw, .jgw, .wld, ..; six lines), if there is one:
// without its reference system.
std::optional<Georeference> worldFileBeside(const std::filesystem::path& file);

// The same raster averaged over blocks of so many cells a side, voids left out.
std::shared_ptr<const Raster> averaged(std::shared_ptr<const Raster> raster, int cells);

}  // namespace skydrop::elevation
