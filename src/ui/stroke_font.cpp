#include "ui/stroke_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <string_view>

namespace skydrop::ui {
namespace {

// Strokes are separated by ';', points are x,y. A point in brackets is a corner to be rounded; a closing z
// joins the last point to the first.
struct GlyphSource {
  char32_t codePoint;
  std::string_view strokes;
};

constexpr GlyphSource kGlyphs[] = {
    {U' ', ""},
    {U'!', "0,6 0,1.9; 0,0 0,0.1"},
    {U'"', "0,6 0,4.6; 1.4,6 1.4,4.6"},
    {U'#', "0.9,0.4 1.5,5.6; 2.7,0.4 3.3,5.6; 0,2 4,2; 0.2,4 4.2,4"},
    {U'$', "3.9,4.9 (3.9,6) (0,6) (0,3.1) (4,3.1) (4,0) (0,0) 0,1.1; 2,-0.9 2,6.9"},
    {U'%', "4.2,6 0.2,0; (0,3.8) (1.6,3.8) (1.6,6) (0,6) z; (2.8,0) (4.4,0) (4.4,2.2) (2.8,2.2) z"},
    {U'&', "4.4,0 0.7,4.3 (0.7,6) (3,6) (3,3.9) (0,2.6) (0,0) (3.4,0) 4.4,2.6"},
    {U'\'', "0,6 0,4.6"},
    {U'(', "1.3,6.9 (0,5.2) (0,0.4) 1.3,-1.3"},
    {U')', "0,6.9 (1.3,5.2) (1.3,0.4) 0,-1.3"},
    {U'*', "1.5,3 1.5,6; 0.2,3.7 2.8,5.3; 0.2,5.3 2.8,3.7"},
    {U'+', "0,3 3.6,3; 1.8,1.2 1.8,4.8"},
    {U',', "0.5,0.2 0,-1.2"},
    {U'-', "0,2.8 2.4,2.8"},
    {U'.', "0,0 0,0.1"},
    {U'/', "0,-0.8 2.8,6.6"},
    {U'0', "(0,0) (4,0) (4,6) (0,6) z"},
    {U'1', "0.6,4.7 2.2,6 2.2,0"},
    {U'2', "0,4.8 (0,6) (4,6) (4,3.2) 0,0 4,0"},
    {U'3', "0.2,6 (3.9,6) (3.9,3.2) 1.2,3.2; 1.2,3.2 (4,3.2) (4,0) 0,0"},
    {U'4', "3.1,0 3.1,6 0,1.8 4.2,1.8"},
    {U'5', "3.7,6 0.3,6 0.2,3.6 (4,3.6) (4,0) 0,0"},
    {U'6', "3.6,6 (0,6) (0,0) (4,0) (4,3.5) (0,3.5) 0,2"},
    {U'7', "0,6 4,6 1.4,0"},
    {U'8', "(0.2,3.2) (3.8,3.2) (3.8,6) (0.2,6) z; (0,0) (4,0) (4,3.2) (0,3.2) z"},
    {U'9', "0.4,0 (4,0) (4,6) (0,6) (0,2.5) (4,2.5) 4,4"},
    {U':', "0,0.4 0,0.5; 0,3.6 0,3.7"},
    {U';', "0.5,0.2 0,-1.2; 0.5,3.6 0.5,3.7"},
    {U'<', "3,4.9 0,2.9 3,0.9"},
    {U'=', "0,2 3.4,2; 0,3.9 3.4,3.9"},
    {U'>', "0,4.9 3,2.9 0,0.9"},
    {U'?', "0,4.9 (0,6) (3.6,6) (3.6,3) (1.8,3) 1.8,1.7; 1.8,0 1.8,0.1"},
    {U'@',
     "3.4,3.9 (1.4,3.9) (1.4,1.6) 3.4,1.6; 3.4,3.9 (3.4,1.2) (4.8,1.2) (4.8,5.4) (0,5.4) (0,-0.6) 4.4,-0.6"},
    {U'A', "0,0 2.1,6 4.2,0; 0.7,2 3.5,2"},
    {U'B', "0,3.2 (3.7,3.2) (3.7,6) 0,6 0,0 (4,0) (4,3.2) 0,3.2"},
    {U'C', "4,4.7 (4,6) (0,6) (0,0) (4,0) 4,1.3"},
    {U'D', "0,0 0,6 (4.1,6) (4.1,0) z"},
    {U'E', "3.6,6 0,6 0,0 3.6,0; 0,3.1 3.1,3.1"},
    {U'F', "3.6,6 0,6 0,0; 0,3 3,3"},
    {U'G', "4,4.8 (4,6) (0,6) (0,0) (4,0) 4,2.8 2.3,2.8"},
    {U'H', "0,0 0,6; 4,0 4,6; 0,3.1 4,3.1"},
    {U'I', "0,0 0,6"},
    {U'J', "2.9,6 (2.9,0) (0,0) 0,1.5"},
    {U'K', "0,0 0,6; 3.8,6 0,2.3; 1.3,3.6 4,0"},
    {U'L', "0,6 0,0 3.4,0"},
    {U'M', "0,0 0,6 2.4,2 4.8,6 4.8,0"},
    {U'N', "0,0 0,6 4,0 4,6"},
    {U'O', "(0,0) (4.4,0) (4.4,6) (0,6) z"},
    {U'P', "0,0 0,6 (4,6) (4,2.7) 0,2.7"},
    {U'Q', "(0,0) (4.4,0) (4.4,6) (0,6) z; 2.7,1.5 4.6,-0.7"},
    {U'R', "0,0 0,6 (4,6) (4,2.8) 0,2.8; 1.9,2.8 4.1,0"},
    {U'S', "3.9,4.9 (3.9,6) (0,6) (0,3.1) (4,3.1) (4,0) (0,0) 0,1.1"},
    {U'T', "0,6 4.2,6; 2.1,6 2.1,0"},
    {U'U', "0,6 (0,0) (4.1,0) 4.1,6"},
    {U'V', "0,6 2.1,0 4.2,6"},
    {U'W', "0,6 1.5,0 3,5.2 4.5,0 6,6"},
    {U'X', "0,0 4.1,6; 0,6 4.1,0"},
    {U'Y', "0,6 2.1,2.9 4.2,6; 2.1,2.9 2.1,0"},
    {U'Z', "0,6 4,6 0,0 4,0"},
    {U'[', "1.4,6.8 0,6.8 0,-1.2 1.4,-1.2"},
    {U'\\', "0,6.6 2.8,-0.8"},
    {U']', "0,6.8 1.4,6.8 1.4,-1.2 0,-1.2"},
    {U'^', "0,4 1.5,6 3,4"},
    {U'_', "0,-1 4,-1"},
    {U'`', "0,6 0.9,5"},
    {U'a', "0.2,4.2 (3.2,4.2) 3.2,0 (0,0) (0,2.4) 3.2,2.4"},
    {U'b', "0,6 0,0 (3.3,0) (3.3,4.2) 0,4.2"},
    {U'c', "3,4.2 (0,4.2) (0,0) 3,0"},
    {U'd', "3.3,6 3.3,0 (0,0) (0,4.2) 3.3,4.2"},
    {U'e', "0,2.2 3.3,2.2 (3.3,4.2) (0,4.2) (0,0) 3.1,0"},
    {U'f', "2.6,6 (1,6) 1,0; 0,4.2 2.4,4.2"},
    {U'g', "3.3,0 (0,0) (0,4.2) 3.3,4.2 (3.3,-1.9) 0.4,-1.9"},
    {U'h', "0,6 0,0; 0,4.2 (3.2,4.2) 3.2,0"},
    {U'i', "0,0 0,4.2; 0,5.9 0,6"},
    {U'j', "1.1,4.2 (1.1,-1.9) 0,-1.9; 1.1,5.9 1.1,6"},
    {U'k', "0,0 0,6; 2.9,4.2 0,1.5; 1,2.4 3.1,0"},
    {U'l', "0,6 (0,0) 1.2,0"},
    {U'm', "0,0 0,4.2 (2.4,4.2) 2.4,0; 1.6,4.2 (4.8,4.2) 4.8,0"},
    {U'n', "0,0 0,4.2 (3.2,4.2) 3.2,0"},
    {U'o', "(0,0) (3.3,0) (3.3,4.2) (0,4.2) z"},
    {U'p', "0,-1.9 0,4.2 (3.3,4.2) (3.3,0) 0,0"},
    {U'q', "3.3,-1.9 3.3,4.2 (0,4.2) (0,0) 3.3,0"},
    {U'r', "0,0 0,4.2 2.2,4.2"},
    {U's', "3,4.2 (0,4.2) (0,2.2) (3.1,2.2) (3.1,0) 0,0"},
    {U't', "1,5.8 (1,0) 2.6,0; 0,4.2 2.5,4.2"},
    {U'u', "0,4.2 (0,0) 3.2,0; 3.2,4.2 3.2,0"},
    {U'v', "0,4.2 1.7,0 3.4,4.2"},
    {U'w', "0,4.2 1.2,0 2.4,3.7 3.6,0 4.8,4.2"},
    {U'x', "0,0 3.2,4.2; 0,4.2 3.2,0"},
    {U'y', "0,4.2 (0,0) 3.2,0; 3.2,4.2 (3.2,-1.9) 0.4,-1.9"},
    {U'z', "0,4.2 3.1,4.2 0,0 3.1,0"},
    {U'{', "1.8,6.8 (0.8,6.8) (0.8,2.8) 0,2.8 (0.8,2.8) (0.8,-1.2) 1.8,-1.2"},
    {U'|', "0,6.8 0,-1.2"},
    {U'}', "0,6.8 (1,6.8) (1,2.8) 1.8,2.8 (1,2.8) (1,-1.2) 0,-1.2"},
    {U'~', "0,2.5 1.2,3.5 2.4,2.5 3.6,3.5"},
    {U'\u00b0', "(0,4.4) (1.7,4.4) (1.7,6.1) (0,6.1) z"},
    {U'\u00b1', "0,3.6 3.6,3.6; 1.8,1.8 1.8,5.4; 0,0.4 3.6,0.4"},
    {U'\u00b2', "0,6 (1.7,6) (1.7,4.9) 0,3.4 1.8,3.4"},
    {U'\u00b3', "0,6.2 1.7,6.2 0.8,5.1 (1.8,5.1) (1.8,3.4) 0,3.4"},
    {U'\u00b5', "0,4.2 0,-1.9; 0,0 3.2,0; 3.2,4.2 3.2,0"},
    {U'\u00b7', "0,2.8 0,2.9"},
    {U'\u00d7', "0,1.4 3,4.4; 0,4.4 3,1.4"},
    {U'\u2013', "0,2.8 3.6,2.8"},
    {U'\u2026', "0,0 0,0.1; 1.8,0 1.8,0.1; 3.6,0 3.6,0.1"},
    {U'\u2190', "0,3 4.6,3; 1.9,4.9 0,3 1.9,1.1"},
    {U'\u2191', "1.9,0.4 1.9,5.6; 0,3.7 1.9,5.6 3.8,3.7"},
    {U'\u2192', "0,3 4.6,3; 2.7,4.9 4.6,3 2.7,1.1"},
    {U'\u2193', "1.9,5.6 1.9,0.4; 0,2.3 1.9,0.4 3.8,2.3"},
    {U'\u21a9', "1.7,5.9 0,4.2 1.7,2.5; 0,4.2 (4.2,4.2) (4.2,0.2) 1.4,0.2"},
};

constexpr double kStrokeRadius = 0.40;  // units: half the pen's width
constexpr double kMinRadiusPx = 0.5;    // thinner strokes would fade
constexpr double kCornerRadius = 1.75;  // units
constexpr double kSpacing = 1.75;       // units between the centre lines of neighbouring letters
constexpr double kSpaceAdvance = 3.2;   // units
constexpr int kCornerSegments = 6;

struct Point {
  glm::dvec2 position;
  bool rounded = false;
};

struct Stroke {
  std::vector<Point> points;
  bool closed = false;
};

std::vector<Stroke> parseStrokes(std::string_view text) {
  std::vector<Stroke> strokes;
  Stroke stroke;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    if (*at == ' ' || *at == ')') {
      ++at;
    } else if (*at == ';') {
      strokes.push_back(std::move(stroke));
      stroke = {};
      ++at;
    } else if (*at == 'z') {
      stroke.closed = true;
      ++at;
    } else {
      Point point;
      point.rounded = *at == '(';
      if (point.rounded) ++at;
      char* next = nullptr;  // the table's strings are literals: terminated
      point.position.x = std::strtod(at, &next);
      point.position.y = std::strtod(next + 1, &next);
      at = next;
      stroke.points.push_back(point);
    }
  }
  if (!stroke.points.empty()) strokes.push_back(std::move(stroke));
  return strokes;
}

// Moves the straight parts of a glyph onto pixel centres: every coordinate along which a stroke runs is
// rounded, and what lies between is interpolated.
class GridFit {
 public:
  GridFit(const std::vector<Stroke>& strokes, int axis, double pixelsPerUnit)
      : pixelsPerUnit_(pixelsPerUnit) {
    const int other = 1 - axis;
    for (const Stroke& stroke : strokes) {
      for (std::size_t i = 0; i < stroke.points.size(); ++i) {
        const bool last = i + 1 == stroke.points.size();
        if (last && !stroke.closed) break;
        const glm::dvec2 a = stroke.points[i].position;
        const glm::dvec2 b = stroke.points[last ? 0 : i + 1].position;
        if (std::abs(a[axis] - b[axis]) < 0.15 && std::abs(a[other] - b[other]) > 0.5)
          knots_.push_back(a[axis]);
      }
    }
    std::ranges::sort(knots_);
    knots_.erase(std::unique(knots_.begin(), knots_.end(), [](double a, double b) { return b - a < 0.15; }),
                 knots_.end());
  }

