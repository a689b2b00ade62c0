#include "skydrop/sky/reference_paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "skydrop/core/hash.h"

namespace skydrop::sky {
namespace {

namespace f64 = core::shared::f64;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;
constexpr int kFirstSteps = 256;  // among which the first scattering of a path is chosen
constexpr int kSteps = 16;        // of the ways from there on
constexpr int kMostOrders = 64;
// Paths of which less is expected, as a share of what the first scattering sends, go on by chance.
constexpr double kRoulette = 0.25;
constexpr double kAroundSun = 0.6;  // mean cosine of directions chosen about the light
// A tenth of the places is chosen by how much is scattered there alone, whatever light is expected.
constexpr double kByScattering = 0.1;

// Of a rank-1 lattice in base 2, for up to 2^20 points in any number of dimensions (exod2_base2_m20 of Cools,
// Kuo and Nuyens, "Constructing embedded lattice rules for multivariate integration", 2006).
constexpr std::array<std::uint32_t, 32> kLattice = {
    1,      182667, 469891, 498753, 110745, 446247, 250185, 118627, 245333, 283199, 408519,
    391023, 246327, 126539, 399185, 461527, 300343, 69681,  516695, 436179, 106383, 238523,
    413283, 70841,  47719,  300129, 113029, 123925, 410745, 211325, 17489,  511893};

double reversedBits(std::uint32_t x) {
  std::uint32_t reversed = 0;
  for (int i = 0; i < 32; ++i) reversed |= (x >> i & 1u) << (31 - i);
  return reversed * 0x1p-32;
}

double sum(const dvec3& a) { return a.x + a.y + a.z; }

// A direction at an angle to another.
dvec3 turned(const dvec3& direction, double cosine, double azimuth) {
  const dvec3 aside = std::abs(direction.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 u = glm::normalize(glm::cross(direction, aside)), v = glm::cross(direction, u);
  const double sine = std::sqrt(std::max(1 - cosine * cosine, 0.0));
  return glm::normalize(direction * cosine + (u * std::cos(azimuth) + v * std::sin(azimuth)) * sine);
}

// The cosine that a share of Rayleigh's phase function lies below of: a cubic with one real root.
double rayleighCosine(double share) {
  const double q = 4 * share - 2, d = std::cbrt(q + std::sqrt(q * q + 1));
  return std::clamp(d - 1 / d, -1.0, 1.0);
}

double henyeyGreensteinCosine(double share, double g) {
  if (std::abs(g) < 1e-3) return 2 * share - 1;
  const double s = (1 - g * g) / (1 - g + 2 * g * share);
  return std::clamp((1 + g * g - s * s) / (2 * g), -1.0, 1.0);
}

// Directions about where the air glows, most of them towards the light's azimuth: where twilight comes from.
struct Lobe {
  double lowest, middle, width;  // sines of elevations
  double towards;                // 0: all azimuths alike, < 1

  double place(double sine) const { return std::atan((sine - middle) / width); }
  double span() const { return place(1) - place(lowest); }
  double sine(double share) const {
    return std::clamp(middle + width * std::tan(place(lowest) + share * span()), lowest, 1.0);
  }
  double azimuth(double share) const {
    return 2 * std::atan((1 - towards) / (1 + towards) * std::tan(kPi * (share - 0.5)));
  }
  // Per solid angle.
  double density(double sine, double cosAzimuth) const {
    if (sine < lowest) return 0;
    const double x = (sine - middle) / width;
    return (1 - towards * towards) / (2 * kPi * (1 + towards * towards - 2 * towards * cosAzimuth)) /
           (width * (1 + x * x) * span());
  }
};

// The sine at which a level of the air that is bright at twilight is seen, from above it.
double glowSine(double heightM) {
  constexpr double kGlowM = 18000;
  return -std::sqrt(2 * std::max(heightM - kGlowM, 0.0) / f64::kEarthRadius);
}

}  // namespace

// A point of the lattice, coordinate by coordinate, and random numbers where it has no more.
class ReferencePaths::Point {
 public:
  Point(std::uint64_t seed, std::uint32_t index)
      : shifts_{seed}, random_{core::hashCombine(seed, index + 1)}, at_(reversedBits(index)) {}

  double next() {
    if (count_ >= kLattice.size()) return random_.nextUnit();
    const double x = at_ * kLattice[count_++] + shifts_.nextUnit();
    return x - std::floor(x);
  }

