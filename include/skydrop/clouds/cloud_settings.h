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
// describe() enforces the ranges of these and of all below.
struct MarchSettings {
  MarchResolution resolution = MarchResolution::half;
  // 0.005 .. 10: most by which the rays around a pixel may differ, before it gets one of its own.
  double tolerance = 0.3;
  double stepM = 16;          // m, 1 .. 200: length of a step near the eye
  double stepGrowth = 0.004;  // 2e-4 .. 0.1: a step is about this share of its distance, at least half of it
  double emptyStepMultiplier = 6;     // 1 .. 16: steps at a time, through clear air
  double maxSegmentOpticalDepth = 1;  // 0.02 .. 5: most optical depth that shares one evaluation of light
  double transmittanceCutoff = 0.01;  // 1e-5 .. 0.1: a ray ends where no more comes through
  std::int64_t sunSamples = 24;       // 1 .. 128, of density on the way to the sun
  double sunMarchDistanceM = 200;     // m, 10 .. 2000, of that way, with the light grid; without: all of it
  bool lightGrid = false;             // the rest of the way is looked up
  double lightCellM = 80;             // m, 20 .. 400, of the grid near the eye
  bool detail = true;                 // detail erodes the edges; off: its mean does
};

// Layers, each with a field of its own; all are made of the same noise. Raising it gives every layer
// settings, a field and an occupancy; the march (render::CloudSystem, shaders/clouds) goes through layer 0
// alone.
inline constexpr std::size_t kCloudLayers = 1;

// One layer. The three scales are factors of frequency: more is smaller.
struct CloudLayerSettings {
  double densityThreshold = 0.534;  // 0 .. 0.95: least density of the noise that is drawn
  double scale = 0.595;             // 0.1 .. 4, of the billows
  double anisotropy = 0.119;   // -0.9 .. 0.95: mean cosine of the phase function (Henyey and Greenstein 1941)
  double extinction = 0.08;    // 1/m, 0 .. 1, of the densest cloud
  double higherScale = 20;     // 2 .. 80, of the detail on the edges
  double weatherScale = 0.02;  // 1/km, 0.005 .. 0.1, of the weather map
  double cloudHeight = 1555;   // m above the sea, 100 .. 8000, of the base

  double thickness = 1800;     // m, 50 .. 6000, from base to top
  double coverage = 0.5;       // 0 .. 1: share of the sky, about
  double typeShift = 0;        // -1 .. 1: towards stratus or cumulus
  double erosion = 0.35;       // 0 .. 0.9: of the edges, by detail
  double forwardShare = 0.15;  // 0 .. 1: of the light, goes nearly straight on

  bool operator==(const CloudLayerSettings&) const = default;
};

struct CloudSettings {
  std::array<CloudLayerSettings, kCloudLayers> layers;
  double fadeDistance = 24000;  // m from the eye, 1e3 .. 60e3: no layer is seen beyond it
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
