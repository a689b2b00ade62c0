// SRTM: big-endian 16-bit posts, rows from the north-western one, placed by the name of the file.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>

#include "elevation/readers.h"
#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr int kVoid = -32768;

float heightOf(const std::byte* bytes) {
  const int raw =
      static_cast<std::int16_t>(static_cast<unsigned>(bytes[0]) << 8 | static_cast<unsigned>(bytes[1]));
  return raw == kVoid ? heightOrVoid(NAN) : heightOrVoid(raw);
}

// Posts along a side of a file of this size.
int sideOf(const std::string& name, std::uintmax_t bytes) {
  for (const int side : {1201, 3601}) {
    if (bytes == std::uintmax_t{2} * side * side) return side;
  }
  throw DataError(name, "size",
                  std::to_string(bytes) +
                      " bytes: an SRTM tile has 2884802 (1201 x 1201 posts) or 25934402 (3601 x 3601)");
}

// N46E007 and the like: the south-western corner in degrees.
std::optional<glm::dvec2> cornerOf(std::string_view fileName) {
  const auto digits = [&](std::size_t from, std::size_t count) -> std::optional<int> {
    int value = 0;
    for (std::size_t i = from; i < from + count; ++i) {
      if (i >= fileName.size() || !std::isdigit(static_cast<unsigned char>(fileName[i]))) return std::nullopt;
      value = value * 10 + (fileName[i] - '0');
    }
    return value;
  };
  if (fileName.size() < 7) return std::nullopt;
  const int ns = std::toupper(static_cast<unsigned char>(fileName[0]));
  const int ew = std::toupper(static_cast<unsigned char>(fileName[3]));
  const auto north = digits(1, 2), east = digits(4, 3);
  if (!north || !east || (ns != 'N' && ns != 'S') || (ew != 'E' && ew != 'W')) return std::nullopt;
  const int latitude = ns == 'N' ? *north : -*north, longitude = ew == 'E' ? *east : -*east;
  if (latitude < -90 || latitude > 89 || longitude < -180 || longitude > 180) return std::nullopt;
  return glm::dvec2(longitude, latitude);
}

Georeference placeOf(const std::string& name, std::string_view fileName, int side) {
  const auto corner = cornerOf(fileName);
  if (!corner)
    throw DataError(name, "name",
                    "an SRTM tile is placed by its name, such as N46E007.hgt, and this has none");
  const double step = 1.0 / (side - 1);
  return {"EPSG:4326", {corner->x, corner->y + 1}, {step, step}};
}

std::string formOf(int side) { return side == 3601 ? "SRTM, 1 second" : "SRTM, 3 seconds"; }

class SrtmFile final : public Raster {
 public:
  SrtmFile(const std::filesystem::path& file, int descriptor, int side)
      : Raster(file.string(), formOf(side), side, side,
               placeOf(file.string(), file.filename().string(), side)),
        descriptor_(descriptor) {}
  ~SrtmFile() override { ::close(descriptor_); }
  SrtmFile(const SrtmFile&) = delete;
  SrtmFile& operator=(const SrtmFile&) = delete;

  void read(int column, int row, int columns, int rows, float* out) const override {
    std::vector<std::byte> bytes(static_cast<std::size_t>(columns) * 2);
    for (int r = row; r < row + rows; ++r) {
      const auto at = (static_cast<off_t>(r) * width() + column) * 2;
      std::size_t done = 0;
      while (done < bytes.size()) {
        const ssize_t got =
            ::pread(descriptor_, bytes.data() + done, bytes.size() - done, at + static_cast<off_t>(done));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0)
          throw DataError(name(), "row " + std::to_string(r),
                          got == 0 ? "the file has become shorter" : std::generic_category().message(errno));
        done += static_cast<std::size_t>(got);
      }
      for (int c = 0; c < columns; ++c) *out++ = heightOf(bytes.data() + 2 * c);
    }
  }

 private:
  int descriptor_;
};

class HeldSrtm final : public Raster {
 public:
  HeldSrtm(const std::string& name, std::string_view fileName, int side, std::vector<std::byte> bytes)
      : Raster(name, formOf(side) + ", zip", side, side, placeOf(name, fileName, side)),
        bytes_(std::move(bytes)) {}

  void read(int column, int row, int columns, int rows, float* out) const override {
    for (int r = row; r < row + rows; ++r) {
      const std::byte* from = bytes_.data() + (static_cast<std::size_t>(r) * width() + column) * 2;
      for (int c = 0; c < columns; ++c) *out++ = heightOf(from + 2 * c);
    }
  }
  std::size_t heldBytes() const override { return bytes_.capacity(); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace

bool isSrtmName(std::string_view fileName) {
  return fileName.ends_with(".hgt") || fileName.ends_with(".HGT");
}

std::shared_ptr<const Raster> openSrtm(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) throw DataError(file.string(), "", std::generic_category().message(errno));
  try {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
      throw DataError(file.string(), "", "is not a regular file");
    const int side = sideOf(file.string(), static_cast<std::uintmax_t>(status.st_size));
    return std::make_shared<SrtmFile>(file, descriptor, side);
  } catch (...) {
    ::close(descriptor);
    throw;
  }
}

std::shared_ptr<const Raster> readSrtm(const std::string& name, std::string_view fileName,
                                       std::vector<std::byte> bytes) {
  const int side = sideOf(name, bytes.size());
  return std::make_shared<HeldSrtm>(name, fileName, side, std::move(bytes));
}

}  // namespace skydrop::elevation
