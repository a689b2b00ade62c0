// The heights that chunks can store, and how: 16 bits over a range that the height source states.
#pragma once

#include <cstdint>

namespace skydrop::terrain {

// One range for the whole world of a source, so that border samples of neighbours are the same bits:
// height = lowest + code * step(), code 0 .. 65535. A stored height is off by half a step at most: 1.6 cm for
// the shipped land, 7.1 cm for all land and its depressions on earth (-430 to 8848 m). lowest < highest, both
// finite and within 1e6 m; the GPU decodes in float, whose rounding adds less than 1/2^24 of the largest
// height.
struct HeightRange {
  // Of the shipped land, and of every source that states no other. The step is a power of two (3.1 cm), so
  // decoding is exact in float.
  double lowest = -256;                  // m above sea level
  double highest = -256 + 65535.0 / 32;  // 1791.97 m

  constexpr double step() const { return (highest - lowest) / 65535; }  // m a code

  // Nearest code; heights outside the range (NaN: below) take the nearest end.
  std::uint16_t encode(double height) const;
  constexpr double decode(std::uint16_t code) const { return lowest + code * step(); }

  // Throws core::RangeError where the range is not as described above.
  void requireValid() const;

  friend constexpr bool operator==(const HeightRange&, const HeightRange&) = default;
};

static_assert(HeightRange{}.step() == 1.0 / 32);

}  // namespace skydrop::terrain
