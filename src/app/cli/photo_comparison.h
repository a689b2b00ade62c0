// A photograph beside rendered frames: laid over them, and compared by their histograms.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/types/command_line.h"
#include "skydrop/accuracy/picture_histogram.h"
#include "skydrop/core/image.h"
#include "skydrop/core/output_file.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::app {

// The photograph as the view would see it: of the view's size, transparent where it shows nothing. Of a
// panorama the middle row is the horizon, and a degree is as many pixels high as wide; else the photograph's
// middle is the view's, by its field of view or, without one, by the view's.
core::Image asSeen(const core::Image& photo, const PhotoRequest& request, const render::View& view);

// The picture with the photograph of its size: laid over it, up to a share of its width, or to its left.
core::Image together(const core::Image& picture, const core::Image& photo, PhotoView view, double share);

struct PhotoDistances {
  int frame = 0;
  double seconds = 0;  // simulated
  std::array<double, accuracy::kPictureChannels> chiSquare{}, earthMovers{};
};

std::string photoTable(const std::vector<PhotoDistances>& frames);  // CSV
core::Image photoPlot(const std::vector<PhotoDistances>& frames);   // earth mover's over the frames

class PhotoComparison {
 public:
  // Reads photograph and mask, and opens the outputs. Throws core::DataError.
  explicit PhotoComparison(const PhotoRequest& request);

  // A line about the frame; it becomes a row of the table. Throws core::DataError where they share no pixel.
  std::string compare(const core::Image& picture, const render::View& view, int frame, double seconds);
  // What is written of the frame.
  core::Image shown(const core::Image& picture, const render::View& view) const;
  // Writes table and plot.
  void finish();

 private:
  PhotoRequest request_;
  core::Image photo_;  // what the mask leaves out is transparent
  core::Image whole_;  // without the mask
  std::vector<PhotoDistances> frames_;
  std::optional<core::OutputFile> table_, plot_;
};

}  // namespace skydrop::app
