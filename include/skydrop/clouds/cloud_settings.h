// The settings of the clouds: of each layer the thesis's seven weather parameters in SI units, and what an
// artist needs besides; and how exactly layers are drawn. The wind that carries them is core::WindSettings.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "skydrop/core/settings.h"

namespace skydrop::clouds {

// From no clouds at all to what the others are judged by. What a tier sets is in
// assets/clouds/<name>.json: rows of MarchSettings.
enum class CloudTier { off, low, medium, high, ultra, reference };
inline constexpr std::array<std::string_view, 6> kCloudTierNames = {"off",  "low",   "medium",
                                                                    "high", "ultra", "reference"};

enum class MarchResolution { full, half, quarter };
inline constexpr std::array<std::string_view, 3> kMarchResolutionNames = {"full", "half", "quarter"};

// How layers are marched through: all that trades accuracy for time. Defaults are those of the tier high.
struct MarchSettings {
  MarchResolution resolution = MarchResolution::half;
  double tolerance = 0.3;     // most by which rays around a pixel may differ, before it gets one of its own
  double stepM = 16;          // length of a step near the eye
  double stepGrowth = 0.004;  // a step is about this share of its distance, at least half of it
  double emptyStepMultiplier = 6;     // at a time, through clear air
  double maxSegmentOpticalDepth = 1;  // most optical depth that shares one evaluation of light
  double transmittanceCutoff = 0.01;
  std::int64_t sunSamples = 24;    // of density on the way to the sun
  double sunMarchDistanceM = 200;  // length of that way, with the light grid; without: all of it
  bool lightGrid = false;          // the rest of the way is looked up
  double lightCellM = 80;          // of the grid near the eye
  bool detail = true;              // detail erodes the edges; off: its mean does
};

// Layers, each with a field of its own; all are made of the same noise. Raising it gives every layer
// settings, a field and an occupancy; the march (render::CloudSystem, shaders/clouds) goes through layer 0
// alone.
inline constexpr std::size_t kCloudLayers = 1;

// One layer. Units and ranges are described with the rows (describe() of CloudSettings).
struct CloudLayerSettings {
  double densityThreshold = 0.534;
  double scale = 0.595;
  double anisotropy = 0.119;
  double extinction = 0.08;
  double higherScale = 20;
  double weatherScale = 0.02;
  double cloudHeight = 1555;

  double thickness = 1800;
  double coverage = 0.5;
  double typeShift = 0;
  double erosion = 0.35;
  double forwardShare = 0.15;

  bool operator==(const CloudLayerSettings&) const = default;
};

struct CloudSettings {
  std::array<CloudLayerSettings, kCloudLayers> layers;
  double fadeDistance = 24000;  // m from the eye: no layer is seen beyond it
  CloudTier tier = CloudTier::high;
  MarchSettings march;
};

void describe(core::SettingsVisitor& visitor, MarchSettings& settings);
// Layers by number: "layers.0.scale". The names that rows had while there was one layer ("scale") still mean
// layer 0.
void describe(core::SettingsVisitor& visitor, CloudSettings& settings);

// Sides of the periods with which the noise textures repeat, metres. The weather map's is at least twice the
// distance at which clouds have faded out, and a whole number of the shape's: the field before erosion
// repeats with it.
double shapePeriod(const CloudLayerSettings& layer);
double detailPeriod(const CloudLayerSettings& layer);
double weatherPeriod(const CloudLayerSettings& layer, double fadeDistance);

// Whether a layer has the same extinction everywhere with both settings, so that what was made from its field
// (occupancy, sun optical depth) still holds. How light scatters does not change it; a setting that is added
// to the layer counts as changing it until it is excluded here.
bool isSameField(const CloudSettings& a, const CloudSettings& b, std::size_t layer);

}  // namespace skydrop::clouds
