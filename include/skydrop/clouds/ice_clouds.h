// High clouds of ice: settings of the one made by hand, and the medium of any layer, asked at a point.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "skydrop/clouds/sheet_resolution.h"
#include "skydrop/core/settings.h"

namespace skydrop::clouds {

// The genera of ice of the International Cloud Atlas (WMO 2017).
enum class IceGenus { cirrus, cirrostratus, cirrocumulus };
inline constexpr std::array<std::string_view, 3> kIceGenusNames = {"cirrus", "cirrostratus", "cirrocumulus"};

// A value; any thread. All but resolution and samples are of the layer that is there without weather.
struct IceCloudSettings {
  IceGenus genus = IceGenus::cirrus;
  double base = 8500;           // m above the sea, 3000 .. 14000
  double thickness = 1200;      // m, 50 .. 4000
  double cover = 0.5;           // share of the sky, 0 .. 1; 0: no layer
  double opticalDepth = 0.15;   // straight through, mean of what is cloud, 0 .. 4
  double shear = 9;             // m/s, 0 .. 40: by which the wind at the top exceeds that at the base
  double shearDirection = 260;  // degrees by compass where that difference comes from, 0 .. 360
  double turn = 35;             // degrees, -90 .. 90: by which it turns on the way down
  std::int64_t samples = 4;     // along a ray through a layer, 1 .. 64
  SheetResolution resolution = SheetResolution::full;

  bool operator==(const IceCloudSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, IceCloudSettings& settings);

// One layer. Plain value.
struct IceLayer {
  IceGenus genus = IceGenus::cirrus;
  double baseM = 8500, topM = 9700;  // above the sea
  double cover = 0;                  // [0, 1]; 0: there is none
  double opticalDepth = 0;           // straight through, mean of what is cloud
  glm::dvec2 along{1, 0};            // unit, east and south: towards where the shear carries heads ahead
  double trailM = 5000;              // by how much a streak has lagged behind at the base, >= 0
  double hookM = 0;                  // and across, to the right of `along`

  bool operator==(const IceLayer&) const = default;
};

// The layer made by hand.
IceLayer iceLayerOf(const IceCloudSettings& settings);

// Base and top (m above the sea), after the genus: grains of cirrocumulus lie in the middle 120 m of what is
// thicker.
void setLevels(IceLayer& layer, double baseM, double topM);

// Takes axis and streaks from the velocity of the air at the top less that at the base (m/s, east and south),
// and `across`, by how much (m/s) the lower half of the layer moves to the right of it. The same bits on
// every machine.
void setStreaks(IceLayer& layer, const glm::dvec2& shear, double across, const glm::dvec2& fallback);

// The widest lattice's cell (wrapped at 2^32) and the place in it: what a shader is handed of the eye's.
struct IceAnchor {
  glm::u32vec2 cell{0};
  glm::dvec2 inside{0};
};

// The medium of a layer that has drifted. The same formula as the picture's, in double
// (shaders/shared/ice_clouds.glsl). A value; const functions on any thread; the same bits on every machine.
class IceField {
 public:
  IceField(const IceLayer& layer, const glm::dvec2& drift);

  const IceLayer& layer() const { return layer_; }
  IceAnchor anchor(const glm::dvec2& xz) const;
  // Noise above which there is cloud.
  double threshold() const { return threshold_; }
  // Density at a place, m in the world: [0, 2.3]; 0 outside.
  double density(const glm::dvec3& place) const;
  // Of light, 1/m: of a density of 1.
  double extinction() const;
  // Straight up through the layer below which a place lies, or through what of it is above the place, by so
  // many samples, smoothed over an extent (m).
  double depthAbove(const glm::dvec3& place, int samples, double extentM = 0) const;

  // Along a ray (unit direction) from an eye, by so many samples, of pixels as wide as an angle (rad): what
  // the picture has there.
  double depthAlong(const glm::dvec3& eye, const glm::dvec3& direction, int samples, double pixelRad) const;

 private:
  double densityIn(const glm::dvec2& xz, double depth, const glm::dvec2& extent) const;

  IceLayer layer_;
  glm::dvec2 drift_;
  double threshold_;
};

}  // namespace skydrop::clouds
