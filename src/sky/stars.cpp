#include "skydrop/sky/stars.h"

#include <string>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/sky/almanac.h"

namespace skydrop::sky {
namespace {

constexpr std::string_view kMagic = "SKYSTAR1";
constexpr std::size_t kHeaderBytes = 12, kStarBytes = 16, kMostStars = 100'000;

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at, std::size_t count) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

}  // namespace

std::vector<Star> decodeStars(std::span<const std::byte> bytes, std::string_view name) {
  const auto refuse = [&](const std::string& place, const std::string& reason) {
    throw core::DataError(name, place, reason);
  };
  if (bytes.size() < kHeaderBytes) refuse("header", std::to_string(bytes.size()) + " bytes instead of 12");
  for (std::size_t i = 0; i < kMagic.size(); ++i) {
    if (std::to_integer<char>(bytes[i]) != kMagic[i]) refuse("magic number", "not a star catalogue");
  }
  const std::size_t count = word(bytes, kMagic.size(), 4);
  if (count < 1 || count > kMostStars)
    refuse("number of stars", std::to_string(count) + " is out of range 1 to " + std::to_string(kMostStars));
  if (bytes.size() != kHeaderBytes + count * kStarBytes) {
    refuse("stars", std::to_string(bytes.size() - kHeaderBytes) + " bytes where the header says " +
                        std::to_string(count * kStarBytes));
  }
  std::vector<Star> stars;
  stars.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = kHeaderBytes + i * kStarBytes;
    const auto inRange = [&](const char* what, std::int32_t value, std::int32_t least, std::int32_t most,
                             double unit) {
      if (value < least || value > most) {
        refuse("star " + std::to_string(i + 1), std::string(what) + " " + std::to_string(value) +
                                                    " is out of range " + std::to_string(least) + " to " +
                                                    std::to_string(most));
      }
      return value * unit;
    };
    const auto angle = [&](std::size_t offset) {
      return static_cast<std::int32_t>(word(bytes, at + offset, 4));
    };
    const auto thousandths = [&](std::size_t offset) {
      return static_cast<std::int32_t>(static_cast<std::int16_t>(word(bytes, at + offset, 2)));
    };
    Star& star = stars.emplace_back();
    star.hipparcos = word(bytes, at, 4);
    const double ascension = inRange("right ascension", angle(4), 0, 3'599'999, 1e-4),
                 declination = inRange("declination", angle(8), -900'000, 900'000, 1e-4);
    star.direction = equatorialDirection(ascension, declination);
    star.magnitude = inRange("magnitude", thousandths(12), -2000, 8000, 1e-3);
    star.colorIndex = inRange("B-V", thousandths(14), -1000, 6000, 1e-3);
    if (i > 0 && star.magnitude < stars[i - 1].magnitude)
      refuse("star " + std::to_string(i + 1), "is brighter than the one before it");
  }
  return stars;
}

std::vector<Star> readStars(const std::filesystem::path& path) {
  return decodeStars(core::readFile(path, kHeaderBytes + kMostStars * kStarBytes), path.string());
}

}  // namespace skydrop::sky
