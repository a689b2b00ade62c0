// The stars that the eye sees, from assets/stars/stars.bin (assets/SOURCES.md has where it comes from).
// Values, from any thread.
//
// The file, little-endian: "SKYSTAR1", the number of stars (32 bits), and 16 bytes a star: Hipparcos number
// (32 bits), right ascension and declination (signed 32 bits, 1e-4 degrees), magnitude and B-V (signed 16
// bits, 1e-3). The brightest first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace skydrop::sky {

struct Star {
  std::uint32_t hipparcos = 0;
  // Unit; mean equinox and equator of J2000, epoch 2000: x to the equinox, z to the pole. j2000ToWorld()
  // (almanac.h) takes it to where it stands; the star's own motion is left out, 0.03 degrees by 2050 at most.
  glm::dvec3 direction{0, 0, 1};
  double magnitude = 0;   // visual, [-2, 8]
  double colorIndex = 0;  // B-V: -0.4 blue, 0 white, 0.65 the sun's, 2 red; [-1, 6]
};

// Throws core::DataError (`name: place: reason`) unless the content is a whole file as above: each star
// within its ranges, in order, and no more than 100 000 of them. Never reads or allocates beyond what is
// there.
std::vector<Star> decodeStars(std::span<const std::byte> bytes, std::string_view name);

std::vector<Star> readStars(const std::filesystem::path& path);

}  // namespace skydrop::sky
