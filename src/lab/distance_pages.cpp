// Signed distances: shapes, their normals and light, shadows, blends, operators, ambient occlusion.
#include <algorithm>
#include <cstdio>

#include "lab/chapters.h"
#include "skydrop/lab/distance_measure.h"
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

std::vector<double> footRow(int scene, double amount) {
  const FootError error = footError(scene, amount);
  return {error.meanShort, error.mostShort, error.mostBeyond, stepsPerRay(scene, amount)};
}

const std::vector<std::string> kFootColumns = {"scene", "mean shortfall", "largest shortfall",
                                               "largest overshoot", "steps a ray"};

Figures measureShapes(const ShapeKnobs& knobs) {
  Figures figures;
  figures.columns = kFootColumns;
  figures.labels = {"shapes"};
  figures.rows = {footRow(f64::kShapesScene, 0)};
  const NormalError normal = normalError(knobs.epsilon);
  figures.summary = sentence(
      "%.1f steps a ray; distances end %.1g of themselves short of the surface at most; normals "
      "at this epsilon are %.2g rad wrong in float",
      figures.rows[0][3], figures.rows[0][1], normal.inFloat);
  return figures;
}

constexpr double kLeastEpsilon = 1e-12, kMostEpsilon = 0.1, kLeastError = 1e-12;

Figures measureNormals(const ShapeKnobs& knobs) {
  Figures figures;
  figures.columns = {"epsilon", "error in double, rad", "error in float, rad"};
  for (double epsilon = 0.1; epsilon > 0.5e-12; epsilon /= 10) {
    const NormalError error = normalError(epsilon);
    figures.rows.push_back({epsilon, error.inDouble, error.inFloat});
  }
  const NormalError now = normalError(knobs.epsilon);
  figures.summary =
      sentence("six distances a normal; at epsilon %.2g it is %.2g rad wrong in double and %.2g in float",
               knobs.epsilon, now.inDouble, now.inFloat);
  return figures;
}

std::vector<Curve> plotNormals(const ShapeKnobs&) {
  std::vector<Curve> curves(2);
  for (std::size_t i = 0; i < kPlotPlaces; ++i) {
    const double share = static_cast<double>(i) / (kPlotPlaces - 1);
    const NormalError error = normalError(kLeastEpsilon * std::pow(kMostEpsilon / kLeastEpsilon, share));
    curves[0][i] = logPlace(error.inFloat, kLeastError, 2);
    curves[1][i] = logPlace(error.inDouble, kLeastError, 2);
  }
  return curves;
}

Figures measureShadows(const ShadowKnobs& knobs) {
  Figures figures;
  figures.columns = {"k", "steps a ray", "light on the floor", "full shade that is none",
                     "light where shade is"};
  for (const double k : {1e9, knobs.hardness, knobs.softHardness}) {
    const ShadowError error = shadowError(knobs, k);
    figures.rows.push_back({k, error.stepsPerRay, error.meanLight, error.falseShade, error.falseLight});
  }
  figures.summary = sentence(
      "%.1f steps a shadow's ray; of the hard shadow %.2g %% of the floor differs from the "
      "closed form",
      figures.rows[0][1], 100 * (figures.rows[0][3] + figures.rows[0][4]));
  return figures;
}

Figures measureBlends(const BlendKnobs& knobs) {
  Figures figures;
  figures.columns = kFootColumns;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    figures.labels.push_back(sentence("blend %.2g", share));
    figures.rows.push_back(footRow(f64::kBlendScene, share));
  }
  for (const double width : {0.0, 0.5, 1.5}) {
    figures.labels.push_back(sentence("smooth union %.2g", width));
    figures.rows.push_back(footRow(f64::kSmoothScene, width));
  }
  const std::vector<double> blend = footRow(f64::kBlendScene, knobs.share),
                            smooth = footRow(f64::kSmoothScene, knobs.width);
  figures.summary = sentence(
      "the blend takes %.1f steps a ray and ends up to %.2g of a distance short, the smooth union "
      "%.1f and %.2g",
      blend[3], blend[1], smooth[3], smooth[1]);
  return figures;
}

