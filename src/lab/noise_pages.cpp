// Random numbers and noise: sines against hashes, Perlin, Voronoi, octaves.
#include <cstdio>

#include "lab/chapters.h"
#include "skydrop/lab/noise_measure.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;

template <class... Values>
std::string sentence(const char* format, Values... values) {
  char text[240];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::uint32_t bits(std::int64_t value) { return static_cast<std::uint32_t>(value); }

glm::vec2 placeOf(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

Figures measureRandom(const RandomKnobs& knobs) {
  Figures figures;
  figures.columns = {"from", "sine: other in float", "sine: distinct", "hash: other in float",
                     "hash: distinct"};
  for (const double from : {0.0, 1e3, 1e5, 1e6, 1e7}) {
    const RandomError error = randomError(from);
    figures.rows.push_back({from, error.sineApart, error.sineDistinct, error.hashApart, error.hashDistinct});
  }
  const RandomError away = randomError(knobs.away);
  figures.summary = sentence(
      "%.3g cells away %.3g %% of the sine's numbers are others in float than in double, %.3g %% are "
      "distinct; "
      "of the hash's none differs and %.3g %% are distinct",
      knobs.away, 100 * away.sineApart, 100 * away.sineDistinct, 100 * away.hashDistinct);
  return figures;
}

NoisePlane perlin(const PerlinKnobs& knobs, bool faded) {
  const std::uint32_t cells = bits(knobs.cells), salt = core::shared::f64::octaveSalt(bits(knobs.seed), 0, 2);
  return [=](double x, double y) {
    const glm::dvec2 at = glm::dvec2(x, y) * static_cast<double>(cells), whole = glm::floor(at);
    return core::shared::f64::perlinOfParts(glm::u32vec2(whole), at - whole, cells, salt, faded);
  };
}

Figures measurePerlin(const PerlinKnobs& knobs) {
  Figures figures;
  figures.columns = {"noise", "largest jump of the slope", "mean", "standard deviation", "ms a megasample"};
  figures.labels = {"without fade", "with fade"};
  for (const bool faded : {false, true}) {
    const NoisePlane noise = perlin(knobs, faded);
    const Smoothness smooth = smoothnessOf(noise, static_cast<int>(knobs.cells));
    figures.rows.push_back({smooth.largestSlopeJump, smooth.mean, smooth.deviation, megasampleMs(noise)});
  }
  figures.summary =
      sentence("without the fade the slope jumps by up to %.3g a period across the grid, with it by %.2g",
               figures.rows[0][0], figures.rows[1][0]);
  return figures;
}

Figures measureSpace(const PerlinKnobs& knobs) {
  Figures figures;
  figures.columns = {"noise", "largest jump of the slope", "mean", "standard deviation", "ms a megasample"};
  figures.labels = {"without fade", "with fade"};
  const std::uint32_t cells = bits(knobs.cells), salt = core::shared::f64::octaveSalt(bits(knobs.seed), 0, 3);
  for (const bool faded : {false, true}) {
    const NoisePlane noise = [=](double x, double y) {
      const glm::dvec3 at = glm::dvec3(x, y, knobs.slice) * static_cast<double>(cells),
                       whole = glm::floor(at);
      return core::shared::f64::perlinInSpaceOfParts(glm::u32vec3(whole), at - whole, cells, salt, faded);
    };
    const Smoothness smooth = smoothnessOf(noise, static_cast<int>(knobs.cells));
    figures.rows.push_back({smooth.largestSlopeJump, smooth.mean, smooth.deviation, megasampleMs(noise)});
  }
  figures.summary =
      sentence("eight corners and seven interpolations: %.1f times the time of the plane's four and three",
               figures.rows[1][3] / megasampleMs(perlin(knobs, true)));
  return figures;
}

Figures measureVoronoi(const VoronoiKnobs& knobs) {
  Figures figures;
  figures.columns = {"noise", "wrong share", "mean error, cells", "seeds asked", "tile's error"};
  figures.labels = {"own cell alone", "with neighbours", "truncated period", "floored period"};
  const OwnCellError own = ownCellError(knobs);
  const double truncated = tileError(knobs, false), floored = tileError(knobs, true);
  figures.rows = {
      {own.wrongShare, own.meanError, 1, 0}, {0, 0, 9, 0}, {0, 0, 9, truncated}, {0, 0, 9, floored}};
  figures.summary = sentence(
      "the own cell alone is wrong at %.0f %% of places, by %.2g cells in the mean; a truncated "
      "period tears the tile by up to %.2g cells, a floored one by %g",
      100 * own.wrongShare, own.meanError, truncated, floored);
  return figures;
}

NoisePlane perlinSum(const FractalKnobs& knobs, int octaves) {
  return [=](double x, double y) -> double {
    return f32::perlinFractal(placeOf(x, y), bits(knobs.cells), static_cast<std::uint32_t>(octaves),
                              static_cast<float>(knobs.gain), bits(knobs.seed));
  };
}

NoisePlane voronoiSum(const FractalKnobs& knobs, int octaves) {
  return [=](double x, double y) -> double {
    return f32::voronoiFractal(placeOf(x, y), bits(knobs.cells), static_cast<std::uint32_t>(octaves),
                               static_cast<float>(knobs.gain), bits(knobs.seed));
  };
}

Figures measureFractal(const FractalKnobs& knobs) {
  Figures figures;
  figures.columns = {"octaves", "Perlin: deviation", "ms a megasample", "Voronoi: deviation",
                     "ms a megasample"};
  for (const int octaves : {1, 2, 3, static_cast<int>(knobs.octaves)}) {
    std::vector<double>& row = figures.rows.emplace_back(1, octaves);
    for (const NoisePlane& noise : {perlinSum(knobs, octaves), voronoiSum(knobs, octaves)}) {
      row.push_back(smoothnessOf(noise, 1).deviation);
      row.push_back(megasampleMs(noise));
    }
  }
  figures.summary = sentence(
      "%d octaves take %.0f ms a megasample of Perlin and %.0f of Voronoi noise, %.1f and %.1f "
      "times those of one",
      static_cast<int>(knobs.octaves), figures.rows[3][2], figures.rows[3][4],
      figures.rows[3][2] / figures.rows[0][2], figures.rows[3][4] / figures.rows[0][4]);
  return figures;
}

std::vector<Curve> plotSpectrum(const FractalKnobs& knobs) {
  const int octaves = static_cast<int>(knobs.octaves);
  const NoisePlane perlin = perlinSum(knobs, octaves), voronoi = voronoiSum(knobs, octaves);
  return {histogramOf(perlin, -0.7, 0.7), histogramOf(voronoi, 0, 1.4), spectrumOf(perlin),
          spectrumOf(voronoi)};
}

Page page(std::string_view name, std::string_view title, std::string_view variant, std::string_view text) {
  return {.name = name, .title = title, .chapter = "noise", .variant = variant, .text = text};
}

}  // namespace

std::vector<Page> noisePages() {
  return {
      withKnobs<RandomKnobs>(page("sine-plot", "The fraction of a sine", "PAGE_SINE",
                                  "The fraction of sin(x) above, of sin(x) times 10000 below: the same "
                                  "function, squeezed until it looks "
                                  "random. Move `from` to 1e6 and it falls into steps."),
                             {}, measureRandom),
      withKnobs<RandomKnobs>(page("random", "Random numbers: sines, hashes", "PAGE_RANDOM",
                                  "Numbers of a plane above, of a slice of space below: by sines at the "
                                  "origin, by sines far away, by "
                                  "integer hashes at the origin, by hashes far away. The sine is only as "
                                  "random as the processor's sine is "
                                  "exact, so the game hashes integers."),
                             {}, measureRandom),
      withKnobs<PerlinKnobs>(page("perlin", "Perlin noise step by step", "PAGE_PERLIN",
                                  "Above: gradients at the nodes of a grid; the ways from a cell's corners "
                                  "to a place (blue) with its "
                                  "gradients (orange); their products, as lengths along the gradients, over "
                                  "the noise of the cell. Below: "
                                  "the corners' weights; noise with straight weights, whose grid shows; "
                                  "noise with Perlin's fade."),
                             {}, measurePerlin),
      withKnobs<PerlinKnobs>(page("perlin-space", "Perlin noise in space", "PAGE_SPACE",
                                  "Four slices, a quarter of a cell apart: above with straight weights, "
                                  "below with the fade. Gradients "
                                  "point to the twelve edges of a cube."),
                             {.cells = 6}, measureSpace),
      withKnobs<VoronoiKnobs>(
          page("voronoi", "Voronoi noise, and how it tiles", "PAGE_VORONOI",
               "The distance to the seed of the own cell alone, whose grid shows, and to the nearest of "
               "nine. Then noise "
               "that repeats after a period, across the origin: with a remainder that is negative for "
               "negative cells it "
               "tears there, with a floored one it does not. Orange: seeds, and the borders of the period."),
          {}, measureVoronoi),
      withKnobs<FractalKnobs>(page("fractal", "Octaves", "PAGE_FRACTAL",
                                   "One, two, three and ten octaves of Perlin noise above, of Voronoi noise "
                                   "below: each of twice the "
                                   "frequency and half the weight, over the sum of the weights."),
                              {}, measureFractal),
      withKnobs<FractalKnobs>(
          page("spectrum", "Histograms and spectra", "PAGE_SPECTRUM",
               "Perlin noise (orange) and Voronoi noise (blue) with the histogram of their values, and below "
               "the power "
               "over frequencies from 1 to 64 a period, both axes by ratios, six decades high."),
          {.octaves = 4}, measureFractal, plotSpectrum)};
}

}  // namespace skydrop::lab
