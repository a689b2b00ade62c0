#include "skydrop/clouds/cloud_settings.h"

#include <algorithm>
#include <cmath>

namespace skydrop::clouds {
namespace {

// What a scale of 1 means, metres. The thesis's units are 10 m; these make its defaults cumulus of a real
// size: billows of 250 m to 1 km, detail of 25 to 200 m, weather that changes over kilometres.
constexpr double kShapePeriodAtOne = 2400, kDetailPeriodAtOne = 8000, kWeatherPeriodAtOne = 1000;

}  // namespace

void describe(core::SettingsVisitor& visitor, MarchSettings& s) {
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help) {
    visitor.number(name, value, {unit, min, max, help, core::TakesEffect::live, true});
  };
  visitor.choice("resolution", s.resolution, kMarchResolutionNames,
                 {"Rays a pixel: one for each, for each 2 x 2 or for each 4 x 4; edges are always sharp.",
                  core::TakesEffect::variant});
  number("tolerance", s.tolerance, "1", 0.005, 10,
         "Where neighbouring rays differ by more, every pixel gets its own; more leaves edges softer.");
  number("seekSteps", s.seekSteps, "1", 1, 16,
         "Steps at a time through clear air; more may miss thin wisps.");
  number("stepM", s.stepM, "m", 1, 200, "Length of a step near the eye; less finds smaller wisps.");
  number("stepGrowth", s.stepGrowth, "1", 0.0002, 0.1,
         "Length of a step far from the eye, as a share of the distance.");
  number("stepDepth", s.stepDepth, "1", 0.02, 5,
         "Most optical depth of a step; denser places take shorter ones.");
  number("leastTransmittance", s.leastTransmittance, "1", 1e-5, 0.1,
         "Where no more than this comes through, a ray ends.");
  visitor.integer("sunSamples", s.sunSamples,
                  {"1", 1, 128, "Samples of density on the way to the sun; more makes finer shadows.",
                   core::TakesEffect::variant});
  number("sunReachM", s.sunReachM, "m", 10, 2000,
         "How far those samples reach before the light grid takes over.");
  visitor.flag("lightGrid", s.lightGrid,
               {"Looks the way to the sun up in a grid; off, samples go all the way: exact and slow.",
                core::TakesEffect::variant});
  number("lightCellM", s.lightCellM, "m", 20, 400,
         "Cell of the light grid near the eye; five times that far away.");
  visitor.flag("detail", s.detail, {"Wears the edges with detail; off, evenly.", core::TakesEffect::variant});
}

void describe(core::SettingsVisitor& visitor, CloudSettings& s) {
  const auto number = [&](std::string_view name, double& value, std::string_view unit, double min, double max,
                          std::string_view help, bool logarithmic = false) {
    visitor.number(name, value, {unit, min, max, help, core::TakesEffect::live, logarithmic});
  };
  number("densityThreshold", s.densityThreshold, "1", 0, 0.95,
         "Least density of the noise that is drawn; more leaves smaller, sparser clouds.");
  number("scale", s.scale, "1", 0.1, 4, "Of the billows; less makes bigger, fluffier clouds.", true);
  number("anisotropy", s.anisotropy, "1", -0.9, 0.95,
         "Henyey-Greenstein's mean cosine; more sends light onward and lights edges against the sun.");
  number("extinction", s.extinction, "1/m", 0, 1,
         "Of the densest cloud (the thesis's SIGMA); more makes it opaque.");
  number("higherScale", s.higherScale, "1", 2, 80, "Of the detail on the edges; more makes it finer.", true);
  number("weatherScale", s.weatherScale, "1/km", 0.005, 0.1,
         "Of the weather map; more brings different weather nearer together.", true);
  number("cloudHeight", s.cloudHeight, "m", 100, 8000, "Height of the base above the sea.");
  number("thickness", s.thickness, "m", 50, 6000, "From base to top.");
  number("coverage", s.coverage, "1", 0, 1,
         "Share of the sky; 0 leaves it clear, more joins clouds to a deck.");
  number("typeShift", s.typeShift, "1", -1, 1,
         "From the weather map's types towards stratus (-1) or cumulus (1).");
  number("erosion", s.erosion, "1", 0, 0.9, "How much of the edges detail takes away.");
  number("forwardShare", s.forwardShare, "1", 0, 1,
         "Share of the light that goes nearly straight on; more makes silver edges against the sun.");
  number("fadeDistance", s.fadeDistance, "m", 1000, 60000, "Where clouds have faded out.");
  number("windSpeed", s.windSpeed, "m/s", 0, 60, "How fast the clouds drift.");
  number("windDirection", s.windDirection, "deg", 0, 360, "Compass direction from which the wind blows.");
  visitor.choice("tier", s.tier, kCloudTierNames,
                 {"How exactly clouds are drawn: sets the rows of the march.", core::TakesEffect::variant});
  visitor.group("march", s.march, "How exactly clouds are drawn, row by row.");
}

double shapePeriod(const CloudSettings& settings) { return kShapePeriodAtOne / settings.scale; }
double detailPeriod(const CloudSettings& settings) { return kDetailPeriodAtOne / settings.higherScale; }
double weatherPeriod(const CloudSettings& settings) {
  const double least = std::max(kWeatherPeriodAtOne / settings.weatherScale, 2 * settings.fadeDistance);
  const double shape = shapePeriod(settings);
  return std::ceil(least / shape) * shape;
}

}  // namespace skydrop::clouds
