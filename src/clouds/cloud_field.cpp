#include "skydrop/clouds/cloud_field.h"

#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "skydrop/clouds/anvil_reach.h"
#include "skydrop/core/error.h"
#include "skydrop/core/shared_clouds.h"

namespace skydrop::clouds {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;

void requireNoise(const core::TextureData& texture, std::string_view name, bool isVolume) {
  const bool isCube = texture.isVolume() == isVolume && texture.width == texture.height &&
                      (!isVolume || texture.depth == texture.width);
  if (isCube && texture.format == core::TexelFormat::rgba8 &&
      std::has_single_bit(static_cast<unsigned>(texture.width))) {
    return;
  }
  throw core::RangeError("the " + std::string(name) + " noise has to be " +
                         (isVolume ? "a cube" : "a square map") +
                         " of rgba8 texels whose side is a power of two");
}

glm::vec4 texelOf(const core::TextureData& texture, std::size_t index) {
  const auto channel = [&](std::size_t c) {
    return static_cast<float>(std::to_integer<int>(texture.texels[index * 4 + c])) / 255.0f;
  };
  return {channel(0), channel(1), channel(2), channel(3)};
}

// The medium's functions in one precision.
struct InFloat {
  using Real = float;
  using Vec2 = f32::Vec2;
  using Vec3 = f32::Vec3;
  using Vec4 = f32::Vec4;
  using Medium = f32::CloudMedium;
  using Form = f32::CloudForm;
  static Real formedMap(const Form& form, Real height, Real mapped, Real reached) {
    return f32::formedMap(form, height, mapped, reached);
  }
  static Real shapeDensity(const Medium& medium, const Form& form, Real height, Vec4 weather, Real base) {
    return f32::formedShapeDensity(medium, form, height, weather.x, weather.z, base);
  }
  static Real eroded(const Medium& medium, Real height, Real density, Real detail) {
    return f32::erodedDensity(medium, height, density, detail);
  }
};

struct InDouble {
  using Real = double;
  using Vec2 = f64::Vec2;
  using Vec3 = f64::Vec3;
  using Vec4 = f64::Vec4;
  using Medium = f64::CloudMedium;
  using Form = f64::CloudForm;
  static Real formedMap(const Form& form, Real height, Real mapped, Real reached) {
    return f64::formedMap(form, height, mapped, reached);
  }
  static Real shapeDensity(const Medium& medium, const Form& form, Real height, Vec4 weather, Real base) {
    return f64::formedShapeDensity(medium, form, height, weather.x, weather.z, base);
  }
  static Real eroded(const Medium& medium, Real height, Real density, Real detail) {
    return f64::erodedDensity(medium, height, density, detail);
  }
};

// The two texels around a place in periods along one axis, and the way from the first to the second.
template <class Real>
struct Between {
  std::size_t first, second;
  Real share;

  Between(Real place, int side) {
    const Real at = place * static_cast<Real>(side) - Real(0.5);
    const Real whole = std::floor(at);
    const auto wrap = static_cast<std::int64_t>(side) - 1;
    first = static_cast<std::size_t>(static_cast<std::int64_t>(whole) & wrap);
    second = (first + 1) & static_cast<std::size_t>(wrap);
    share = at - whole;
  }
};

template <class Real>
Real mixed(Real a, Real b, Real share) {
  return a + (b - a) * share;
}

template <class Real, class Vec3>
Real volumeAt(const std::vector<float>& volume, int side, const Vec3& place) {
  const Between<Real> x(place.x, side), y(place.y, side), z(place.z, side);
  const auto n = static_cast<std::size_t>(side);
  const auto row = [&](std::size_t layer, std::size_t line) {
    const float* texels = volume.data() + (layer * n + line) * n;
    return mixed<Real>(texels[x.first], texels[x.second], x.share);
  };
  const auto layer = [&](std::size_t k) { return mixed(row(k, y.first), row(k, y.second), y.share); };
  return mixed(layer(z.first), layer(z.second), z.share);
}

template <class Shared>
typename Shared::Vec4 mapAt(const std::vector<glm::vec3>& map, int side, const typename Shared::Vec2& place) {
  using Real = typename Shared::Real;
  using Vec3 = typename Shared::Vec3;
  const Between<Real> x(place.x, side), y(place.y, side);
  const auto texel = [&](std::size_t i, std::size_t j) {
    return Vec3(map[j * static_cast<std::size_t>(side) + i]);
  };
  const auto row = [&](std::size_t j) { return glm::mix(texel(x.first, j), texel(x.second, j), x.share); };
  return {glm::mix(row(y.first), row(y.second), y.share), Real(1)};
}

template <class Shared>
typename Shared::Medium mediumIn(const LayerMedium& of) {
  using Real = typename Shared::Real;
  return {static_cast<Real>(of.layer.densityThreshold), static_cast<Real>(of.layer.coverage),
          static_cast<Real>(of.layer.typeShift), static_cast<Real>(of.layer.erosion)};
}

template <class Shared>
typename Shared::Form formIn(const LayerMedium& of) {
  using Real = typename Shared::Real;
  return {typename Shared::Vec4(of.form.slopes()),   static_cast<Real>(of.form.own),
          static_cast<Real>(of.form.anvilBase),      static_cast<Real>(of.form.spread),
          static_cast<Real>(of.form.anvilThreshold), static_cast<Real>(of.form.taper),
          static_cast<Real>(of.form.contrast)};
}

// Of the map's quantities at a place what a form takes at a height fraction.
template <class Shared>
typename Shared::Vec4 formedMapAt(const PackedCloudNoise& noise, const LayerMedium& medium,
                                  typename Shared::Real height, const typename Shared::Vec2& place) {
  using Real = typename Shared::Real;
  typename Shared::Vec4 weather = mapAt<Shared>(noise.weather, noise.weatherSide, place);
  if (medium.form.anvilBase >= kNoAnvil || noise.anvils.empty()) return weather;
  const Between<Real> x(place.x, noise.weatherSide), y(place.y, noise.weatherSide);
  const auto texel = [&](std::size_t i, std::size_t j) {
    return static_cast<Real>(noise.anvils[j * static_cast<std::size_t>(noise.weatherSide) + i]);
  };
  const auto row = [&](std::size_t j) { return glm::mix(texel(x.first, j), texel(x.second, j), x.share); };
  weather.x = Shared::formedMap(formIn<Shared>(medium), height, weather.x,
                                glm::mix(row(y.first), row(y.second), y.share));
  return weather;
}

// A place in periods, [0, 1): wrapped in double before anything is rounded.
double inPeriods(double metres, double period) {
  const double periods = metres / period;
  return periods - std::floor(periods);
}

}  // namespace

