#include "skydrop/accuracy/flip.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace skydrop::accuracy {
namespace {

using glm::dvec3;

// Of the paper: exponent of the colour difference, the part of it that is mapped to [0, pt], width of a
// feature in degrees, exponent of the feature difference.
constexpr double kColorExponent = 0.7, kKneeShare = 0.4, kKneeValue = 0.95;
constexpr double kFeatureDegrees = 0.082, kFeatureExponent = 0.5;

// A plane of numbers, addressed with the border's values repeated outside.
struct Plane {
  int width = 0, height = 0;
  std::vector<double> values;

  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(std::clamp(x, 0, width - 1));
  }
  double at(int x, int y) const { return values[index(x, y)]; }
};

using Kernel = std::vector<double>;  // 2 radius + 1 weights

// First along x, then along y.
Plane convolved(const Plane& plane, const Kernel& alongX, const Kernel& alongY) {
  const auto pass = [](const Plane& from, const Kernel& kernel, int stepX, int stepY) {
    const int radius = static_cast<int>(kernel.size()) / 2;
    Plane to(from.width, from.height);
    for (int y = 0; y < from.height; ++y) {
      for (int x = 0; x < from.width; ++x) {
        double sum = 0;
        for (int i = -radius; i <= radius; ++i)
          sum += kernel[static_cast<std::size_t>(i + radius)] * from.at(x + i * stepX, y + i * stepY);
        to.values[to.index(x, y)] = sum;
      }
    }
    return to;
  };
  return pass(pass(plane, alongX, 1, 0), alongY, 0, 1);
}

double total(const Kernel& kernel) {
  double sum = 0;
  for (const double weight : kernel) sum += weight;
  return sum;
}

// Linear sRGB to XYZ.
const glm::dmat3& toXyz() {
  static const glm::dmat3 matrix =
      glm::transpose(glm::dmat3(10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794,
                                2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
                                1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382));
  return matrix;
}
dvec3 whiteXyz() { return toXyz() * dvec3(1); }

double linearOf(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

dvec3 yCxCzOf(const dvec3& linear) {
  const dvec3 v = toXyz() * linear / whiteXyz();
  return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

dvec3 linearOfYCxCz(const dvec3& c) {
  static const glm::dmat3 fromXyz = glm::inverse(toXyz());
  const double y = (c.x + 16) / 116;
  const dvec3 linear = fromXyz * (dvec3(y + c.y / 500, y, y - c.z / 200) * whiteXyz());
  return glm::clamp(linear, 0.0, 1.0);
}

// CIELAB with the colours bent towards grey where it is dark (Hunt 2004).
dvec3 huntLab(const dvec3& linear) {
  constexpr double kDelta = 6.0 / 29;
  const auto f = [](double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
  };
  const dvec3 v = toXyz() * linear / whiteXyz();
  const double x = f(v.x), y = f(v.y), z = f(v.z);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

// HyAB: city-block between lightness and colour, Euclidean within the colour (Abasi et al. 2020).
double hyab(const dvec3& a, const dvec3& b) {
  const dvec3 d = a - b;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// The eye's contrast sensitivity as a sum of Gaussians a sqrt(pi / b) exp(-pi^2 x^2 / b).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> kSensitivities = {
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

Plane sensed(const Plane& plane, const Sensitivity& s, double pixelsPerDegree) {
  constexpr double kPi2 = std::numbers::pi * std::numbers::pi;
  constexpr double kWidest = 0.04;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest / (2 * kPi2)) * pixelsPerDegree));
  Plane sum(plane.width, plane.height);
  double weight = 0;
  for (const auto& [a, b] : {std::pair(s.a1, s.b1), std::pair(s.a2, s.b2)}) {
    if (a == 0) continue;
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) {
      const double degrees = i / pixelsPerDegree;
      kernel.push_back(std::exp(-kPi2 * degrees * degrees / b));
    }
    const double scale = a * std::sqrt(std::numbers::pi / b);
    const Plane part = convolved(plane, kernel, kernel);
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += scale * part.values[i];
    weight += scale * total(kernel) * total(kernel);
  }
  for (double& value : sum.values) value /= weight;
  return sum;
}

struct Seen {
  std::vector<dvec3> lab;  // of the filtered picture, Hunt-adjusted
  Plane lightness;         // [0, 1], unfiltered
};

