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

// How much of last frame's clouds is used again: nothing, or all but so many of the rays a frame.
enum class MarchHistory { off, quarter, sixteenth };
inline constexpr std::array<std::string_view, 3> kMarchHistoryNames = {"off", "quarter", "sixteenth"};

// What light in clouds that is scattered more than once is made of: octaves of what the sun sends, or a
// volume of it that is solved for the weather and the sun (clouds::LightVolume).
enum class CloudLight { octaves, volume };
inline constexpr std::array<std::string_view, 2> kCloudLightNames = {"octaves", "volume"};

// Into how many cells the volume cuts a period of the weather, east and south: 128 or 256. Time and memory go
// with the square.
enum class LightCells { coarse, fine };
inline constexpr std::array<std::string_view, 2> kLightCellsNames = {"coarse", "fine"};

// How layers are marched through: all that trades accuracy for time. Defaults are those of the tier high.
// describe() enforces the ranges of these and of all below. docs/clouds.md tells what each is for.
struct MarchSettings {
  // Where the picture is smooth: a ray for each pixel, each 2 x 2 or each 4 x 4; the rest is interpolated.
  MarchResolution resolution = MarchResolution::quarter;
  // 0.002 .. 10: curvature between rays 4 and 2 pixels apart (second differences of radiance or
  // transmittance) above which the pixels between them get rays of their own.
  double coarseTolerance = 0.28, fineTolerance = 0.8;
  double stepM = 16;           // m, 1 .. 200: length of a step near the eye
  double stepGrowth = 0.0025;  // 2e-4 .. 0.1: a step is about this share of its distance, at least half of it
  double clearStride = 1;      // 0 .. 2: through clear air, of the way that is safe by the noise's slope
  double lightOpacity =
      0.01;  // 0.001 .. 0.2: least opacity of a segment whose light is worked out at one place
  double transmittanceCutoff = 0.018;  // 1e-5 .. 0.1: a ray ends where no more comes through
  // Towards the sun: m, 1 .. 100, the first step, for a segment of opacity 1 (over its root for others); 0 ..
  // 1, how much longer they get a metre; m, 0 .. 100, and with each unit of optical depth.
  double sunStepM = 8, sunStepGrowth = 0.07, sunStepPerDepthM = 5;
  double sunClearStride = 1;  // 0 .. 2: as clearStride
  bool detail = true;         // detail erodes the edges; off: its mean does
  // The far field: m from the eye, 2e3 .. 60e3, where it begins. Beyond, no detail is looked up, steps are
  // `farStep` times as long (1 .. 16), and rays may bend by so many times the tolerances (0.5 .. 8), over
  // what the air leaves of their light, before there are more of them. The exact march has none.
  double farStartM = 20000, farStep = 3, farTolerance = 1.5;
  LightCells lightCells = LightCells::fine;  // of the light volume, where `light` is one
  // Only of frames that follow others (render::FrameInput::followsLast): what share of the rays is marched,
  // in turns; the rest is what the last frame saw of the same cloud.
  MarchHistory history = MarchHistory::off;
  // The march of the reference: steps of one length through all that may hold cloud, each segment lit by as
  // many samples as there are. The two rows after it are of that march alone, those before it but the steps'
  // and the cutoff's are not.
  bool exact = false;
  double maxSegmentOpticalDepth = 1;  // 0.02 .. 5: most optical depth that shares one evaluation of light
  std::int64_t sunSamples = 24;       // 1 .. 128, of density on the way to the sun

  bool operator==(const MarchSettings&) const = default;
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
  double fadeDistance = 60000;  // m from the eye, 1e3 .. 60e3: no layer is seen beyond it
  CloudTier tier = CloudTier::high;
  CloudLight light = CloudLight::volume;
  MarchSettings march;

  bool operator==(const CloudSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, MarchSettings& settings);
// Layers by number: "layers.0.scale". The names that rows had while there was one layer ("scale") still mean
// layer 0.
void describe(core::SettingsVisitor& visitor, CloudSettings& settings);

// Sides of the periods with which the noise textures repeat, metres. The weather map's is at least twice the
// distance at which clouds have faded out or 48 km, whichever is less, and a whole number of the shape's: the
// field before erosion repeats with it.
double shapePeriod(const CloudLayerSettings& layer);
double detailPeriod(const CloudLayerSettings& layer);
double weatherPeriod(const CloudLayerSettings& layer, double fadeDistance);

// Whether a layer has the same extinction everywhere with both settings, so that what was made from its field
// (occupancy, sun optical depth) still holds. How light scatters does not change it; a setting that is added
// to the layer counts as changing it until it is excluded here.
bool isSameField(const CloudSettings& a, const CloudSettings& b, std::size_t layer);

}  // namespace skydrop::clouds
