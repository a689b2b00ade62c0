// Photographs beside the picture.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace skydrop::app {

enum class PhotoView { none, overlay, wipe, beside };
inline constexpr std::array<std::string_view, 4> kPhotoViewNames = {"none", "overlay", "wipe", "beside"};

// Which pixels are compared: all; the sky of the rendered frame; what looks like sky in the photograph.
enum class PhotoSky { all, frame, photo };

struct PhotoRequest {
  std::filesystem::path file;                 // PNG or JPEG
  std::vector<std::filesystem::path> others;  // of other times: each has one in its name
  PhotoView view = PhotoView::none;
  double share = 0.5;                          // opacity, or how much of the width the photograph has
  std::optional<double> fieldDegrees;          // its horizontal field of view; without: that of the picture
  std::optional<double> panoramaFromDegrees;   // it goes round the horizon from this heading at its left edge
  PhotoSky sky = PhotoSky::all;                // without a mask
  std::optional<std::filesystem::path> mask;   // of the photograph: white is what counts, the sky
  std::optional<std::filesystem::path> table;  // CSV, a line for each frame
  std::optional<std::filesystem::path> plot;   // of the table: SVG, or PNG
};

}  // namespace skydrop::app