Seen seen(const SeenPicture& image, double pixelsPerDegree) {
  std::array<Plane, 3> channels = {Plane(image.width, image.height), Plane(image.width, image.height),
                                   Plane(image.width, image.height)};
  const std::size_t count = channels[0].values.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double* p = &image.values[3 * i];
    const dvec3 c = yCxCzOf({linearOf(p[0]), linearOf(p[1]), linearOf(p[2])});
    for (int k = 0; k < 3; ++k) channels[static_cast<std::size_t>(k)].values[i] = c[k];
  }
  Plane lightness = channels[0];
  for (double& value : lightness.values) value = (value + 16) / 116;
  for (std::size_t k = 0; k < 3; ++k) channels[k] = sensed(channels[k], kSensitivities[k], pixelsPerDegree);
  std::vector<dvec3> lab(count);
  for (std::size_t i = 0; i < count; ++i) {
    lab[i] = huntLab(linearOfYCxCz({channels[0].values[i], channels[1].values[i], channels[2].values[i]}));
  }
  return {std::move(lab), std::move(lightness)};
}

// Strength of edges (first derivative of a Gaussian) or points (second) in every pixel.
enum class Feature { edge, point };

std::vector<double> strength(const Plane& lightness, Feature feature, double pixelsPerDegree) {
  const double sigma = 0.5 * kFeatureDegrees * pixelsPerDegree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  Kernel across, along;
  for (int i = -radius; i <= radius; ++i) {
    const double gauss = std::exp(-i * i / (2 * sigma * sigma));
    along.push_back(gauss);
    across.push_back((feature == Feature::edge ? -i : i * i / (sigma * sigma) - 1) * gauss);
  }
  // In the plane weights above 0 add up to 1 and those below to -1: `along` scales both alike.
  double above = 0, below = 0;
  for (const double weight : across) (weight > 0 ? above : below) += std::abs(weight);
  for (double& weight : across) weight /= weight > 0 ? above : below;
  const double sum = total(along);
  for (double& weight : along) weight /= sum;
  const Plane x = convolved(lightness, across, along), y = convolved(lightness, along, across);
  std::vector<double> norm(x.values.size());
  for (std::size_t i = 0; i < norm.size(); ++i) norm[i] = std::hypot(x.values[i], y.values[i]);
  return norm;
}

// A colour difference to [0, 1]: linear to the knee, compressed beyond it.
double redistributed(double difference) {
  static const double largest = std::pow(hyab(huntLab({0, 1, 0}), huntLab({0, 0, 1})), kColorExponent);
  const double knee = kKneeShare * largest;
  if (difference < knee) return kKneeValue / knee * difference;
  return kKneeValue + (difference - knee) / (largest - knee) * (1 - kKneeValue);
}

}  // namespace

std::vector<double> flipMap(const SeenPicture& picture, const SeenPicture& reference,
                            double pixelsPerDegree) {
  assert(picture.width == reference.width && picture.height == reference.height && picture.width > 0);
  const Seen a = seen(picture, pixelsPerDegree), r = seen(reference, pixelsPerDegree);
  const auto edgesA = strength(a.lightness, Feature::edge, pixelsPerDegree),
             edgesR = strength(r.lightness, Feature::edge, pixelsPerDegree),
             pointsA = strength(a.lightness, Feature::point, pixelsPerDegree),
             pointsR = strength(r.lightness, Feature::point, pixelsPerDegree);
  std::vector<double> errors(a.lab.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double color = redistributed(std::pow(hyab(a.lab[i], r.lab[i]), kColorExponent));
    const double features = std::max(std::abs(edgesA[i] - edgesR[i]), std::abs(pointsA[i] - pointsR[i]));
    const double feature = std::pow(features / std::numbers::sqrt2, kFeatureExponent);
    errors[i] = std::pow(color, 1 - feature);
  }
  return errors;
}

double flip(const SeenPicture& picture, const SeenPicture& reference, double pixelsPerDegree) {
  double sum = 0;
  const std::vector<double> errors = flipMap(picture, reference, pixelsPerDegree);
  for (const double error : errors) sum += error;
  return sum / static_cast<double>(errors.size());
}

core::Image heatMap(const std::vector<double>& errors, int width, int height) {
  // Five of the colours of magma (Smith, van der Walt 2015), mixed in between.
  static constexpr std::array<std::array<double, 3>, 5> kColors = {
      {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}}};
  core::Image image(width, height);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double t = std::clamp(errors[i], 0.0, 1.0) * (kColors.size() - 1);
    const auto at = std::min(static_cast<std::size_t>(t), kColors.size() - 2);
    const double share = t - static_cast<double>(at);
    for (std::size_t k = 0; k < 3; ++k) {
      image.rgba[4 * i + k] =
          static_cast<std::uint8_t>(std::lround(kColors[at][k] * (1 - share) + kColors[at + 1][k] * share));
    }
    image.rgba[4 * i + 3] = 255;
  }
  return image;
}

}  // namespace skydrop::accuracy
