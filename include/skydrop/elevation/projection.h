// Places on the earth, in degrees, in the coordinates of a map, and in metres around a point that one flies
// from.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "skydrop/elevation/raster.h"

namespace skydrop::elevation {

// On WGS 84.
struct GeoPlace {
  double latitude = 0;   // degrees north, [-90, 90]
  double longitude = 0;  // degrees east, any turn: [-180, 180] from all functions here
};

// Between WGS 84 and a coordinate reference system, by PROJ; its definitions are those of the machine,
// nothing is fetched. One thread at a time.
class Projection {
 public:
  // The system in words that PROJ understands. Throws core::DataError in the name of `file`.
  Projection(const std::string& crs, std::string_view file);
  ~Projection();
  Projection(Projection&&) noexcept;
  Projection& operator=(Projection&&) noexcept;

  // x is east (m) or longitude (degrees), y north or latitude. Nothing where the system does not reach.
  std::optional<glm::dvec2> forward(const GeoPlace& place) const;
  std::optional<GeoPlace> inverse(glm::dvec2 xy) const;

  bool isGeographic() const;         // degrees and not metres
  const std::string& title() const;  // "CH1903+ / LV95"

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

bool isGeographic(const std::string& crs, std::string_view file);

// The world's plane, which touches the earth at its origin: each place has its geodesic distance and azimuth
// from there (azimuthal equidistant on WGS 84; Karney, Algorithms for geodesics, 2013). Distances across that
// line are too long by a share of d^2 / 6 R^2: 0.015 % at 190 km. Any thread.
class LocalPlane {
 public:
  explicit LocalPlane(const GeoPlace& origin) : origin_(origin) {}

  const GeoPlace& origin() const { return origin_; }
  GeoPlace placeOf(glm::dvec2 xz) const;  // x east, z south, m; within half the earth's way round
  glm::dvec2 positionOf(const GeoPlace&) const;

 private:
  GeoPlace origin_;
};

// The middle of a raster. Throws core::DataError where its system does not reach there.
GeoPlace centreOf(const Raster& raster);

// Whether a place lies on a raster's cells.
bool holds(const Raster& raster, const GeoPlace& place);

// Longitude, turned to within half a turn of another one.
double turnedNear(double longitude, double near);

}  // namespace skydrop::elevation
