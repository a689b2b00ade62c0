// The distances of a photograph, or of a day of them, from rendered frames: as a table and as plots.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/picture_histogram.h"
#include "skydrop/core/image.h"
#include "skydrop/sky/instant.h"

namespace skydrop::app {

struct PhotoDistances {
  int frame = 0;
  double seconds = 0;  // simulated
  std::array<double, accuracy::kPictureChannels> chiSquare{}, earthMovers{};
  std::optional<sky::Instant> utc;  // of the frame, where the sun goes by the clock
  std::string photo;                // the file's name
  // Of what is not sky, where that was told.
  std::optional<std::array<double, accuracy::kPictureChannels>> landChiSquare, landEarthMovers;
};

std::string photoTable(const std::vector<PhotoDistances>& frames);  // CSV
core::Image photoPlot(const std::vector<PhotoDistances>& frames);   // earth mover's over the frames
std::string photoPlotSvg(const std::vector<PhotoDistances>& frames);

// The time that a name of a file has in it: 20260621T1300, 2026-06-21_13-00-30 and the like, UTC.
std::optional<sky::Instant> timeInName(std::string_view name);

}  // namespace skydrop::app