  double operator()(double unit) const {
    if (knots_.empty()) return unit * pixelsPerUnit_;
    const auto above = std::ranges::lower_bound(knots_, unit);
    if (above == knots_.begin()) return fitted(*above) + (unit - *above) * pixelsPerUnit_;
    const double low = *(above - 1);
    if (above == knots_.end()) return fitted(low) + (unit - low) * pixelsPerUnit_;
    return fitted(low) + (fitted(*above) - fitted(low)) * (unit - low) / (*above - low);
  }

 private:
  double fitted(double unit) const { return std::floor(unit * pixelsPerUnit_ + 0.5); }

  double pixelsPerUnit_;
  std::vector<double> knots_;
};

struct Segment {
  glm::dvec2 a, b;
};

// Replaces each rounded corner by a quadratic arc that leaves its two edges at most kCornerRadius away.
std::vector<Segment> flatten(const Stroke& stroke, double pixelsPerUnit) {
  std::vector<glm::dvec2> line;
  const std::size_t count = stroke.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& point = stroke.points[i];
    const bool end = !stroke.closed && (i == 0 || i + 1 == count);
    if (!point.rounded || end) {
      line.push_back(point.position);
      continue;
    }
    const auto cut = [&](const Point& neighbour) {
      const glm::dvec2 edge = neighbour.position - point.position;
      const double length = glm::length(edge);
      const double reach =
          std::min(kCornerRadius * pixelsPerUnit, neighbour.rounded ? length / 2 : length * 0.9);
      return point.position + edge * (reach / std::max(length, 1e-9));
    };
    const glm::dvec2 from = cut(stroke.points[(i + count - 1) % count]);
    const glm::dvec2 to = cut(stroke.points[(i + 1) % count]);
    for (int k = 0; k <= kCornerSegments; ++k) {
      const double t = static_cast<double>(k) / kCornerSegments;
      line.push_back(from * ((1 - t) * (1 - t)) + point.position * (2 * t * (1 - t)) + to * (t * t));
    }
  }
  if (stroke.closed) line.push_back(line.front());
  std::vector<Segment> segments;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) segments.push_back({line[i], line[i + 1]});
  return segments;
}

