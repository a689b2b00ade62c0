#include "skydrop/lab/cloud_measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "lab/chapters.h"
#include "skydrop/lab/shared.h"

namespace skydrop::lab {
namespace {

namespace f32 = core::shared::f32;
namespace f64 = core::shared::f64;
using glm::dvec3;

constexpr int kFinest = 512, kFinestLight = 64;

f64::CubeCloud cloudOf(const CloudKnobs& knobs) {
  return {static_cast<std::uint32_t>(knobs.cells),
          static_cast<std::uint32_t>(knobs.seed),
          knobs.perlinThreshold,
          knobs.perlinMultiplier,
          knobs.voronoiThreshold,
          knobs.voronoiMultiplier};
}

double densityAt(const f64::CubeCloud& cloud, const dvec3& place) {
  return f64::cubeDensities(cloud, f64::cubeNoises(cloud, place)).y;
}

double depthAlong(const CloudKnobs& knobs, const dvec3& origin, const dvec3& ray, const f64::RaySpan& span,
                  int samples) {
  const f64::CubeCloud cloud = cloudOf(knobs);
  const double stride = (span.end - span.begin) / std::max(samples, 1);
  double sum = 0;
  for (int i = 0; i < samples; ++i) sum += densityAt(cloud, origin + ray * (span.begin + (i + 0.5) * stride));
  return sum * stride * knobs.extinction;
}

// Rays that meet the cube: visit(origin, ray, span, place in the picture).
template <class Visit>
int forRays(const CloudKnobs& knobs, int across, int down, Visit visit) {
  const f64::Orbit eye = f64::make_orbit({0.5, 0.5, 0.5}, radians(knobs.view.azimuthDegrees),
                                         radians(knobs.view.elevationDegrees), knobs.view.distance);
  int count = 0;
  for (int y = 0; y < down; ++y) {
    for (int x = 0; x < across; ++x) {
      const glm::dvec2 at((2 * x + 1.0 - across) / down, (2 * y + 1.0 - down) / down);
      const dvec3 ray = f64::orbitRay(eye, at, 1.8);
      const f64::RaySpan span = f64::raySpanOfBox(eye.place, ray, {0, 0, 0}, {1, 1, 1});
      if (span.end <= span.begin) continue;
      visit(eye, ray, span, at);
      ++count;
    }
  }
  return std::max(count, 1);
}

double sunAlong(const CloudKnobs& knobs, const dvec3& origin, const dvec3& ray, const f64::RaySpan& span,
                int steps, int lightSamples) {
  const f64::CubeCloud cloud = cloudOf(knobs);
  const dvec3 toSun =
      -f64::make_orbit({0, 0, 0}, radians(knobs.sunAzimuthDegrees), radians(knobs.sunElevationDegrees), 1)
           .ahead;
  f64::CubeLight light = f64::make_cubeLight();
  const double stride = (span.end - span.begin) / std::max(steps, 1);
  for (int i = 0; i < steps; ++i) {
    const dvec3 place = origin + ray * (span.begin + (i + 0.5) * stride);
    const double depth = knobs.extinction * stride * densityAt(cloud, place);
    if (depth <= 0) continue;
    const f64::RaySpan toEdge = f64::raySpanOfBox(place, toSun, {0, 0, 0}, {1, 1, 1});
    light = f64::afterStep(light, depth, depthAlong(knobs, place, toSun, toEdge, lightSamples));
  }
  return light.sun;
}

}  // namespace

Volume cloudVolume(const CloudKnobs& knobs) {
  Volume volume;
  volume.side = kCloudVolumeSide;
  volume.pairs.reserve(std::size_t{2} * kCloudVolumeSide * kCloudVolumeSide * kCloudVolumeSide);
  f32::CubeCloud cloud{};
  cloud.cells = static_cast<std::uint32_t>(knobs.cells);
  cloud.seed = static_cast<std::uint32_t>(knobs.seed);
  const auto place = [](int i) { return (static_cast<float>(i) + 0.5f) / kCloudVolumeSide; };
  for (int z = 0; z < kCloudVolumeSide; ++z) {
    for (int y = 0; y < kCloudVolumeSide; ++y) {
      for (int x = 0; x < kCloudVolumeSide; ++x) {
        const glm::vec2 noises = f32::cubeNoises(cloud, {place(x), place(y), place(z)});
        volume.pairs.push_back(noises.x);
        volume.pairs.push_back(noises.y);
      }
    }
  }
  return volume;
}

SampleError sampleError(const CloudKnobs& knobs, int steps) {
  SampleError error;
  error.samplesPerRay = steps;
  const int rays =
      forRays(knobs, 12, 8,
              [&](const f64::Orbit& eye, const dvec3& ray, const f64::RaySpan& span, const glm::dvec2&) {
                const double apart = std::abs(std::exp(-depthAlong(knobs, eye.place, ray, span, steps)) -
                                              std::exp(-depthAlong(knobs, eye.place, ray, span, kFinest)));
                error.meanError += apart;
                error.largestError = std::max(error.largestError, apart);
              });
  error.meanError /= rays;
  return error;
}

LightError lightError(const CloudKnobs& knobs, int steps, int lightSamples) {
  LightError error;
  double seconds = 0;
  const int rays = forRays(
      knobs, 6, 4, [&](const f64::Orbit& eye, const dvec3& ray, const f64::RaySpan& span, const glm::dvec2&) {
        const auto begin = std::chrono::steady_clock::now();
        const double light = sunAlong(knobs, eye.place, ray, span, steps, lightSamples);
        seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        error.meanLight += light;
        error.meanError += std::abs(light - sunAlong(knobs, eye.place, ray, span, steps, kFinestLight));
      });
  error.meanError /= rays;
  error.meanLight /= rays;
  error.msPerThousandRays = 1e6 * seconds / rays;
  return error;
}

std::vector<double> lightErrors(const CloudKnobs& knobs, int steps, int most) {
  std::vector<double> errors(static_cast<std::size_t>(most), 0.0);
  const int rays = forRays(
      knobs, 6, 4, [&](const f64::Orbit& eye, const dvec3& ray, const f64::RaySpan& span, const glm::dvec2&) {
        const double finest = sunAlong(knobs, eye.place, ray, span, steps, kFinestLight);
        for (std::size_t i = 0; i < errors.size(); ++i)
          errors[i] +=
              std::abs(sunAlong(knobs, eye.place, ray, span, steps, static_cast<int>(i) + 1) - finest);
      });
  for (double& error : errors) error /= rays;
  return errors;
}

ForwardError forwardError(const CloudKnobs& knobs) {
  ForwardError error;
  int dense = 0;
  forRays(knobs, 24, 16,
          [&](const f64::Orbit& eye, const dvec3& ray, const f64::RaySpan& span, const glm::dvec2& at) {
            const double transmittance = std::exp(-depthAlong(knobs, eye.place, ray, span, 64));
            if (transmittance > 0.01) return;
            ++dense;
            const double sun = f64::forwardedSun(glm::length(at - glm::dvec2(0.12, 0.18)), knobs.sunReach,
                                                 knobs.sunStrength);
            error.plain += sun;
            error.mended += sun * transmittance;
          });
  error.plain /= std::max(dense, 1);
  error.mended /= std::max(dense, 1);
  return error;
}

}  // namespace skydrop::lab
