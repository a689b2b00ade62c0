#include "skydrop/elevation/projection.h"

#include <geodesic.h>
#include <proj.h>

#include <cctype>
#include <cmath>
#include <numbers>

#include "skydrop/core/error.h"

namespace skydrop::elevation {
namespace {

using core::DataError;

constexpr double kDegrees = 180 / std::numbers::pi;

struct ContextCloser {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct ObjectCloser {
  void operator()(PJ* object) const { proj_destroy(object); }
};
using Context = std::unique_ptr<PJ_CONTEXT, ContextCloser>;
using Object = std::unique_ptr<PJ, ObjectCloser>;

Context makeContext() {
  Context context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  proj_context_set_enable_network(context.get(), 0);
  return context;
}

// Whether words of a file make PROJ open another: grids and initialisation files by path, and so a pipe or a
// device too, which it waits for.
bool namesAFile(std::string words) {
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const std::string_view parameter : {"init=", "grids=", "file=", "tables=", "catalog="}) {
    if (words.find(parameter) != std::string::npos) return true;
  }
  return false;
}

// The horizontal part of what the words name.
Object systemOf(PJ_CONTEXT* context, const std::string& crs, std::string_view file) {
  const auto fail = [&](std::string_view reason) {
    throw DataError(file, "reference system", "'" + crs + "' " + std::string(reason));
  };
  if (namesAFile(crs)) fail("names a file of PROJ, and none is read");
  // A bare PROJ string is a projection and no system.
  const bool isPlain = crs.starts_with("+proj") && crs.find("+type=crs") == std::string::npos;
  Object object(proj_create(context, (isPlain ? crs + " +type=crs" : crs).c_str()));
  if (!object) fail("is not known to PROJ");
  if (proj_get_type(object.get()) == PJ_TYPE_BOUND_CRS)
    object.reset(proj_get_source_crs(context, object.get()));
  if (object && proj_get_type(object.get()) == PJ_TYPE_COMPOUND_CRS)
    object.reset(proj_crs_get_sub_crs(context, object.get(), 0));
  if (!object) fail("has no horizontal part");
  const PJ_TYPE type = proj_get_type(object.get());
  if (type != PJ_TYPE_PROJECTED_CRS && type != PJ_TYPE_GEOGRAPHIC_2D_CRS && type != PJ_TYPE_GEOGRAPHIC_3D_CRS)
    fail("is no system of degrees or of a map");
  return object;
}

bool hasDegrees(const PJ* object) {
  const PJ_TYPE type = proj_get_type(object);
  return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
}

const geod_geodesic& earth() {
  static const geod_geodesic wgs84 = [] {
    geod_geodesic g;
    geod_init(&g, 6378137, 1 / 298.257223563);
    return g;
  }();
  return wgs84;
}

}  // namespace

struct Projection::Parts {
  Context context;
  Object operation;
  bool isGeographic = false;
  std::string title;
};

Projection::Projection(const std::string& crs, std::string_view file) : parts_(std::make_unique<Parts>()) {
  parts_->context = makeContext();
  PJ_CONTEXT* context = parts_->context.get();
  const Object target = systemOf(context, crs, file);
  const Object source(proj_create(context, "EPSG:4326"));
  if (!source)
    throw DataError(file, "reference system", "PROJ's data (proj.db) are not there: install proj-data");
  const Object plain(proj_create_crs_to_crs_from_pj(context, source.get(), target.get(), nullptr, nullptr));
  if (plain) parts_->operation.reset(proj_normalize_for_visualization(context, plain.get()));
  if (!parts_->operation)
    throw DataError(file, "reference system", "PROJ knows no way from WGS 84 to '" + crs + "'");
  parts_->isGeographic = hasDegrees(target.get());
  const char* title = proj_get_name(target.get());
  parts_->title = title != nullptr ? title : crs;
}

Projection::~Projection() = default;
Projection::Projection(Projection&&) noexcept = default;
Projection& Projection::operator=(Projection&&) noexcept = default;

std::optional<glm::dvec2> Projection::forward(const GeoPlace& place) const {
  const PJ_COORD out = proj_trans(parts_->operation.get(), PJ_FWD,
                                  proj_coord(turnedNear(place.longitude, 0), place.latitude, 0, HUGE_VAL));
  if (!std::isfinite(out.xy.x) || !std::isfinite(out.xy.y)) return std::nullopt;
  return glm::dvec2(out.xy.x, out.xy.y);
}

std::optional<GeoPlace> Projection::inverse(glm::dvec2 xy) const {
  if (parts_->isGeographic) xy.x = turnedNear(xy.x, 0);
  const PJ_COORD out = proj_trans(parts_->operation.get(), PJ_INV, proj_coord(xy.x, xy.y, 0, HUGE_VAL));
  if (!std::isfinite(out.xy.x) || !std::isfinite(out.xy.y) || std::abs(out.xy.y) > 90) return std::nullopt;
  return GeoPlace{out.xy.y, turnedNear(out.xy.x, 0)};
}

bool Projection::isGeographic() const { return parts_->isGeographic; }
const std::string& Projection::title() const { return parts_->title; }

bool isGeographic(const std::string& crs, std::string_view file) {
  if (crs == "EPSG:4326") return true;
  const Context context = makeContext();
  return hasDegrees(systemOf(context.get(), crs, file).get());
}

GeoPlace LocalPlane::placeOf(glm::dvec2 xz) const {
  const double distance = std::hypot(xz.x, xz.y);
  GeoPlace place = origin_;
  if (!(distance > 0)) return place;
  geod_direct(&earth(), origin_.latitude, origin_.longitude, std::atan2(xz.x, -xz.y) * kDegrees, distance,
              &place.latitude, &place.longitude, nullptr);
  return place;
}

glm::dvec2 LocalPlane::positionOf(const GeoPlace& place) const {
  double distance = 0, azimuth = 0;
  geod_inverse(&earth(), origin_.latitude, origin_.longitude, place.latitude, place.longitude, &distance,
               &azimuth, nullptr);
  const double radians = azimuth / kDegrees;
  return {distance * std::sin(radians), -distance * std::cos(radians)};
}

GeoPlace centreOf(const Raster& raster) {
  const Projection projection(raster.georeference().crs, raster.name());
  const auto place = projection.inverse(
      centreOf(raster.georeference(), 0.5 * (raster.width() - 1), 0.5 * (raster.height() - 1)));
  if (!place)
    throw DataError(raster.name(), "georeference", "does not lie where its reference system reaches");
  return *place;
}

bool holds(const Raster& raster, const GeoPlace& place) {
  const Georeference& of = raster.georeference();
  const Projection projection(of.crs, raster.name());
  std::optional<glm::dvec2> xy = projection.forward(place);
  if (!xy) return false;
  if (projection.isGeographic()) xy->x = turnedNear(xy->x, centreOf(of, 0.5 * raster.width(), 0).x);
  const double column = (xy->x - of.first.x) / of.cell.x, row = (of.first.y - xy->y) / of.cell.y;
  return column >= -0.5 && row >= -0.5 && column <= raster.width() - 0.5 && row <= raster.height() - 0.5;
}

double turnedNear(double longitude, double near) { return near + std::remainder(longitude - near, 360); }

}  // namespace skydrop::elevation
