#include "skydrop/clouds/cloud_settings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "skydrop/clouds/layer_medium.h"

namespace skydrop::clouds {
namespace {

// What a scale of 1 means, metres. The thesis's units are 10 m; these make its defaults cumulus of a real
// size: billows of 250 m to 1 km, detail of 25 to 200 m, weather that changes over kilometres.
constexpr double kShapePeriodAtOne = 2400, kDetailPeriodAtOne = 8000, kWeatherPeriodAtOne = 1000;

// Of the clouds that are nearer than this, no two are the same. Farther ones may be those of nearer ones, a
// weather period away: through more than 50 km of air, in another direction, and lower over the horizon.
constexpr double kUniqueWithinM = 24000;

double leastWeatherPeriod(double fadeDistance) { return 2 * std::min(fadeDistance, kUniqueWithinM); }

// The period in force, and why it is not the one that the scale asks for.
std::string weatherNote(const CloudLayerSettings& layer, double fadeDistance) {
  char text[128];
  const bool isBound = kWeatherPeriodAtOne / layer.weatherScale < leastWeatherPeriod(fadeDistance);
  const double km = weatherPeriod(layer, fadeDistance) / 1000;
  std::snprintf(text, sizeof text, "The map repeats after %.1f km%s.", km,
                isBound ? ": twice the fade distance or 48 km, whatever more is asked for" : "");
  return text;
}

// The rows of one layer; `all` has what their notes depend on besides.
void describeLayer(core::SettingsVisitor& visitor, CloudLayerSettings& s, const CloudSettings& all) {
  struct Row {
    std::string_view help;
    std::string_view aliases = {};
    bool logarithmic = false;
    std::optional<core::Range> slider = std::nullopt;
    core::FieldNote note = {};
    core::TakesEffect takesEffect = core::TakesEffect::liveRebuild;  // of the field (isSameField)
  };
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          const Row& row) {
    visitor.number(name, value,
                   {.unit = unit,
                    .min = min,
                    .max = max,
                    .help = row.help,
                    .takesEffect = row.takesEffect,
                    .logarithmic = row.logarithmic,
                    .slider = row.slider,
                    .aliases = row.aliases,
                    .note = row.note});
  };
  number("densityThreshold", s.densityThreshold, "1", 0, 0.95,
         {.help = "Least density of the noise that is drawn; more leaves smaller, sparser clouds.",
          .aliases = "density, cutoff",
          .slider = core::Range{0, 0.85}});
  number("scale", s.scale, "1", 0.1, 4,
         {.help = "Of the billows; less makes bigger, fluffier clouds, beyond the slider's end they line up "
                  "in a lattice.",
          .aliases = "size, frequency, base scale",
          .logarithmic = true,
          .slider = core::Range{0.2, 1.5}});
  number(
      "anisotropy", s.anisotropy, "1", -0.9, 0.95,
      {.help = "Henyey-Greenstein's mean cosine; more sends light onward and lights edges against the sun.",
       .aliases = "HG, g, Henyey-Greenstein, phase function, scattering",
       .takesEffect = core::TakesEffect::live});
  number("extinction", s.extinction, "1/m", 0, 1,
         {.help = "Of the densest cloud; more makes it opaque.",
          .aliases = "SIGMA, absorption, opacity, density, Beer",
          .slider = core::Range{0, 0.2}});
  number("higherScale", s.higherScale, "1", 2, 80,
         {.help = "Of the detail on the edges; more makes it finer, beyond the slider's end it shows as "
                  "hatching.",
          .aliases = "detail scale, high frequency",
          .logarithmic = true,
          .slider = core::Range{2, 30},
          .note = core::noteWhile([&s, &all] { return !(s.erosion > 0) || !all.march.detail; },
                                  "Does nothing without erosion by detail.")});
  number("weatherScale", s.weatherScale, "1/km", 0.005, 0.1,
         {.help = "Of the weather map; more brings different weather nearer together. The map is never "
                  "smaller than twice the fade distance or 48 km, so that nobody sees it repeat.",
          .aliases = "weather map, coverage scale",
          .logarithmic = true,
          .slider = core::Range{0.005, 0.02},
          .note = [&s, &all] { return weatherNote(s, all.fadeDistance); }});
  number("cloudHeight", s.cloudHeight, "m", 100, 8000,
         {.help = "Height of the base above the sea.", .aliases = "altitude, cloud base, ceiling"});
  number("thickness", s.thickness, "m", 50, 6000,
         {.help = "From base to top; more makes clouds taller.",
          .aliases = "cloud top, depth, tall",
          .slider = core::Range{200, 4000}});
  number("coverage", s.coverage, "1", 0, 1,
         {.help = "How much of the sky clouds take; 0 leaves it clear, more joins them to a deck.",
          .aliases = "cloud cover, amount, overcast"});
  number("typeShift", s.typeShift, "1", -1, 1,
         {.help = "From the weather map's types towards stratus (-1) or cumulus (1).",
          .aliases = "cloud type, stratus, cumulus"});
  number("erosion", s.erosion, "1", 0, 0.9,
         {.help = "How much of the edges detail takes away; more leaves thinner, more ragged clouds.",
          .aliases = "detail, wisps",
          .slider = core::Range{0, 0.7}});
  number("forwardShare", s.forwardShare, "1", 0, 1,
         {.help = "Share of the light that goes nearly straight on; more makes silver edges against the sun.",
          .aliases = "silver lining, phase function, scattering",
          .takesEffect = core::TakesEffect::live});
}

}  // namespace