 private:
  core::RandomStream shifts_, random_;
  double at_;
  std::size_t count_ = 0;
};

// Where light is scattered, or sent back by the ground.
struct ReferencePaths::Place {
  dvec3 at{0};
  double heightM = 0, sunSine = 0;
  bool onGround = false;
  dvec3 from{0};    // unit: on to here
  dvec3 weight{1};  // what a radiance along `from`, sent by a unit of the place's volume, counts
};

// What is seen from a place in a direction.
struct ReferencePaths::Sight {
  struct Step {
    double t, heightM, sunSine;
    dvec3 left;     // transmittance times the length that the step stands for
    double chance;  // summed up
  };
  dvec3 from, direction;
  std::array<Step, kSteps + 1> steps;  // the last one is the ground, or nothing
  bool meetsGround;
  dvec3 once;  // light scattered, or sent back, once on this way
};

ReferencePaths::ReferencePaths(const ReferenceSky& sky, const ReferenceRay& ray, std::uint64_t seed)
    : sky_(&sky),
      seed_(seed),
      toSun_(std::sqrt(std::max(1 - ray.sunSine * ray.sunSine, 0.0)), ray.sunSine, 0),
      eye_(0, f64::kEarthRadius + ray.heightM, 0),
      length_(endOf(ray)) {
  const double across = std::sqrt(std::max(1 - ray.sine * ray.sine, 0.0));
  direction_ = dvec3(across * ray.cosAzimuth, ray.sine,
                     across * std::sqrt(std::max(1 - ray.cosAzimuth * ray.cosAzimuth, 0.0)));
  const double between = betweenOf(ray);
  std::vector<dvec3> scattered;
  std::vector<dvec3> light;
  dvec3 left(1), all(0);
  for (int i = 0; i < kFirstSteps; ++i) {
    const double a = static_cast<double>(i) / kFirstSteps, b = (i + 1.0) / kFirstSteps;
    const double from = length_ * a * a, to = length_ * b * b, t = 0.5 * (from + to);
    const double height = f64::shellHeightAlong(ray.heightM, ray.sine, t);
    const f64::ShellAir air = f64::shellAirAt(sky_->air_, height);
    const double sun =
        ((f64::kEarthRadius + ray.heightM) * ray.sunSine + t * between) / (f64::kEarthRadius + height);
    left_.push_back(left);
    const dvec3 step = glm::exp(-air.extinction * (to - from));
    scattered.push_back(left * (1.0 - step) * (air.rayleigh + dvec3(air.haze)) / air.extinction);
    light.push_back(scattered.back() * sky_->expected(std::max(height, 0.0), sun));
    all += light.back();
    left *= step;
  }
  weigh_ = 1.0 / glm::max(all, dvec3(1e-300));
  dvec3 ofAll(0);
  for (const dvec3& one : scattered) ofAll += one;
  double chance = 0;
  for (std::size_t i = 0; i < kFirstSteps; ++i) {
    chance +=
        (1 - kByScattering) * sum(light[i] * weigh_) / 3 + kByScattering * sum(scattered[i] / ofAll) / 3;
    chances_.push_back(chance);
  }
}

ReferencePaths::Place ReferencePaths::firstPlace(double share) const {
  const double wanted = share * chances_.back();
  const auto found = std::upper_bound(chances_.begin(), chances_.end() - 1, wanted);
  const auto i = static_cast<std::size_t>(found - chances_.begin());
  const double before = i > 0 ? chances_[i - 1] : 0, chance = chances_[i] - before;
  const double a = static_cast<double>(i) / kFirstSteps, b = (static_cast<double>(i) + 1) / kFirstSteps;
  const double from = length_ * a * a, to = length_ * b * b,
               at = (to - from) * std::clamp((wanted - before) / chance, 0.0, 1.0);
  Place place;
  place.at = eye_ + direction_ * (from + at);
  const double r = glm::length(place.at);
  place.heightM = std::max(r - f64::kEarthRadius, 0.0);
  place.sunSine = glm::dot(place.at, toSun_) / r;
  place.from = direction_;
  const f64::ShellAir air = f64::shellAirAt(sky_->air_, place.heightM);
  place.weight = left_[i] * glm::exp(-air.extinction * at) * ((to - from) * chances_.back() / chance);
  return place;
}

// `offset`: where in its steps all are, so that the mean over it is the integral.
ReferencePaths::Sight ReferencePaths::look(const Place& from, const dvec3& direction, double offset) const {
  Sight sight;
  sight.from = from.at;
  sight.direction = direction;
  const double r = f64::kEarthRadius + from.heightM;
  const double climb = std::clamp(glm::dot(direction, from.at) / glm::length(from.at), -1.0, 1.0);
  sight.meetsGround = climb < f64::horizonSine(from.heightM);
  const double length =
      std::max(sight.meetsGround ? f64::shellCrossing(from.heightM, climb, 0).x
                                 : f64::shellCrossing(from.heightM, climb, f64::kShellTop).y,
               0.0);
  const double between = glm::dot(direction, toSun_);
  const double byAir = f64::rayleighPhase(between),
               byHaze = f64::henyeyGreenstein(between, sky_->air_.hazeAnisotropy);
  sight.once = dvec3(0);
  // Depth by parabolas through three places: of extinction a unit of u, at the last two.
  dvec3 depth(0), before(0), earlier(0);
  double lastU = 0, chance = 0;
  int taken = 0;
  const auto take = [&](Sight::Step& step, double u) {
    step.t = length * u * u;
    step.heightM = std::max(f64::shellHeightAlong(from.heightM, climb, step.t), 0.0);
    step.sunSine =
        std::clamp((r * from.sunSine + step.t * between) / (f64::kEarthRadius + step.heightM), -1.0, 1.0);
    const f64::ShellAir air = f64::shellAirAt(sky_->air_, step.heightM);
    const dvec3 here = air.extinction * (2 * length * u);
    const dvec3 mean = taken < 2 ? 0.5 * (before + here) : (5.0 * here + 8.0 * before - earlier) / 12.0;
    depth += mean * (u - lastU);
    earlier = before;
    before = here;
    lastU = u;
    ++taken;
    return air;
  };
  for (int i = 0; i < kSteps; ++i) {
    Sight::Step& step = sight.steps[static_cast<std::size_t>(i)];
    const double u = (i + offset) / kSteps;
    const f64::ShellAir air = take(step, u);
    step.left = glm::exp(-depth) * (2 * length * u / kSteps);
    const dvec3 scattered = step.left * (air.rayleigh + dvec3(air.haze));
    sight.once += step.left * (air.rayleigh * byAir + dvec3(air.haze * byHaze)) *
                  sky_->sunLight(step.heightM, step.sunSine);
    const dvec3 expected = scattered * sky_->expected(step.heightM, step.sunSine);
    chance += sum(expected * weigh_);
    step.chance = chance;
  }
  Sight::Step& last = sight.steps.back();
  if (sight.meetsGround) {
    take(last, 1);
    last.heightM = 0;
    last.left = glm::exp(-depth);
    const dvec3 sent = last.left * f64::kGroundAlbedo;
    sight.once += sent * sky_->sunLight(0, last.sunSine) * (std::max(last.sunSine, 0.0) / kPi);
    chance += sum(sent * sky_->expected(0, last.sunSine) * weigh_);
  }
  last.chance = chance;
  return sight;
}

// False where nothing is met.
bool ReferencePaths::chooseNext(const Sight& sight, double share, Place& place) const {
  const double all = sight.steps.back().chance;
  if (!(all > 0)) return false;
  const auto found =
      std::upper_bound(sight.steps.begin(), sight.steps.end() - 1, share * all,
                       [](double wanted, const Sight::Step& step) { return wanted < step.chance; });
  const auto i = static_cast<std::size_t>(found - sight.steps.begin());
  const double chance = (sight.steps[i].chance - (i > 0 ? sight.steps[i - 1].chance : 0)) / all;
  if (!(chance > 0)) return false;
  const Sight::Step& step = sight.steps[i];
  place.onGround = i == kSteps;
  place.at = sight.from + sight.direction * step.t;
  place.heightM = step.heightM;
  place.sunSine = step.sunSine;
  place.from = sight.direction;
  place.weight *= step.left / chance;
  return true;
}

// Towards the light that the place scatters next; its weight then has what is scattered from there.
dvec3 ReferencePaths::chooseDirection(Place& place, double share, double azimuth) const {
  const dvec3 up = glm::normalize(place.at);
  dvec3 towards = toSun_ - up * glm::dot(toSun_, up);
  const double level = glm::length(towards);
  towards = level > 1e-9 ? towards / level : turned(up, 0, 0);
  const dvec3 aside = glm::cross(up, towards);
  const bool isLow = place.sunSine < 0.12;
  const bool isDark = place.sunSine < -0.07;
  const Lobe lobe{place.onGround ? 0.0 : -1.0, isDark ? glowSine(place.heightM) : 0.0,
                  isDark  ? 0.04
                  : isLow ? 0.08
                          : 0.2,
                  isDark  ? 0.7
                  : isLow ? 0.6
                          : 0.2};
  // Shares of the ways to choose; the rest is chosen by what the place scatters.
  const double ofLobe = isLow ? 0.4 : 0.25, ofSun = ofLobe + (isDark ? 0.25 : 0.15);
  const dvec3 glow = isDark ? towards : toSun_;
  const double part = (share - ofSun) / (1 - ofSun);
  const f64::ShellAir air = f64::shellAirAt(sky_->air_, place.heightM);
  const double molecules = sum(air.rayleigh) / 3, ofAir = molecules / (molecules + air.haze);
  const double haze = sky_->air_.hazeAnisotropy;
  dvec3 direction;
  if (share < ofLobe) {
    const double sine = lobe.sine(share / ofLobe), a = lobe.azimuth(azimuth);
    direction =
        up * sine + (towards * std::cos(a) + aside * std::sin(a)) * std::sqrt(std::max(1 - sine * sine, 0.0));
  } else if (share < ofSun) {
    direction = turned(glow, henyeyGreensteinCosine((share - ofLobe) / (ofSun - ofLobe), kAroundSun),
                       2 * kPi * azimuth);
  } else if (place.onGround) {
    direction = turned(up, std::sqrt(part), 2 * kPi * azimuth);
  } else {
    const double cosine = part < ofAir ? rayleighCosine(part / ofAir)
                                       : henyeyGreensteinCosine((part - ofAir) / (1 - ofAir), haze);
    direction = turned(place.from, cosine, 2 * kPi * azimuth);
  }
  const double sine = glm::dot(direction, up), across = std::sqrt(std::max(1 - sine * sine, 1e-12));
  const double led =
      ofLobe * lobe.density(sine, std::clamp(glm::dot(direction, towards) / across, -1.0, 1.0)) +
      (ofSun - ofLobe) * f64::henyeyGreenstein(glm::dot(direction, glow), kAroundSun);
  if (place.onGround) {
    const double lambert = std::max(sine, 0.0) / kPi;
    place.weight *= f64::kGroundAlbedo * lambert / std::max(led + (1 - ofSun) * lambert, 1e-300);
    return direction;
  }
  const double between = glm::dot(direction, place.from);
  const double byAir = f64::rayleighPhase(between), byHaze = f64::henyeyGreenstein(between, haze);
  place.weight *= (air.rayleigh * byAir + dvec3(air.haze * byHaze)) /
                  (led + (1 - ofSun) * (ofAir * byAir + (1 - ofAir) * byHaze));
  return direction;
}

dvec3 ReferencePaths::pathOf(Point& point) const {
  Place place = firstPlace(point.next());
  dvec3 light(0);
  for (int order = 2; order < kMostOrders; ++order) {
    const double share = point.next(), azimuth = point.next(), offset = point.next();
    const dvec3 direction = chooseDirection(place, share, azimuth);
    const Sight sight = look(place, direction, offset);
    light += place.weight * sight.once;
    if (!chooseNext(sight, point.next(), place)) break;
    const f64::ShellAir air = f64::shellAirAt(sky_->air_, place.heightM);
    const dvec3 sends = place.onGround ? dvec3(f64::kGroundAlbedo) : air.rayleigh + dvec3(air.haze);
    const double rest = sum(place.weight * sends * sky_->expected(place.heightM, place.sunSine) * weigh_) / 3;
    const double goesOn = point.next();
    if (rest >= kRoulette) continue;
    if (goesOn * kRoulette >= rest) break;
    place.weight *= kRoulette / rest;
  }
  return light;
}

ReferenceEstimate ReferencePaths::upTo(int paths) {
  for (const int wanted = paths / kGroups; ofGroup_ < wanted; ++ofGroup_) {
    for (std::size_t group = 0; group < kGroups; ++group) {
      Point point(core::hashCombine(seed_, group), static_cast<std::uint32_t>(ofGroup_));
      sums_[group] += pathOf(point);
    }
  }
  const dvec3 sum = sums_[0] + sums_[1], apart = sums_[0] - sums_[1];
  const double all = kGroups * static_cast<double>(ofGroup_);
  return {sum / all, glm::abs(apart) / all};
}

}  // namespace skydrop::sky