PackedCloudNoise packCloudNoise(const core::TextureData& shape, const core::TextureData& detail,
                                const core::TextureData& weather) {
  requireNoise(shape, "shape", true);
  requireNoise(detail, "detail", true);
  requireNoise(weather, "weather", false);
  PackedCloudNoise packed;
  packed.shapeSide = shape.width;
  packed.detailSide = detail.width;
  packed.weatherSide = weather.width;
  packed.base.resize(shape.texels.size() / 4);
  for (std::size_t i = 0; i < packed.base.size(); ++i) packed.base[i] = f32::cloudBase(texelOf(shape, i));
  packed.detail.resize(detail.texels.size() / 4);
  for (std::size_t i = 0; i < packed.detail.size(); ++i)
    packed.detail[i] = f32::cloudDetail(texelOf(detail, i));
  packed.weather.resize(weather.texels.size() / 4);
  for (std::size_t i = 0; i < packed.weather.size(); ++i) packed.weather[i] = glm::vec3(texelOf(weather, i));
  packed.anvils = anvilReach(packed.weather, packed.weatherSide);
  return packed;
}

CloudField::CloudField(std::shared_ptr<const PackedCloudNoise> noise, const CloudSettings& settings,
                       std::size_t layer)
    : CloudField(std::move(noise), mediumOf(settings, layer)) {}

CloudField::CloudField(std::shared_ptr<const PackedCloudNoise> noise, const LayerMedium& medium)
    : noise_(std::move(noise)), medium_(medium), periodM_(weatherPeriod(medium)) {}

template <class Shared>
typename Shared::Real CloudField::densityAs(const glm::dvec3& position) const {
  using Real = typename Shared::Real;
  using Vec2 = typename Shared::Vec2;
  using Vec3 = typename Shared::Vec3;
  const CloudLayerSettings& layer = medium_.layer;
  const double height = (position.y - layer.cloudHeight) / layer.thickness;
  if (!(height > 0 && height < 1)) return 0;
  const glm::dvec3 carried = position - glm::dvec3(drift_.x, 0, drift_.y);
  const auto placeIn = [](const glm::dvec3& at, double period) {
    return Vec3(inPeriods(at.x, period), inPeriods(at.y, period), inPeriods(at.z, period));
  };
  const auto medium = mediumIn<Shared>(medium_);
  const Vec3 inMap = placeIn(carried, periodM_);
  const Real shape = Shared::shapeDensity(
      medium, formIn<Shared>(medium_), static_cast<Real>(height),
      formedMapAt<Shared>(*noise_, medium_, static_cast<Real>(height), Vec2(inMap.x, inMap.z)),
      volumeAt<Real>(noise_->base, noise_->shapeSide,
                     placeIn(carried * medium_.form.stretch, shapePeriod(layer))));
  if (!(shape > 0)) return 0;  // most places: the detail is not even fetched
  return Shared::eroded(
      medium, static_cast<Real>(height), shape,
      volumeAt<Real>(noise_->detail, noise_->detailSide, placeIn(carried, detailPeriod(layer))));
}

float CloudField::shapeEstimateInFloat(const glm::dvec3& position) const {
  const glm::dvec3 carried = position - glm::dvec3(drift_.x, 0, drift_.y);
  const CloudLayerSettings& layer = medium_.layer;
  const auto placeIn = [](const glm::dvec3& at, double period) {
    return f32::Vec3(inPeriods(at.x, period), inPeriods(at.y, period), inPeriods(at.z, period));
  };
  const f32::Vec3 inMap = placeIn(carried, periodM_);
  const auto height = static_cast<float>((position.y - layer.cloudHeight) / layer.thickness);
  const f32::Vec4 weather = formedMapAt<InFloat>(*noise_, medium_, height, f32::Vec2(inMap.x, inMap.z));
  return f32::formedShapeEstimate(
      mediumIn<InFloat>(medium_), formIn<InFloat>(medium_), height, weather.x, weather.z,
      volumeAt<float>(noise_->base, noise_->shapeSide,
                      placeIn(carried * medium_.form.stretch, shapePeriod(layer))));
}

double CloudField::density(const glm::dvec3& position) const { return densityAs<InDouble>(position); }
float CloudField::densityInFloat(const glm::dvec3& position) const { return densityAs<InFloat>(position); }

}  // namespace skydrop::clouds
