// A photograph beside rendered frames: laid over them, and compared by their histograms.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/photo_series.h"
#include "app/session/photo_seen.h"
#include "app/types/photo_request.h"
#include "skydrop/accuracy/picture_histogram.h"
#include "skydrop/core/image.h"
#include "skydrop/core/output_file.h"
#include "skydrop/render/frame/view.h"

namespace skydrop::app {

class PhotoComparison {
 public:
  // Reads the first photograph and the mask, and opens the outputs. Throws core::DataError.
  explicit PhotoComparison(const PhotoRequest& request);

  // Whether compare() wants the sky of the frame.
  bool wantsSky() const { return request_.sky == PhotoSky::frame && !request_.mask; }
  // A line about the frame; it becomes a row of the table. `utc`: its time, where the sun goes by the clock;
  // skyOfFrame: of the picture's size, white where it shows sky (photo_sky.h). Throws core::DataError where
  // they share no pixel, and a photograph that cannot be read.
  std::string compare(const core::Image& picture, const render::View& view, int frame, double seconds,
                      const std::optional<sky::Instant>& utc = {}, const core::Image* skyOfFrame = nullptr);
  // What is written of the frame.
  core::Image shown(const core::Image& picture, const render::View& view) const;
  // Writes table and plot.
  void finish();

 private:
  void take(const std::filesystem::path& file);
  const std::filesystem::path& photoAt(const std::optional<sky::Instant>& utc) const;

  PhotoRequest request_;
  std::filesystem::path taken_;  // the photograph that is held now
  core::Image photo_;            // what the mask leaves out is transparent
  core::Image whole_;            // without the mask
  std::vector<PhotoDistances> frames_;
  std::optional<core::OutputFile> table_, plot_;
};

}  // namespace skydrop::app