double squaredDistance(const Segment& segment, glm::dvec2 p) {
  const glm::dvec2 ab = segment.b - segment.a, ap = p - segment.a;
  const double length2 = glm::dot(ab, ab);
  const double t = length2 > 0 ? std::clamp(glm::dot(ap, ab) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec2 d = ap - ab * t;
  return glm::dot(d, d);
}

std::string_view strokesOf(char32_t codePoint) {
  const auto find = [](char32_t c) {
    return std::ranges::lower_bound(kGlyphs, c, {}, &GlyphSource::codePoint);
  };
  const auto* found = find(codePoint);
  if (found == std::end(kGlyphs) || found->codePoint != codePoint) found = find(U'?');
  return found->strokes;
}

}  // namespace

std::span<const char32_t> strokeFontCodePoints() {
  static constexpr auto kCodePoints = [] {
    std::array<char32_t, std::size(kGlyphs)> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = kGlyphs[i].codePoint;
    return all;
  }();
  static_assert(std::ranges::is_sorted(kCodePoints));
  return kCodePoints;
}

GlyphBitmap rasterizeGlyph(char32_t codePoint, int sizePixels, double halo) {
  const double pixelsPerUnit = std::max(sizePixels, 1) / kLineUnits;
  std::vector<Stroke> strokes = parseStrokes(strokesOf(codePoint));
  GlyphBitmap bitmap;
  if (strokes.empty()) {
    bitmap.advance = static_cast<int>(std::floor(kSpaceAdvance * pixelsPerUnit + 0.5));
    return bitmap;
  }

  const GridFit fitX(strokes, 0, pixelsPerUnit), fitY(strokes, 1, pixelsPerUnit);
  const double radius = std::max(kStrokeRadius * pixelsPerUnit, kMinRadiusPx);
  const bool digit = codePoint >= U'0' && codePoint <= U'9';
  // The pen starts half a gap into the advance; half a pixel moves strokes from pixel corners to pixel
  // centres.
  const double left = std::floor(kSpacing / 2 * pixelsPerUnit + 0.5) + 0.5;
  const double baseline = std::floor(kAscentUnits * pixelsPerUnit + 0.5) - 0.5;
  double right = 0;
  glm::dvec2 lowest(std::numeric_limits<double>::max()), highest(std::numeric_limits<double>::lowest());
  std::vector<Segment> segments;
  for (Stroke& stroke : strokes) {
    for (Point& point : stroke.points) {
      const glm::dvec2 fitted(fitX(point.position.x), fitY(point.position.y));
      right = std::max(right, fitted.x);
      point.position = {left + fitted.x, baseline - fitted.y};
      lowest = glm::dvec2(std::min(lowest.x, point.position.x), std::min(lowest.y, point.position.y));
      highest = glm::dvec2(std::max(highest.x, point.position.x), std::max(highest.y, point.position.y));
    }
    const std::vector<Segment> part = flatten(stroke, pixelsPerUnit);
    segments.insert(segments.end(), part.begin(), part.end());
  }
  // Figures share one advance, so numbers do not jitter while they count.
  if (digit) right = std::floor(4 * pixelsPerUnit + 0.5);
  bitmap.advance = static_cast<int>(std::floor(kSpacing * pixelsPerUnit + right + 0.5));

  const double reach = radius + halo + 0.5;
  bitmap.offsetX = static_cast<int>(std::floor(lowest.x - reach));
  bitmap.offsetY = static_cast<int>(std::floor(lowest.y - reach));
  bitmap.width = static_cast<int>(std::ceil(highest.x + reach)) - bitmap.offsetX;
  bitmap.height = static_cast<int>(std::ceil(highest.y + reach)) - bitmap.offsetY;
  bitmap.coverage.resize(static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height));
  for (int y = 0; y < bitmap.height; ++y) {
    for (int x = 0; x < bitmap.width; ++x) {
      const glm::dvec2 centre(x + bitmap.offsetX + 0.5, y + bitmap.offsetY + 0.5);
      double nearest2 = std::numeric_limits<double>::max();
      for (const Segment& segment : segments) nearest2 = std::min(nearest2, squaredDistance(segment, centre));
      const double covered = std::clamp(reach - std::sqrt(nearest2), 0.0, 1.0);
      bitmap.coverage[static_cast<std::size_t>(y * bitmap.width + x)] =
          static_cast<std::uint8_t>(covered * 255 + 0.5);
    }
  }
  return bitmap;
}

}  // namespace skydrop::ui
