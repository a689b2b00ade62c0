// What a picture's light and colours are, and how far two pictures are apart in them, wherever in the picture
// they stand: for a photograph beside a rendered sky, which never have the same clouds. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "skydrop/core/image.h"

namespace skydrop::accuracy {

inline constexpr std::size_t kPictureChannels = 5, kHistogramBins = 64;
inline constexpr std::array<std::string_view, kPictureChannels> kPictureChannelNames = {
    "brightness", "hue", "red", "green", "blue"};

// Shares of the pixels by value, of the sRGB-encoded picture: brightness is the luma of ITU-R BT.709, hue
// that of HSV, a circle, by which each pixel counts as much as it has chroma. Each channel sums up to 1; hue
// to 0 where nothing has a colour.
struct PictureHistogram {
  std::array<std::array<double, kHistogramBins>, kPictureChannels> share{};
  std::size_t pixels = 0;  // that counted
};

// `mask`: pixels count where its red is 128 or more, at the same share of width and height; null: all do.
// Pixels that are transparent (alpha below 128) never do. Throws core::RangeError where none is left.
PictureHistogram histogramOf(const core::Image& picture, const core::Image* mask = nullptr);

// Half of the sum of (a - b)^2 / (a + b): 0 the same, 1 nothing in common (Pele and Werman 2010).
double chiSquare(const PictureHistogram& a, const PictureHistogram& b, std::size_t channel);

// The earth mover's distance as a share of the channel's range: how far shares have to be moved in the mean.
// Of a line the sum of the differences of the cumulative shares; of the circle of hues their sum about their
// median (Werman, Peleg and Rosenfeld 1985), at most .5. Where one of two has no hue: .5, where both: 0.
double earthMovers(const PictureHistogram& a, const PictureHistogram& b, std::size_t channel);

}  // namespace skydrop::accuracy
