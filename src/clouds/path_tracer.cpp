#include "skydrop/clouds/path_tracer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <mutex>
#include <string>

#include "skydrop/clouds/raised_sun.h"
#include "skydrop/core/error.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/core/shared.h"

namespace skydrop::clouds {
namespace {

namespace f64 = core::shared::f64;

constexpr double kPi = glm::pi<double>();
constexpr double kLongestM = 1e6;           // of a way without an event
constexpr double kLeastAnisotropy = 1e-3;   // below, scattering is even
constexpr double kMostAnisotropy = 0.95;    // as henyeyGreenstein()
constexpr double kFewTransmittance = 0.05;  // below, ways to the sun are given up by chance
constexpr double kFewWeight = 0.1;          // below, paths are
constexpr double kMarginOfShape = 0.06;     // what the shape may rise by between two places of a cell
constexpr double kCellM = 100, kRowM = 75;

double freePath(double bound, core::RandomStream& random) { return -std::log1p(-random.nextUnit()) / bound; }

// A length along a ray and what the path weighs after it.
struct Collision {
  double atM;
  double weight;
  bool isThere;  // false: the ray left
};

// Where the layer ends along a ray; 0 where the place is outside and does not enter.
f64::RaySpan layerAlong(const TracedMedium& medium, const glm::dvec3& place, const glm::dvec3& direction) {
  const f64::RaySpan span = f64::raySpanBetween(place.y, direction.y, medium.baseM, medium.topM);
  return f64::make_raySpan(span.begin, std::min(span.end, kLongestM));
}

// The next scattering between two lengths of a ray.
Collision nextCollision(const TracedMedium& medium, const glm::dvec3& origin, const glm::dvec3& direction,
                        double beginM, double endM, core::RandomStream& random) {
  double at = beginM, weight = 1;
  while (at < endM) {
    const ExtinctionBounds::Piece piece = medium.bounds->pieceAt(origin + direction * at, direction);
    const double pieceEnd = std::min(at + piece.endM, endM);
    while (piece.bound > 0) {
      at += freePath(piece.bound, random);
      if (!(at < pieceEnd)) break;
      const double extinction = medium.extinction(origin + direction * at);
      // Where the bound is exceeded both outcomes stay possible, and weights make up for it.
      const double other = std::abs(piece.bound - extinction), sum = extinction + other;
      if (random.nextUnit() * sum < extinction) return {at, weight * sum / piece.bound, true};
      weight *= (piece.bound < extinction ? -sum : sum) / piece.bound;
    }
    at = pieceEnd;
  }
  return {endM, weight, false};
}

glm::dvec3 turned(const glm::dvec3& direction, double cosAngle, double azimuth) {
  // A basis without a special case (Duff and others 2017).
  const double sign = std::copysign(1.0, direction.z);
  const double a = -1 / (sign + direction.z), b = direction.x * direction.y * a;
  const glm::dvec3 u(1 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x),
      v(b, sign + direction.y * direction.y * a, -direction.y);
  const double sine = std::sqrt(std::max(0.0, 1 - cosAngle * cosAngle));
  return glm::normalize(sine * std::cos(azimuth) * u + sine * std::sin(azimuth) * v + cosAngle * direction);
}

double phaseOf(const TracedPhase& phase, double cosAngle) {
  return std::lerp(f64::henyeyGreenstein(cosAngle, phase.anisotropy),
                   f64::henyeyGreenstein(cosAngle, phase.forwardAnisotropy), phase.forwardShare);
}

glm::dvec3 scattered(const TracedPhase& phase, const glm::dvec3& direction, core::RandomStream& random) {
  const double lobe = random.nextUnit(), draw = random.nextUnit(), azimuth = 2 * kPi * random.nextUnit();
  const double g = std::clamp(lobe < phase.forwardShare ? phase.forwardAnisotropy : phase.anisotropy,
                              -kMostAnisotropy, kMostAnisotropy);
  double cosAngle = 2 * draw - 1;
  if (std::abs(g) > kLeastAnisotropy) {
    const double root = (1 - g * g) / (1 + g * cosAngle);
    cosAngle = (1 + g * g - root * root) / (2 * g);
  }
  return turned(direction, std::clamp(cosAngle, -1.0, 1.0), azimuth);
}

// Roulette: what weighs little goes on by chance, and weighs more then. False: it ended.
bool survives(double& weight, double few, core::RandomStream& random) {
  const double size = std::abs(weight);
  if (size >= few) return true;
  if (!(random.nextUnit() * few < size)) return false;
  weight *= few / size;
  return true;
}

void requireUnit(const glm::dvec3& direction, const char* name) {
  if (std::abs(glm::dot(direction, direction) - 1) <= 1e-5) return;
  throw core::RangeError("the direction " + std::string(name) + " has to be of length 1");
}

// Sums of one source over paths.
struct Moments {
  double sum = 0, squares = 0;
  void add(double value) {
    sum += value;
    squares += value * value;
  }
  double mean(int n) const { return sum / n; }
  double error(int n) const { return std::sqrt(std::max(0.0, squares / n - mean(n) * mean(n)) / (n - 1)); }
};

TracedPixel traceRay(const TracedMedium& medium, const TracedPhase& phase, const glm::dvec3& toSun,
                     const MarchRay& ray, int paths, std::uint64_t seed) {
  Moments sun, sky, ground, transmittance;
  for (int i = 0; i < paths; ++i) {
    core::RandomStream random{core::hashCombine(seed, static_cast<std::uint64_t>(i)), 0};
    const TracedLight light = tracePath(medium, phase, toSun, ray, random);
    sun.add(light.sun);
    sky.add(light.sky);
    ground.add(light.ground);
    transmittance.add(light.transmittance);
  }
  return {{sun.mean(paths), sky.mean(paths), ground.mean(paths), transmittance.mean(paths)},
          {sun.error(paths), sky.error(paths), ground.error(paths), transmittance.error(paths)}};
}

}  // namespace

TracedPhase tracedPhaseOf(const CloudLayerSettings& layer) {
  return {layer.anisotropy, layer.forwardShare, f64::kForwardAnisotropy, 1};
}

TracedMedium tracedMediumOf(const CloudField& field) {
  const CloudLayerSettings& layer = field.layer();
  const auto near = [&field](const glm::dvec3& place) {
    const auto shape = static_cast<double>(field.shapeEstimateInFloat(place));
    return std::clamp(shape + kMarginOfShape, 0.0, 1.0) * field.layer().extinction;
  };
  const double top = layer.cloudHeight + layer.thickness;
  return {[&field](const glm::dvec3& place) {
            return static_cast<double>(field.densityInFloat(place)) * field.layer().extinction;
          },
          layer.cloudHeight, top,
          std::make_shared<const ExtinctionBounds>(near, layer.cloudHeight, top,
                                                   weatherPeriod(field.medium()), kCellM, kRowM)};
}

TracedMedium homogeneousMedium(double extinction, double baseM, double topM) {
  const auto everywhere = [extinction](const glm::dvec3&) { return extinction; };
  return {everywhere, baseM, topM,
          std::make_shared<const ExtinctionBounds>(everywhere, baseM, topM, 1e6, 1e6, topM - baseM)};
}

double ratioTrackedTransmittance(const TracedMedium& medium, const glm::dvec3& place,
                                 const glm::dvec3& direction, double lengthM, core::RandomStream& random) {
  const f64::RaySpan span = layerAlong(medium, place, direction);
  const double end = std::min(span.end, lengthM);
  double at = span.begin, left = 1;
  while (at < end) {
    const ExtinctionBounds::Piece piece = medium.bounds->pieceAt(place + direction * at, direction);
    const double pieceEnd = std::min(at + piece.endM, end);
    while (piece.bound > 0) {
      at += freePath(piece.bound, random);
      if (!(at < pieceEnd)) break;
      left *= 1 - medium.extinction(place + direction * at) / piece.bound;
      if (!survives(left, kFewTransmittance, random)) return 0;
    }
    at = pieceEnd;
  }
  return left;
}

TracedLight tracePath(const TracedMedium& medium, const TracedPhase& phase, const glm::dvec3& toSun,
                      const MarchRay& ray, core::RandomStream& random) {
  TracedLight light;
  glm::dvec3 place = ray.origin, direction = ray.direction;
  f64::RaySpan span =
      f64::overlap(layerAlong(medium, place, direction), f64::make_raySpan(ray.beginM, ray.endM));
  Collision next = nextCollision(medium, place, direction, span.begin, span.end, random);
  light.transmittance = next.isThere ? 0 : next.weight;
  if (!next.isThere) return light;
  const glm::dvec3 throughLayer = raisedSun(toSun);
  double weight = 1;
  while (true) {
    place += direction * next.atM;
    weight *= next.weight * phase.albedo;
    if (!survives(weight, kFewWeight, random)) return light;
    if (toSun.y > 0) {
      light.sun += weight * phaseOf(phase, glm::dot(direction, toSun)) *
                   ratioTrackedTransmittance(medium, place, throughLayer, kLongestM, random);
    }
    direction = scattered(phase, direction, random);
    span = layerAlong(medium, place, direction);
    next = nextCollision(medium, place, direction, span.begin, span.end, random);
    if (next.isThere) continue;
    (direction.y > 0 ? light.sky : light.ground) += weight * next.weight / kPi;
    return light;
  }
}

std::vector<TracedPixel> traceRays(const TracedMedium& medium, const TracedPhase& phase,
                                   const glm::dvec3& toSun, std::span<const MarchRay> rays, int paths,
                                   std::uint64_t seed, core::JobPool* pool) {
  requireUnit(toSun, "to the sun");
  for (const MarchRay& ray : rays) requireUnit(ray.direction, "of a ray");
  if (paths < 2) throw core::RangeError("an error bar takes two paths at least");
  std::vector<TracedPixel> pixels(rays.size());
  std::atomic<std::size_t> nextRay = 0;
  const auto work = [&] {
    for (std::size_t i = nextRay++; i < rays.size(); i = nextRay++) {
      pixels[i] = traceRay(medium, phase, toSun, rays[i], paths, core::hashCombine(seed, i));
    }
  };
  if (pool == nullptr) {
    work();
    return pixels;
  }
  std::mutex mutex;
  std::condition_variable ended;
  int running = 0;
  for (int i = 0; i < pool->workers(); ++i) {
    const auto job = [&](std::stop_token) {
      work();
      const std::scoped_lock lock(mutex);
      --running;
      ended.notify_all();
    };
    {
      const std::scoped_lock lock(mutex);
      ++running;
    }
    if (!pool->submit(0, job)) {
      const std::scoped_lock lock(mutex);
      --running;
    }
  }
  work();
  std::unique_lock lock(mutex);
  ended.wait(lock, [&] { return running == 0; });
  return pixels;
}

}  // namespace skydrop::clouds
