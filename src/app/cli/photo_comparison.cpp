#include "app/cli/photo_comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/trigonometric.hpp>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/picture_file.h"

namespace skydrop::app {
namespace {

using accuracy::kPictureChannelNames;
using accuracy::kPictureChannels;

// Pixels of a photograph between whose centres a place lies, mixed; x goes round where `wraps`.
std::array<std::uint8_t, 4> sampled(const core::Image& photo, double u, double v, bool wraps) {
  const double x = u * photo.width - 0.5, y = v * photo.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  std::array<double, 4> sum{};
  for (int dy = 0; dy < 2; ++dy) {
    for (int dx = 0; dx < 2; ++dx) {
      const double weight = (dx ? x - left : 1 - (x - left)) * (dy ? y - top : 1 - (y - top));
      int column = static_cast<int>(left) + dx;
      column =
          wraps ? (column % photo.width + photo.width) % photo.width : std::clamp(column, 0, photo.width - 1);
      const int row = std::clamp(static_cast<int>(top) + dy, 0, photo.height - 1);
      const std::uint8_t* pixel = photo.pixel(column, row);
      for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * pixel[c];
    }
  }
  std::array<std::uint8_t, 4> out{};
  for (std::size_t c = 0; c < 4; ++c) out[c] = static_cast<std::uint8_t>(std::lround(sum[c]));
  return out;
}

// Where the photograph shows what a pixel of the view sees, shares of its width and height from its upper
// left corner; outside of [0, 1] nowhere.
glm::dvec2 placeOf(const core::Image& photo, const PhotoRequest& request, const render::View& view,
                   const glm::dvec2& pixel) {
  if (request.panoramaFromDegrees) {
    const glm::dvec3 d = render::rayDirection(view, pixel);
    const double heading = glm::degrees(std::atan2(d.x, -d.z)), pitch = glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0)));
    const double turn = (heading - *request.panoramaFromDegrees) / 360;
    return {turn - std::floor(turn), 0.5 - pitch * photo.width / (360.0 * photo.height)};
  }
  const double half = std::tan(view.fovYRad / 2);
  const glm::dvec2 tangent((2 * pixel.x / view.width - 1) * half * view.aspect(),
                           (2 * pixel.y / view.height - 1) * half);
  const double halfWidth =
      request.fieldDegrees ? std::tan(glm::radians(*request.fieldDegrees) / 2) : half * view.aspect();
  return {0.5 + 0.5 * tangent.x / halfWidth, 0.5 - 0.5 * tangent.y / halfWidth * photo.width / photo.height};
}

core::Image masked(core::Image photo, const core::Image& mask, const std::string& name) {
  if (mask.width != photo.width || mask.height != photo.height)
    throw core::DataError(name, "", "is not of the photograph's size");
  for (std::size_t i = 0; i < photo.rgba.size(); i += 4) {
    if (mask.rgba[i] < 128) photo.rgba[i + 3] = 0;
  }
  return photo;
}

}  // namespace

core::Image asSeen(const core::Image& photo, const PhotoRequest& request, const render::View& view) {
  core::Image out(view.width, view.height);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const glm::dvec2 at = placeOf(photo, request, view, {x + 0.5, view.height - y - 0.5});
      if (!(at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1)) continue;
      const auto pixel = sampled(photo, at.x, at.y, request.panoramaFromDegrees.has_value());
      std::ranges::copy(pixel, out.pixel(x, y));
    }
  }
  return out;
}

core::Image together(const core::Image& picture, const core::Image& photo, PhotoView view, double share) {
  if (view == PhotoView::none) return picture;
  const bool beside = view == PhotoView::beside;
  core::Image out(beside ? 2 * picture.width : picture.width, picture.height);
  const auto wiped = static_cast<int>(std::lround(share * picture.width));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t *rendered = picture.pixel(x, y), *taken = photo.pixel(x, y);
      const double opacity = taken[3] / 255.0 * (view == PhotoView::overlay ? share : beside || x < wiped);
      std::uint8_t* to = out.pixel(x, y);
      for (int c = 0; c < 3; ++c) {
        const double under = beside ? 0 : rendered[c];
        to[c] = static_cast<std::uint8_t>(std::lround(under + opacity * (taken[c] - under)));
      }
      to[3] = 255;
      if (beside) std::copy_n(rendered, 4, out.pixel(picture.width + x, y));
    }
  }
  return out;
}

