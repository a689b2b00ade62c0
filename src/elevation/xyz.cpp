// XYZ texts: a place and a height a line, in any order, on a grid; the first line may be a heading.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "elevation/readers.h"
#include "elevation/text_scan.h"
#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

struct Axis {
  double first = 0, step = 0;
  int count = 0;
};

// The grid that sorted, distinct coordinates lie on: the smallest distance is its step.
Axis axisOf(std::vector<double> values, const std::string& name, const char* what) {
  std::sort(values.begin(), values.end());
  const double span = values.back() - values.front();
  double step = span;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    if (gap > 1e-9 * std::max(1.0, std::abs(values[i]))) step = std::min(step, gap);
  }
  if (!(span > 0)) return {values.front(), 0, 1};
  const double cells = std::round(span / step);
  if (cells >= kMostSide) throw DataError(name, what, "the places lie on no grid");
  step = span / cells;
  for (const double value : values) {
    const double at = (value - values.front()) / step;
    if (std::abs(at - std::round(at)) > 0.02)
      throw DataError(name, what, "the places lie on no grid: " + std::to_string(value));
  }
  return {values.front(), step, static_cast<int>(cells) + 1};
}

}  // namespace

std::shared_ptr<const Raster> readXyz(const std::string& name, std::string_view text,
                                      const std::optional<std::string>& crs) {
  struct Point {
    double x, y;
    float height;
  };
  std::vector<Point> points;
  TextScan scan(text);
  for (scan.skip(true); !scan.atEnd(); scan.skip(true)) {
    const std::size_t line = scan.line();
    std::array<double, 3> values{};
    int count = 0;
    for (; count < 3 && !scan.atLineEnd(); ++count, scan.skip(false)) {
      const auto value = scan.number();
      if (!value) break;
      values[static_cast<std::size_t>(count)] = *value;
    }
    if (count == 0 && points.empty() && line == 1) {
      scan.skipLine();
      continue;
    }
    if (count < 3 || !scan.atLineEnd())
      throw DataError(name, "line " + std::to_string(line), "is not three numbers X Y Z");
    if (!std::isfinite(values[0]) || !std::isfinite(values[1]) || std::abs(values[0]) > 1e9 ||
        std::abs(values[1]) > 1e9)
      throw DataError(name, "line " + std::to_string(line), "is no place on earth");
    if (points.size() == kMostHeldCells)
      throw DataError(name, "size", "more than 2^24 places: a GeoTIFF in tiles may have more");
    points.push_back(
        {values[0], values[1], values[2] == -9999 ? heightOrVoid(NAN) : heightOrVoid(values[2])});
  }
  if (points.empty()) throw DataError(name, "", "has no line of three numbers X Y Z");
  std::vector<double> xs(points.size()), ys(points.size());
  std::transform(points.begin(), points.end(), xs.begin(), [](const Point& p) { return p.x; });
  std::transform(points.begin(), points.end(), ys.begin(), [](const Point& p) { return p.y; });
  Axis x = axisOf(std::move(xs), name, "X"), y = axisOf(std::move(ys), name, "Y");
  if (static_cast<std::size_t>(x.count) * static_cast<std::size_t>(y.count) > kMostHeldCells)
    throw DataError(name, "size", "the grid of the places has more than 2^24 cells");
  const glm::dvec2 last{x.first + (x.count - 1) * x.step, y.first + (y.count - 1) * y.step};
  const auto guess = guessedCrs({x.first, y.first}, last);
  if (!crs && !guess)
    throw DataError(name, "reference system", "is not told by the coordinates: put a .prj file beside it");
  // One row or column has the cells of the other axis; one place alone a cell of a size that does not matter.
  const double other = guess == "EPSG:4326" ? 1.0 / 3600 : 1;
  if (x.step == 0) x.step = y.step > 0 ? y.step : other;
  if (y.step == 0) y.step = x.step;
  std::vector<float> heights(static_cast<std::size_t>(x.count) * static_cast<std::size_t>(y.count),
                             std::numeric_limits<float>::quiet_NaN());
  for (const Point& point : points) {
    const auto column = static_cast<std::size_t>(std::lround((point.x - x.first) / x.step));
    const auto row = static_cast<std::size_t>(std::lround((last.y - point.y) / y.step));
    heights[row * static_cast<std::size_t>(x.count) + column] = point.height;
  }
  return makeHeldRaster(name, "XYZ", x.count, y.count,
                        {crs.value_or(guess.value_or("")), {x.first, last.y}, {x.step, y.step}},
                        std::move(heights));
}

}  // namespace skydrop::elevation