void describe(core::SettingsVisitor& visitor, MarchSettings& s) {
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help, std::string_view aliases = {}, core::FieldNote note = {},
                          std::optional<core::Range> slider = std::nullopt) {
    visitor.number(name, value,
                   {.unit = unit,
                    .min = min,
                    .max = max,
                    .help = help,
                    .logarithmic = min > 0,
                    .slider = slider,
                    .aliases = aliases,
                    .note = std::move(note)});
  };
  const auto unlessExact = [&s] {
    return core::noteWhile([&s] { return s.exact; }, "Does nothing while the exact march is on.");
  };
  const auto onlyExact = [&s] {
    return core::noteWhile([&s] { return !s.exact; }, "Does nothing while the exact march is off.");
  };
  const auto between = [&s](MarchResolution coarsest) {
    return core::noteWhile([&s, coarsest] { return s.exact || s.resolution < coarsest; },
                           "Does nothing while rays are as close together as that.");
  };
  visitor.choice(
      "resolution", s.resolution, kMarchResolutionNames,
      {.help = "Rays where the picture is smooth: one for each pixel, for each 2 x 2 or for each 4 x 4; "
               "the tolerances say where there are more.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "downsampling, upscaling",
       .note = unlessExact()});
  number("coarseTolerance", s.coarseTolerance, "1", 0.002, 10,
         "Where rays four pixels apart bend by more, rays two pixels apart are marched; more leaves edges "
         "softer.",
         "edge threshold, tolerance", between(MarchResolution::quarter), core::Range{0.05, 2});
  number("fineTolerance", s.fineTolerance, "1", 0.002, 10,
         "Where rays two pixels apart bend by more, every pixel gets a ray; more leaves edges softer.",
         "edge threshold, tolerance", between(MarchResolution::half), core::Range{0.05, 2});
  number("stepM", s.stepM, "m", 1, 200, "Length of a step near the eye; less finds smaller wisps.",
         "step size, LOD");
  number(
      "stepGrowth", s.stepGrowth, "1", 0.0002, 0.1,
      "Length of a step far from the eye, about, as a share of the distance; less finds smaller wisps there.",
      "step size, LOD", {}, core::Range{0.001, 0.1});
  number(
      "clearStride", s.clearStride, "1", 0, 2,
      "How far clear air is crossed at once, of the way in which the noise may hide no cloud; 0 goes step by "
      "step, more than 1 may miss thin cloud.",
      "stride, empty space", unlessExact());
  number("lightOpacity", s.lightOpacity, "1", 0.001, 0.2,
         "Least opacity, about, that is lit at one place; less resolves light and shade in dense cloud.",
         "light samples, merge", unlessExact());
  number("transmittanceCutoff", s.transmittanceCutoff, "1", 1e-5, 0.1,
         "A ray ends where no more than this comes through; less goes deeper into dense cloud.",
         "early exit, cutoff");
  number("sunStepM", s.sunStepM, "m", 1, 100,
         "First step from an opaque place towards the sun; less is more exact where cloud is lit.",
         "light samples, shadow samples", unlessExact());
  number("sunStepGrowth", s.sunStepGrowth, "1", 0, 1,
         "How much longer a step towards the sun gets with each metre of the way; less is more exact.",
         "light samples, shadow samples", unlessExact());
  number("sunStepPerDepthM", s.sunStepPerDepthM, "m", 0, 100,
         "How much longer a step towards the sun gets with each unit of optical depth; less is more exact in "
         "dense cloud.",
         "light samples, shadow samples", unlessExact());
  number("sunClearStride", s.sunClearStride, "1", 0, 2,
         "How far clear air is crossed at once on the way to the sun, as clearStride.", "stride, empty space",
         unlessExact(), core::Range{0.4, 2});
  visitor.flag("detail", s.detail,
               {.help = "Erodes the edges by detail noise; off, by as much everywhere.",
                .takesEffect = core::TakesEffect::variant,
                .aliases = "erosion"});
  number(
      "farStartM", s.farStartM, "m", 2000, 60000,
      "From here on clouds are drawn coarsely: no detail is looked up, steps are longer, edges softer; more "
      "costs time.",
      "far field, draw distance, LOD", unlessExact());
  number("farStep", s.farStep, "1", 1, 16, "How much longer steps are in the far field; less is more exact.",
         "step size, far field, LOD", unlessExact());
  number("farTolerance", s.farTolerance, "1", 0.5, 8,
         "How much more rays may bend in the far field, seen through the air, before there are rays between "
         "them; more leaves edges softer.",
         "edge threshold, tolerance, far field", between(MarchResolution::half));
  visitor.choice(
      "lightCells", s.lightCells, kLightCellsNames,
      {.help = "Cells of the light volume: 128 or 256 across a period of the weather. Coarse cells mix lit "
               "cloud with shade; fine ones take four times as long to solve and four times the memory.",
       .takesEffect = core::TakesEffect::liveRebuild,
       .aliases = "light volume, multiple scattering, resolution"});
  visitor.choice(
      "history", s.history, kMarchHistoryNames,
      {.help = "In flight, the share of the rays that is marched in each frame; the rest is what the last "
               "frame saw of the same cloud. Single pictures are always marched whole.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "temporal, reprojection, accumulation, upscaling, ghosting",
       .note = unlessExact()});
  visitor.flag(
      "exact", s.exact,
      {.help = "Marches as the tier reference does: each step and each sample towards the sun as long as "
               "its rows say, wherever there may be cloud. Slow.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "reference, ground truth"});
  number("maxSegmentOpticalDepth", s.maxSegmentOpticalDepth, "1", 0.02, 5,
         "Most optical depth, about, that shares one look at the light, over four steps at most; less "
         "resolves light and shade in dense cloud.",
         "light samples", onlyExact());
  visitor.integer("sunSamples", s.sunSamples,
                  {.unit = "1",
                   .min = 1,
                   .max = 128,
                   .help = "Samples of density on the way to the sun, closer together near the cloud that is "
                           "lit; more makes shade within clouds more exact.",
                   .aliases = "light samples, shadow samples",
                   .note = onlyExact()});
  visitor.renamed("tolerance", "fineTolerance");
  visitor.renamed("stepDepth", "maxSegmentOpticalDepth");
  visitor.renamed("leastTransmittance", "transmittanceCutoff");
  for (const std::string_view gone :
       {"seekSteps", "emptyStepMultiplier", "sunReachM", "sunMarchDistanceM", "lightGrid", "lightCellM"}) {
    visitor.removed(gone);
  }
}

void describe(core::SettingsVisitor& visitor, CloudSettings& s) {
  visitor.enterGroup("layers", "The cloud layers.");
  for (std::size_t i = 0; i < s.layers.size(); ++i) {
    visitor.enterGroup(std::to_string(i),
                       "A cloud layer. In a scene with weather, whose genus makes the layers, each row acts "
                       "on the low one: by its ratio to its default, threshold, type and scattering by the "
                       "difference.");
    describeLayer(visitor, s.layers[i], s);
    visitor.leaveGroup();
  }
  visitor.leaveGroup();
  visitor.number("fadeDistance", s.fadeDistance,
                 {.unit = "m",
                  .min = 1000,
                  .max = 60000,
                  .help = "Clouds have faded out at this distance; more costs time.",
                  .takesEffect = core::TakesEffect::liveRebuild,  // where it bounds the weather's period
                  .aliases = "draw distance, view distance, range"});
  visitor.choice("tier", s.tier, kCloudTierNames,
                 {.help = "How exactly clouds are drawn: sets the rows of the march.",
                  .takesEffect = core::TakesEffect::variant,
                  .aliases = "quality, LOD"});
  visitor.choice(
      "light", s.light, kCloudLightNames,
      {.help = "What light in clouds that is scattered more than once comes from: octaves of the sun's, or a "
               "volume of it that is solved for weather and sun, nearer to what traced paths of light find.",
       .takesEffect = core::TakesEffect::variant,
       .aliases = "multiple scattering, light volume, path tracing, Wrenninge"});
  visitor.group("march", s.march, "How exactly clouds are drawn, row by row.");
  for (const std::string_view name :
       {"densityThreshold", "scale", "anisotropy", "extinction", "higherScale", "weatherScale", "cloudHeight",
        "thickness", "coverage", "typeShift", "erosion", "forwardShare"}) {
    visitor.renamed(name, "layers.0." + std::string(name));
  }
}

double shapePeriod(const CloudLayerSettings& layer) { return kShapePeriodAtOne / layer.scale; }
double detailPeriod(const CloudLayerSettings& layer) { return kDetailPeriodAtOne / layer.higherScale; }
double weatherPeriod(const CloudLayerSettings& layer, double fadeDistance) {
  const double least = std::max(kWeatherPeriodAtOne / layer.weatherScale, leastWeatherPeriod(fadeDistance));
  const double shape = shapePeriod(layer);
  return std::ceil(least / shape) * shape;
}

LayerMedium mediumOf(const CloudSettings& settings, std::size_t layer) {
  return {settings.layers.at(layer), {}, settings.fadeDistance};
}

double weatherPeriod(const LayerMedium& medium) {
  const double least = std::min({medium.form.stretch.x, medium.form.stretch.z, 1.0});
  CloudLayerSettings drawnOut = medium.layer;
  drawnOut.scale *= least;
  return weatherPeriod(drawnOut, medium.fadeDistance);
}

bool isSameField(const CloudSettings& a, const CloudSettings& b, std::size_t layer) {
  CloudLayerSettings other = b.layers[layer];
  other.anisotropy = a.layers[layer].anisotropy;
  other.forwardShare = a.layers[layer].forwardShare;
  return a.layers[layer] == other &&
         weatherPeriod(a.layers[layer], a.fadeDistance) == weatherPeriod(other, b.fadeDistance);
}

}  // namespace skydrop::clouds
