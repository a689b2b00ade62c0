// Clouds in a cube: sampled, made opaque, lit.
#include <cstdio>

#include "lab/chapters.h"
#include "skydrop/lab/cloud_measure.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f64 = core::shared::f64;

template <class... Values>
std::string sentence(const char* format, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

Figures measureSamples(const CloudKnobs& knobs) {
  Figures figures;
  figures.columns = {"samples", "mean error of transmittance", "largest error"};
  for (const int steps : {5, 8, 16, 32, 64, 128}) {
    const SampleError error = sampleError(knobs, steps);
    figures.rows.push_back({static_cast<double>(steps), error.meanError, error.largestError});
  }
  const SampleError now = sampleError(knobs, static_cast<int>(knobs.steps));
  figures.summary = sentence("%d samples a ray leave a mean error of %.2g of the transmittance, %.2g at most",
                             static_cast<int>(knobs.steps), now.meanError, now.largestError);
  return figures;
}

Figures measureExponential(const CloudKnobs&) {
  Figures figures;
  figures.columns = {"x", "exp(-x)", "1 - exp(-x), float", "relative error in float"};
  for (const double x : {1e-6, 1e-3, 0.1, 1.0, 6.0, 50.0}) {
    const double exact = -std::expm1(-x), inFloat = core::shared::f32::stepOpacity(static_cast<float>(x));
    figures.rows.push_back({x, std::exp(-x), inFloat, std::abs(inFloat - exact) / exact});
  }
  figures.summary = "one exponential a ray, exact to 5e-6 at any depth, where the plain sum is cut off at 1";
  return figures;
}

Figures measureForward(const CloudKnobs& knobs) {
  Figures figures;
  figures.columns = {"way", "sun where the cloud is dense", "samples a ray"};
  figures.labels = {"by distance on the screen", "times the transmittance", "light march"};
  const ForwardError error = forwardError(knobs);
  const auto steps = static_cast<double>(knobs.steps), light = static_cast<double>(knobs.lightSamples);
  figures.rows = {{error.plain, steps}, {error.mended, steps}, {0, steps * (1 + light)}};
  figures.summary = sentence(
      "where a cloud lets less than a hundredth through, the plain way shows %.2g of the sun, the "
      "mended one %.2g",
      error.plain, error.mended);
  return figures;
}

Figures measureLight(const CloudKnobs& knobs) {
  Figures figures;
  figures.columns = {"steps",
                     "light samples",
                     "cost of 1 layer",
                     "cost of 3 layers",
                     "mean error of the sun's light",
                     "ms a thousand rays"};
  constexpr int kShown[][2] = {{50, 1}, {24, 2}, {24, 4}, {24, 8}, {24, 16}, {100, 25}};
  for (const auto& [steps, light] : kShown) {
    const LightError error = lightError(knobs, steps, light);
    const double cost = static_cast<double>(steps) * light;
    figures.rows.push_back({static_cast<double>(steps), static_cast<double>(light), cost, 3 * cost,
                            error.meanError, error.msPerThousandRays});
  }
  const LightError now =
      lightError(knobs, static_cast<int>(knobs.steps), static_cast<int>(knobs.lightSamples));
  figures.summary = sentence("%d x %d samples leave a mean error of %.2g of %.2g of the sun's light",
                             static_cast<int>(knobs.steps), static_cast<int>(knobs.lightSamples),
                             now.meanError, now.meanLight);
  return figures;
}

std::vector<Curve> plotLight(const CloudKnobs& knobs) {
  // Over 1 to 24 light samples, four decades down from 1.
  constexpr int kSteps = 8;
  const std::vector<double> errors = lightErrors(knobs, kSteps, static_cast<int>(kPlotPlaces));
  std::vector<Curve> curves(1);
  for (std::size_t i = 0; i < kPlotPlaces; ++i) curves[0][i] = logPlace(errors[i], 1e-4, 1);
  return curves;
}

Page page(std::string_view name, std::string_view title, std::string_view variant, std::string_view text) {
  Page made{.name = name,
            .title = title,
            .chapter = "cloud",
            .variant = variant,
            .text = text,
            .everySecondPixel = true};
  return made;
}

Page wholePage(std::string_view name, std::string_view title, std::string_view variant,
               std::string_view text) {
  Page made = page(name, title, variant, text);
  made.everySecondPixel = false;
  return made;
}

Page withCloud(Page made, const CloudKnobs& defaults, Figures (*measure)(const CloudKnobs&),
               std::vector<Curve> (*plot)(const CloudKnobs&) = nullptr) {
  made = withKnobs<CloudKnobs>(std::move(made), defaults, measure, plot);
  made.volume = [](const Knobs& knobs) {
    return cloudVolume(static_cast<const KnobsOf<CloudKnobs>&>(knobs).settings);
  };
  return made;
}

}  // namespace

std::vector<Page> cloudPages() {
  Page samples = wholePage(
      "density-samples", "Sampling density in a cube", "PAGE_SAMPLES",
      "Left a level cut through the cube's cloud with the samples of one ray: blue in clear air, orange "
      "and larger in cloud. Right the plain sum of the samples as darkness.");
  Page exponential =
      wholePage("exponential", "From a sum to opacity", "PAGE_EXPONENTIAL",
                "exp(-x), what is left of the light behind, and 1 - exp(-x), the opacity, for x from 0 to 6. "
                "Right the cloud with the plain sum as opacity, cut off at 1, and below by the exponential.");
  return {
      withCloud(std::move(samples), {.steps = 5}, measureSamples),
      withCloud(std::move(exponential), {.extinction = 20}, measureExponential),
      withCloud(
          wholePage("density", "Perlin alone, and times Voronoi", "PAGE_DENSITY",
                    "Perlin noise above its threshold left; right times Voronoi noise above its own, "
                    "doubled: from fog "
                    "to separate heaps. Thresholds clear the air, multipliers make what is left denser."),
          {.extinction = 12, .voronoiThreshold = 0.62}, measureSamples),
      withCloud(page("sunlight", "Sunlight through clouds", "PAGE_FORWARD",
                     "The sun behind the cloud. From the left: its light added by distance on the screen, "
                     "too bright "
                     "where the cloud is dense; the same times the cloud's transmittance; a march towards "
                     "the light from "
                     "each step; the same with more and finer steps."),
                {.view = {.azimuthDegrees = 30, .elevationDegrees = 20, .distance = 2.0},
                 .steps = 20,
                 .extinction = 30},
                measureForward),
      withCloud(page("light-march", "Directional light", "PAGE_LIGHT",
                     "From each step a second march to the sun. Top right how far the sun's light is from "
                     "that with 16 "
                     "samples, times eight; below the error over 1 to 24 light samples, four decades high. "
                     "The cost of a "
                     "pixel is layers times steps times light samples: 50 for one layer without a light "
                     "march, 7500 for "
                     "three layers of 100 steps with 25 samples each."),
                {.steps = 20}, measureLight, plotLight),
      withCloud(page("moods", "Six skies", "PAGE_MOODS",
                     "Day, puffy and night above, sunset, clear and stormy below: the same cloud, with "
                     "another threshold "
                     "and extinction, sun and sky."),
                {.view = {.azimuthDegrees = 200, .elevationDegrees = 20, .distance = 2.4},
                 .steps = 12,
                 .lightSamples = 3,
                 .extinction = 12},
                measureLight)};
}

}  // namespace skydrop::lab
