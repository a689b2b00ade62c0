#include "app/cli/photo_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/cli/photo_sky.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/picture_file.h"

namespace skydrop::app {
namespace {

using accuracy::kPictureChannelNames;
using accuracy::kPictureChannels;

core::Image masked(core::Image photo, const core::Image& mask, const std::string& name) {
  if (mask.width != photo.width || mask.height != photo.height)
    throw core::DataError(name, "", "is not of the photograph's size");
  for (std::size_t i = 0; i < photo.rgba.size(); i += 4) {
    if (mask.rgba[i] < 128) photo.rgba[i + 3] = 0;
  }
  return photo;
}

}  // namespace

PhotoComparison::PhotoComparison(const PhotoRequest& request) : request_(request) {
  for (const auto& other : request.others) {
    for (const auto& file : {request.file, other}) {
      if (!timeInName(file.filename().string()))
        throw core::DataError(file.string(), "",
                              "has no time in its name (20260621T1300), by which one of several is chosen");
    }
  }
  take(request.file);
  if (request.table) table_.emplace(*request.table);
  if (request.plot) plot_.emplace(*request.plot);
}

void PhotoComparison::take(const std::filesystem::path& file) {
  if (file == taken_) return;
  whole_ = core::readPicture(file);
  photo_ = whole_;
  if (request_.mask)
    photo_ = masked(std::move(photo_), core::readPicture(*request_.mask), request_.mask->string());
  else if (request_.sky == PhotoSky::photo)
    photo_ = masked(std::move(photo_), skyOfPhoto(whole_), file.string());
  taken_ = file;
}

// The one whose name has the time nearest to it.
const std::filesystem::path& PhotoComparison::photoAt(const std::optional<sky::Instant>& utc) const {
  if (request_.others.empty()) return request_.file;
  if (!utc)
    throw core::DataError(
        request_.file.string(), "",
        "is one of several, by the time, and the sun does not go by the clock (sky.sun=clock)");
  const auto awayFrom = [&](const std::filesystem::path& file) {
    return std::abs(static_cast<double>(timeInName(file.filename().string())->utcMs - utc->utcMs));
  };
  const std::filesystem::path* nearest = &request_.file;
  for (const auto& other : request_.others) {
    if (awayFrom(other) < awayFrom(*nearest)) nearest = &other;
  }
  return *nearest;
}

namespace {

struct Distances {
  std::array<double, kPictureChannels> chiSquare{}, earthMovers{};
};

// Over the pixels that `seen` shows. Throws core::RangeError where there are none.
Distances distancesOf(const core::Image& picture, const core::Image& seen) {
  core::Image counted = picture;
  for (std::size_t i = 3; i < counted.rgba.size(); i += 4) counted.rgba[i] = seen.rgba[i];
  const accuracy::PictureHistogram taken = accuracy::histogramOf(seen);
  const accuracy::PictureHistogram rendered = accuracy::histogramOf(counted);
  Distances distances;
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    distances.chiSquare[c] = accuracy::chiSquare(rendered, taken, c);
    distances.earthMovers[c] = accuracy::earthMovers(rendered, taken, c);
  }
  return distances;
}

// Transparent where the mask, of the same size, is not white, or where it is.
core::Image where(core::Image seen, const core::Image& mask, bool isWhite) {
  for (std::size_t i = 0; i < seen.rgba.size(); i += 4) {
    if ((mask.rgba[i] >= 128) != isWhite) seen.rgba[i + 3] = 0;
  }
  return seen;
}

std::string wordsOf(const char* what, const Distances& distances) {
  std::string text = what;
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    std::array<char, 64> part{};
    std::snprintf(part.data(), part.size(), " %s %.3f %.3f", std::string(kPictureChannelNames[c]).c_str(),
                  distances.chiSquare[c], distances.earthMovers[c]);
    text += (c ? "," : "") + std::string(part.data());
  }
  return text;
}

}  // namespace

std::string PhotoComparison::compare(const core::Image& picture, const render::View& view, int frame,
                                     double seconds, const std::optional<sky::Instant>& utc,
                                     const core::Image* skyOfFrame) {
  take(photoAt(utc));
  const core::Image seen = asSeen(photo_, request_, view);
  PhotoDistances row;
  row.frame = frame;
  row.seconds = seconds;
  row.utc = utc;
  row.photo = taken_.filename().string();
  const bool splits = request_.sky == PhotoSky::frame && skyOfFrame != nullptr;
  std::string text;
  try {
    const Distances distances = distancesOf(picture, splits ? where(seen, *skyOfFrame, true) : seen);
    row.chiSquare = distances.chiSquare;
    row.earthMovers = distances.earthMovers;
    text = wordsOf(splits ? "photograph, sky, chi-square and earth mover's:"
                          : "photograph, chi-square and earth mover's:",
                   distances);
  } catch (const core::RangeError&) {
    throw core::DataError(taken_.string(), "", "shows nothing of what the camera sees, or all is masked");
  }
  if (splits) {
    Distances distances;
    try {
      distances = distancesOf(picture, where(seen, *skyOfFrame, false));
      text += "; land:" + wordsOf("", distances);
    } catch (const core::RangeError&) {  // there is only sky
    }
    row.landChiSquare = distances.chiSquare;
    row.landEarthMovers = distances.earthMovers;
  }
  frames_.push_back(row);
  return text;
}

core::Image PhotoComparison::shown(const core::Image& picture, const render::View& view) const {
  if (request_.view == PhotoView::none) return picture;
  return together(picture, asSeen(whole_, request_, view), request_.view, request_.share);
}

void PhotoComparison::finish() {
  if (table_) table_->write(photoTable(frames_));
  if (!plot_) return;
  if (request_.plot->extension() == ".svg")
    plot_->write(photoPlotSvg(frames_));
  else
    plot_->write(core::encodePng(photoPlot(frames_)));
}

}  // namespace skydrop::app