Figures measureOperators(const BlendKnobs& knobs) {
  Figures figures;
  figures.columns = kFootColumns;
  figures.labels = {"box with holes", "union", "intersection", "difference"};
  figures.rows = {footRow(f64::kHolesScene, knobs.share), footRow(f64::kUnionScene, 0),
                  footRow(f64::kIntersectionScene, 0), footRow(f64::kDifferenceScene, 0)};
  figures.summary = sentence(
      "outside, the union is exact (to %.1g); intersection and difference are bounds that end up "
      "to %.2g and %.2g of a distance short, which costs steps but no surface",
      figures.rows[1][1], figures.rows[2][1], figures.rows[3][1]);
  return figures;
}

Figures measureOcclusion(const OcclusionKnobs& knobs) {
  Figures figures;
  figures.columns = {"places", "distances a pixel", "mean openness", "mean by hemisphere", "rms difference"};
  for (const int count : {0, 1, 3, 6, 12}) {
    OcclusionKnobs other = knobs;
    other.count = count;
    const OcclusionError error = occlusionError(other);
    figures.rows.push_back({static_cast<double>(count), static_cast<double>(count), error.meanOpenness,
                            error.meanReference, error.rmsDifference});
  }
  const OcclusionError now = occlusionError(knobs);
  figures.summary = sentence(
      "%d distances a pixel; differs by %.2g (rms) from the open share of the hemisphere over the "
      "same reach",
      static_cast<int>(knobs.count), now.rmsDifference);
  return figures;
}

Page page(std::string_view name, std::string_view title, std::string_view variant, std::string_view text) {
  return {.name = name, .title = title, .chapter = "distance", .variant = variant, .text = text};
}

}  // namespace

std::vector<Page> distancePages() {
  ShapeKnobs torus;
  torus.view = {.azimuthDegrees = 25, .elevationDegrees = 35, .distance = 2.6};
  return {withKnobs<ShapeKnobs>(page("shapes", "Shapes and Phong's light", "PAGE_SHAPES",
                                     "Sphere, box, torus, cylinder and plane as signed distances, lit by "
                                     "Phong's model with normals by central "
                                     "differences. Right a level cut: lines of equal distance, a tenth of a "
                                     "unit apart, brown inside."),
                                {}, measureShapes),
          withKnobs<ShapeKnobs>(page("normals", "Normals by central differences", "PAGE_NORMALS",
                                     "A torus whose normals are differences of six distances, as colours. "
                                     "Top right their error against the "
                                     "analytic gradient, a colour per ratio; below, the error over epsilon "
                                     "from 1e-12 to 0.1, both axes by "
                                     "ratios: truncation grows with epsilon squared to the right, rounding "
                                     "with 1 / epsilon to the left, in "
                                     "float (orange) and double (blue)."),
                                torus, measureNormals, plotNormals),
          withKnobs<ShadowKnobs>(page("shadows", "Hard and soft shadows", "PAGE_SHADOWS",
                                      "A second march towards the light: hard shadows left, soft ones by the "
                                      "nearest pass of the ray with k = "
                                      "7 and k = 1.2. Soft shadows darken beyond the shadow's edge only, so "
                                      "the shadow itself keeps its size."),
                                 {}, measureShadows),
          withKnobs<BlendKnobs>(
              page("blends", "Blending and smooth union", "PAGE_BLENDS",
                   "Left a blend of sphere and box: a weighted mean of their distances. Right a smooth "
                   "union, whose crease is "
                   "filled over a width. Neither is a distance any more but a bound, which costs steps."),
              {}, measureBlends),
          withKnobs<BlendKnobs>(page("operators", "Union, intersection, difference", "PAGE_OPERATORS",
                                     "A blend of box and sphere with a hole along each axis; right, from "
                                     "above, union, intersection and "
                                     "difference of a box and a sphere: the lesser distance, the greater, "
                                     "the greater with one negated."),
                                {}, measureOperators),
          withKnobs<OcclusionKnobs>(page("occlusion", "Ambient occlusion", "PAGE_OCCLUSION",
                                         "How much nearer the scene is than the way along the normal, at a "
                                         "few places: left applied to the "
                                         "picture, right alone, in red."),
                                    {}, measureOcclusion)};
}

}  // namespace skydrop::lab
