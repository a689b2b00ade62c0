#include "app/cli/photo_series.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace skydrop::app {
namespace {

using accuracy::kPictureChannelNames;
using accuracy::kPictureChannels;

// Of a plot, in the order of the channels.
constexpr std::array<std::array<std::uint8_t, 3>, kPictureChannels> kColours = {
    {{20, 20, 20}, {170, 60, 190}, {210, 50, 40}, {40, 150, 60}, {40, 90, 210}}};

template <class... Values>
std::string formatted(const char* form, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), form, values...);
  return text.data();
}

bool tellsLand(const std::vector<PhotoDistances>& frames) {
  return !frames.empty() && frames[0].landChiSquare;
}

double mostOf(const std::vector<PhotoDistances>& frames) {
  double most = 1e-9;
  for (const PhotoDistances& frame : frames) most = std::max(most, std::ranges::max(frame.earthMovers));
  return most;
}

}  // namespace

std::string photoTable(const std::vector<PhotoDistances>& frames) {
  std::string text = "frame,seconds";
  for (const char* measure : {"chiSquare", "earthMovers", "land chiSquare", "land earthMovers"}) {
    if (measure[0] == 'l' && !tellsLand(frames)) continue;
    for (const std::string_view channel : kPictureChannelNames)
      text += "," + std::string(measure) + " " + std::string(channel);
  }
  text += ",utc,photo\n";
  for (const PhotoDistances& frame : frames) {
    text += formatted("%d,%.6g", frame.frame, frame.seconds);
    const auto add = [&](const auto& values) {
      for (const double value : values) text += formatted(",%.6g", value);
    };
    add(frame.chiSquare);
    add(frame.earthMovers);
    if (frame.landChiSquare) add(*frame.landChiSquare);
    if (frame.landEarthMovers) add(*frame.landEarthMovers);
    std::string name = frame.photo;
    std::erase_if(name, [](char c) { return c == '"' || c == '\n' || c == '\r'; });
    text += "," + (frame.utc ? sky::instantText(*frame.utc) : "") + ",\"" + name + "\"\n";
  }
  return text;
}

core::Image photoPlot(const std::vector<PhotoDistances>& frames) {
  constexpr int kWidth = 640, kHeight = 320, kMargin = 16;
  core::Image plot(kWidth, kHeight);
  std::ranges::fill(plot.rgba, std::uint8_t{255});
  const double most = mostOf(frames);
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

std::string photoPlotSvg(const std::vector<PhotoDistances>& frames) {
  constexpr int kWidth = 800, kHeight = 400, kLeft = 60, kRight = 110, kTop = 20, kBottom = 50;
  const double most = mostOf(frames);
  const double last = std::max<double>(1, static_cast<double>(frames.size()) - 1);
  const auto xOf = [&](std::size_t i) {
    return kLeft + (kWidth - kLeft - kRight) * static_cast<double>(i) / last;
  };
  const auto yOf = [&](double value) {
    return kHeight - kBottom - (kHeight - kTop - kBottom) * value / most;
  };
  std::string svg = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
      kWidth, kHeight);
  const auto text = [&](double x, double y, const char* anchor, const std::string& words) {
    svg += formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor) + words + "</text>\n";
  };
  for (int i = 0; i <= 4; ++i) {
    const double value = most * i / 4;
    svg += formatted("<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" stroke=\"#ccc\"/>\n", kLeft,
                     yOf(value), kWidth - kRight, yOf(value));
    text(kLeft - 6, yOf(value) + 4, "end", formatted("%.3g", value));
  }
  const std::size_t step = std::max<std::size_t>(1, frames.size() / 8);
  for (std::size_t i = 0; i < frames.size(); i += step) {
    const std::string when = frames[i].utc ? sky::instantText(*frames[i].utc).substr(11, 5)
                                           : formatted("%.6g s", frames[i].seconds);
    text(xOf(i), kHeight - kBottom + 18, "middle", when);
  }
  text((kLeft + kWidth - kRight) / 2.0, kHeight - 10, "middle",
       !frames.empty() && frames[0].utc ? "time, UTC" : "simulated time");
  text(kLeft, kTop - 6, "start", "earth mover's distance, share of the range");
  for (std::size_t c = 0; c < kPictureChannels; ++c) {
    const std::string colour = formatted("#%02x%02x%02x", kColours[c][0], kColours[c][1], kColours[c][2]);
    svg += "<polyline fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.5\" points=\"";
    for (std::size_t i = 0; i < frames.size(); ++i)
      svg += formatted("%.1f,%.1f ", xOf(i), yOf(frames[i].earthMovers[c]));
    svg += "\"/>\n";
    const double y = kTop + 16.0 * static_cast<double>(c) + 8;
    svg += formatted("<line x1=\"%d\" y1=\"%.1f\" x2=\"%d\" y2=\"%.1f\" stroke=\"%s\" stroke-width=\"3\"/>\n",
                     kWidth - kRight + 10, y, kWidth - kRight + 28, y, colour.c_str());
    text(kWidth - kRight + 34, y + 4, "start", std::string(kPictureChannelNames[c]));
  }
  return svg + "</svg>\n";
}

std::optional<sky::Instant> timeInName(std::string_view name) {
  // Digits alone count: twelve or fourteen of them, with at most one sign between two of them.
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t begin = 0; begin < name.size(); ++begin) {
    if (!isDigit(name[begin]) || (begin > 0 && isDigit(name[begin - 1]))) continue;
    std::string digits;
    for (std::size_t i = begin; i < name.size() && digits.size() < 14; ++i) {
      if (isDigit(name[i]))
        digits += name[i];
      else if (std::string_view("-_T. ").find(name[i]) == std::string_view::npos || i + 1 >= name.size() ||
               !isDigit(name[i + 1]))
        break;
    }
    if (digits.size() < 12) continue;
    digits.resize(digits.size() < 14 ? 12 : 14);
    if (digits.size() == 12) digits += "00";
    const std::string text = digits.substr(0, 4) + "-" + digits.substr(4, 2) + "-" + digits.substr(6, 2) +
                             "T" + digits.substr(8, 2) + ":" + digits.substr(10, 2) + ":" +
                             digits.substr(12, 2) + "Z";
    sky::Instant instant;
    if (sky::readInstant(text, instant).empty()) return instant;
  }
  return std::nullopt;
}

}  // namespace skydrop::app
