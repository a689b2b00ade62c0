// From world metres to columns and rows of a lattice of heights. The way leads over the earth and a map's
// projection, which would cost microseconds a point; so it is asked for on a grid of nodes, and between them
// a Catmull-Rom surface takes over (C1, like the land on it).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "elevation/surface_kernels.h"
#include "skydrop/elevation/projection.h"
#include "skydrop/elevation/raster.h"

namespace skydrop::elevation {

// Positions of the world, metres (x east, z south).
struct WorldRect {
  glm::dvec2 lo, hi;
};

class Chart {
 public:
  // Distance of nodes. The surface is off by less than a millimetre up to 60 degrees of latitude in degrees,
  // and 1 cm up to 85; everywhere on maps in metres.
  static constexpr double kNodeM = 4096;
  // Node values are multiples of this share of a cell, so that libraries that differ in the last bits give
  // the same land.
  static constexpr double kGrain = 1.0 / 16384;
  // Nearer to a pole degrees are no smooth coordinates: there each point is asked for, at microseconds.
  static constexpr double kSmoothLatitude = 85;

  // The part of the world that is wanted, at most 1e6 m from the origin; longitudes are turned to within half
  // a turn of `middle`, that of the data (any in maps of metres). Throws core::DataError in the name of
  // `file`.
  Chart(const LocalPlane& plane, const Georeference& lattice, double middle, const WorldRect& wanted,
        const std::string& file);

  bool isExact() const { return isExact_; }
  bool touches(const WorldRect& rect) const {
    return rect.hi.x >= wanted_.lo.x && rect.lo.x <= wanted_.hi.x && rect.hi.y >= wanted_.lo.y &&
           rect.lo.y <= wanted_.hi.y;
  }

  bool hasColumn(double x) const { return x >= wanted_.lo.x && x <= wanted_.hi.x; }

  struct Spot {
    glm::dvec2 at{};        // column, row
    glm::dvec2 dx{}, dz{};  // what they change a metre east, a metre south
    bool isValid =
        false;  // false outside of the part that is wanted, and where the projection does not reach
  };

  // A row of points with one z. One thread; the chart must outlive it.
  class Row {
   public:
    Row(const Chart& chart, double z);
    Spot at(double x);

    // The polynomials between the two nodes around x, which lies at t = inPiece(x) of them; null where there
    // is no spot. Valid until the next call. Not where the chart is exact.
    const ChartPiece* pieceAt(double x);
    double inPiece(double x) const { return (x - chart_.origin_.x) / kNodeM - static_cast<double>(cell_); }

   private:
    void enter(std::int64_t cell);

    const Chart& chart_;
    double z_;
    bool isInside_ = false, isValid_ = false;
    std::int64_t nodeRow_ = 0, cell_ = -1;
    double inZ_ = 0;
    // Within 4 km a line is as good as the cubic for what places change a metre (6e-6 of it at 85 degrees).
    ChartPiece piece_{};
  };

 private:
  Spot exactly(double x, double z) const;
  glm::dvec2 exactAt(double x, double z) const;

  LocalPlane plane_;
  Georeference lattice_;
  WorldRect wanted_;
  bool isExact_ = false;
  double middle_ = 0;  // longitude that others are turned to
  glm::dvec2 origin_{};
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<glm::dvec2> nodes_;
};

}  // namespace skydrop::elevation
