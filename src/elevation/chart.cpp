#include "elevation/chart.h"

#include <cmath>
#include <limits>

#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double grained(double value) { return std::nearbyint(value / Chart::kGrain) * Chart::kGrain; }

// The polynomial through four values at -1, 0, 1, 2 with the slopes of Catmull and Rom, between 0 and 1.
void toPolynomial(const glm::dvec2 (&p)[4], glm::dvec2 (&c)[4]) {
  c[0] = p[1];
  c[1] = 0.5 * (p[2] - p[0]);
  c[2] = p[0] - 2.5 * p[1] + 2.0 * p[2] - 0.5 * p[3];
  c[3] = 0.5 * (p[3] - p[0]) + 1.5 * (p[1] - p[2]);
}
glm::dvec2 valueOf(const glm::dvec2 (&c)[4], double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }
glm::dvec2 slopeOf(const glm::dvec2 (&c)[4], double t) { return c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]); }

}  // namespace

Chart::Chart(const LocalPlane& plane, const Georeference& lattice, double middle, const WorldRect& wanted,
             const std::string& file)
    : plane_(plane), lattice_(lattice), wanted_(wanted), middle_(middle) {
  const Projection projection(lattice.crs, file);
  const bool isGeographic = projection.isGeographic();
  origin_ = {(std::floor(wanted.lo.x / kNodeM) - 1) * kNodeM,
             (std::floor(wanted.lo.y / kNodeM) - 1) * kNodeM};
  columns_ = static_cast<std::int64_t>(std::ceil((wanted.hi.x - origin_.x) / kNodeM)) + 2;
  rows_ = static_cast<std::int64_t>(std::ceil((wanted.hi.y - origin_.y) / kNodeM)) + 2;
  nodes_.reserve(static_cast<std::size_t>(columns_ * rows_));
  for (std::int64_t row = 0; row < rows_; ++row) {
    for (std::int64_t column = 0; column < columns_; ++column) {
      const GeoPlace place = plane.placeOf(origin_ + kNodeM * glm::dvec2(column, row));
      if (isGeographic && std::abs(place.latitude) > kSmoothLatitude) {
        isExact_ = true;
        nodes_.clear();
        return;
      }
      std::optional<glm::dvec2> xy = projection.forward(place);
      if (!xy) {
        nodes_.emplace_back(kNone, kNone);
        continue;
      }
      if (isGeographic) xy->x = turnedNear(xy->x, middle_);
      const glm::dvec2 at = (*xy - lattice.first) / lattice.cell;
      nodes_.emplace_back(grained(at.x), grained(-at.y));
    }
  }
}

glm::dvec2 Chart::exactAt(double x, double z) const {
  const GeoPlace place = plane_.placeOf({x, z});
  return {(turnedNear(place.longitude, middle_) - lattice_.first.x) / lattice_.cell.x,
          (lattice_.first.y - place.latitude) / lattice_.cell.y};
}

Chart::Spot Chart::exactly(double x, double z) const {
  constexpr double kStepM = 0.5;
  Spot spot;
  spot.at = exactAt(x, z);
  spot.dx = (exactAt(x + kStepM, z) - exactAt(x - kStepM, z)) / (2 * kStepM);
  spot.dz = (exactAt(x, z + kStepM) - exactAt(x, z - kStepM)) / (2 * kStepM);
  // Across the meridian where longitudes begin again, or at a pole, there is no slope to be had.
  const double turn = 90 / lattice_.cell.x;
  if (std::abs(spot.dx.x) > turn) spot.dx.x = 0;
  if (std::abs(spot.dz.x) > turn) spot.dz.x = 0;
  spot.isValid = std::isfinite(spot.at.x) && std::isfinite(spot.at.y);
  return spot;
}

Chart::Row::Row(const Chart& chart, double z) : chart_(chart), z_(z) {
  isInside_ = z >= chart.wanted_.lo.y && z <= chart.wanted_.hi.y;  // false for NaN
  if (!isInside_ || chart.isExact_) return;
  const double at = (z - chart.origin_.y) / kNodeM;
  nodeRow_ = static_cast<std::int64_t>(std::floor(at));
  inZ_ = at - static_cast<double>(nodeRow_);
}

void Chart::Row::enter(std::int64_t cell) {
  cell_ = cell;
  glm::dvec2 across[4], down[4];
  for (int i = 0; i < 4; ++i) {
    glm::dvec2 nodes[4], polynomial[4];
    for (int k = 0; k < 4; ++k)
      nodes[k] = chart_.nodes_[static_cast<std::size_t>((nodeRow_ - 1 + k) * chart_.columns_ + cell - 1 + i)];
    toPolynomial(nodes, polynomial);
    across[i] = valueOf(polynomial, inZ_);
    down[i] = slopeOf(polynomial, inZ_) / kNodeM;
  }
  glm::dvec2 place[4];
  toPolynomial(across, place);
  const glm::dvec2 west = slopeOf(place, 0) / kNodeM, east = slopeOf(place, 1) / kNodeM;
  isValid_ = true;
  for (int axis = 0; axis < 2; ++axis) {
    for (int power = 0; power < 4; ++power) {
      piece_.place[power][axis] = place[power][axis];
      isValid_ = isValid_ && std::isfinite(place[power][axis]);
    }
    piece_.east[0][axis] = west[axis];
    piece_.east[1][axis] = east[axis] - west[axis];
    piece_.south[0][axis] = down[1][axis];
    piece_.south[1][axis] = down[2][axis] - down[1][axis];
  }
}

const ChartPiece* Chart::Row::pieceAt(double x) {
  if (!isInside_ || !(x >= chart_.wanted_.lo.x && x <= chart_.wanted_.hi.x)) return nullptr;
  const auto cell = static_cast<std::int64_t>((x - chart_.origin_.x) / kNodeM);  // not negative
  if (cell != cell_) enter(cell);
  return isValid_ ? &piece_ : nullptr;
}

Chart::Spot Chart::Row::at(double x) {
  if (chart_.isExact_) {
    const bool isWanted = isInside_ && x >= chart_.wanted_.lo.x && x <= chart_.wanted_.hi.x;
    return isWanted ? chart_.exactly(x, z_) : Spot{};
  }
  const ChartPiece* piece = pieceAt(x);
  if (piece == nullptr) return {};
  const double t = inPiece(x);
  Spot spot;
  spot.isValid = true;
  for (int axis = 0; axis < 2; ++axis) {
    const auto& c = piece->place;
    spot.at[axis] = c[0][axis] + t * (c[1][axis] + t * (c[2][axis] + t * c[3][axis]));
    spot.dx[axis] = piece->east[0][axis] + t * piece->east[1][axis];
    spot.dz[axis] = piece->south[0][axis] + t * piece->south[1][axis];
  }
  return spot;
}

}  // namespace skydrop::elevation
