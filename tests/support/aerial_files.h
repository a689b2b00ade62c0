// Aerial images for tests, written by libtiff, never by the readers that they are for.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>

namespace skydrop::test {

struct AerialForm {
  enum class Packing { none, lzw, deflate, jpeg };
  Packing packing = Packing::none;
  int tileSide = 0;  // 0: strips of 16 rows
  int bands = 3;     // 4: with straight alpha
};

// side x side pixels in LV95; `corner` is the north-western corner of the area.
void writeAerialTiff(const std::filesystem::path& file, int side, glm::dvec2 corner, double cellM,
                     const std::function<std::array<std::uint8_t, 4>(int column, int row)>& colourAt,
                     const AerialForm& form = {});

}  // namespace skydrop::test