std::string photoTable(const std::vector<PhotoDistances>& frames) {
  std::string text = "frame,seconds";
  for (const char* measure : {"chiSquare", "earthMovers"}) {
    for (const std::string_view channel : kPictureChannelNames)
      text += "," + std::string(measure) + " " + std::string(channel);
  }
  text += "\n";
  for (const PhotoDistances& frame : frames) {
    std::array<char, 64> cell{};
    std::snprintf(cell.data(), cell.size(), "%d,%.6g", frame.frame, frame.seconds);
    text += cell.data();
    for (const auto* values : {&frame.chiSquare, &frame.earthMovers}) {
      for (const double value : *values) {
        std::snprintf(cell.data(), cell.size(), ",%.6g", value);
        text += cell.data();
      }
    }
    text += "\n";
  }
  return text;
}

core::Image photoPlot(const std::vector<PhotoDistances>& frames) {
  constexpr int kWidth = 640, kHeight = 320, kMargin = 16;
  constexpr std::array<std::array<std::uint8_t, 3>, kPictureChannels> kColours = {
      {{20, 20, 20}, {170, 60, 190}, {210, 50, 40}, {40, 150, 60}, {40, 90, 210}}};
  core::Image plot(kWidth, kHeight);
  std::ranges::fill(plot.rgba, std::uint8_t{255});
  double most = 1e-9;
  for (const PhotoDistances& frame : frames) most = std::max(most, std::ranges::max(frame.earthMovers));
  const auto dot = [&](int x, int y, const std::array<std::uint8_t, 3>& colour) {
    if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) return;
    std::ranges::copy(colour, plot.pixel(x, y));
  };
  const auto line = [&](double x0, double y0, double x1, double y1, const auto& colour) {
    const int steps =
        std::max(1, static_cast<int>(std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0)))));
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      dot(static_cast<int>(std::lround(x0 + t * (x1 - x0))),
          static_cast<int>(std::lround(y0 + t * (y1 - y0))), colour);
    }
  };
  constexpr std::array<std::uint8_t, 3> kAxis = {140, 140, 140};
  line(kMargin, kMargin, kMargin, kHeight - kMargin, kAxis);
  line(kMargin, kHeight - kMargin, kWidth - kMargin, kHeight - kMargin, kAxis);
  const auto xOf = [&](std::size_t i) {
    const double last = std::max<double>(1, static_cast<double>(frames.size()) - 1);
    return kMargin + (kWidth - 2 * kMargin) * static_cast<double>(i) / last;
  };
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    const auto yOf = [&](std::size_t i) {
      return kHeight - kMargin - (kHeight - 2 * kMargin) * frames[i].earthMovers[c] / most;
    };
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const std::size_t next = std::min(i + 1, frames.size() - 1);
      line(xOf(i), yOf(i), xOf(next), yOf(next), kColours[c]);
    }
  }
  return plot;
}

PhotoComparison::PhotoComparison(const PhotoRequest& request)
    : request_(request), photo_(core::readPicture(request.file)), whole_(photo_) {
  if (request.mask)
    photo_ = masked(std::move(photo_), core::readPicture(*request.mask), request.mask->string());
  if (request.table) table_.emplace(*request.table);
  if (request.plot) plot_.emplace(*request.plot);
}

std::string PhotoComparison::compare(const core::Image& picture, const render::View& view, int frame,
                                     double seconds) {
  const core::Image seen = asSeen(photo_, request_, view);
  PhotoDistances row{frame, seconds, {}, {}};
  try {
    const accuracy::PictureHistogram taken = accuracy::histogramOf(seen);
    core::Image counted = picture;  // where the photograph says something
    for (std::size_t i = 3; i < counted.rgba.size(); i += 4) counted.rgba[i] = seen.rgba[i];
    const accuracy::PictureHistogram rendered = accuracy::histogramOf(counted);
    for (std::size_t c = 0; c < kPictureChannels; ++c) {
      row.chiSquare[c] = accuracy::chiSquare(rendered, taken, c);
      row.earthMovers[c] = accuracy::earthMovers(rendered, taken, c);
    }
  } catch (const core::RangeError&) {
    throw core::DataError(request_.file.string(), "",
                          "shows nothing of what the camera sees, or all is masked");
  }
  frames_.push_back(row);
  std::string text = "photograph, chi-square and earth mover's:";
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    std::array<char, 64> part{};
    std::snprintf(part.data(), part.size(), " %s %.3f %.3f", std::string(kPictureChannelNames[c]).c_str(),
                  row.chiSquare[c], row.earthMovers[c]);
    text += (c ? "," : "") + std::string(part.data());
  }
  return text;
}

core::Image PhotoComparison::shown(const core::Image& picture, const render::View& view) const {
  if (request_.view == PhotoView::none) return picture;
  return together(picture, asSeen(whole_, request_, view), request_.view, request_.share);
}

void PhotoComparison::finish() {
  if (table_) table_->write(photoTable(frames_));
  if (plot_) plot_->write(core::encodePng(photoPlot(frames_)));
}

}  // namespace skydrop::app
