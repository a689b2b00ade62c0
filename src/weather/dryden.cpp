#include "skydrop/weather/dryden.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/hash.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

constexpr double kSqrt3 = 1.7320508075688772;
constexpr double kLowestFt = 10, kLowToFt = 1000, kHighFromFt = 2000, kHighLengthFt = 1750;

// MIL-F-8785C, figure 7: intensity, ft/s, by height, ft, and the exponent of the probability of exceedance.
constexpr std::array<double, 12> kHeightsFt = {500,   1750,  3750,  7500,  15000, 25000,
                                               35000, 45000, 55000, 65000, 75000, 80000};
constexpr std::array<double, 7> kExponents = {0.69897, 1, 2, 3, 4, 5, 6};
constexpr double kIntensitiesFtS[7][12] = {
    {3.2, 2.2, 1.5, 0, 0, 0, 0, 0, 0, 0, 0, 0},
    {4.2, 3.6, 3.3, 1.6, 0, 0, 0, 0, 0, 0, 0, 0},
    {6.6, 6.9, 7.4, 6.7, 4.6, 2.7, 0.4, 0, 0, 0, 0, 0},
    {8.6, 9.6, 10.6, 10.1, 8.0, 6.6, 5.0, 4.2, 2.7, 0, 0, 0},
    {11.8, 13.0, 16.0, 15.1, 11.6, 9.7, 8.1, 8.2, 7.9, 4.9, 3.2, 2.1},
    {15.6, 17.6, 23.0, 23.6, 22.1, 20.0, 16.0, 15.1, 12.1, 7.9, 6.2, 5.1},
    {18.7, 21.5, 28.4, 30.2, 30.7, 31.0, 25.2, 23.1, 17.5, 10.7, 8.4, 7.2}};

double between(double a, double b, double t) { return a + (b - a) * t; }

// Where a value lies in an ascending list: the entry before it, and the share of the way to the next.
template <std::size_t N>
std::size_t placeIn(const std::array<double, N>& list, double value, double& share) {
  std::size_t i = 0;
  while (i + 2 < N && value >= list[i + 1]) ++i;
  share = std::clamp((value - list[i]) / (list[i + 1] - list[i]), 0.0, 1.0);
  return i;
}

// 1 - e^-x (1 + x) and 1 - e^-x (1 + x + x^2/2), x >= 0: as they stand they lose all digits for small x.
double gamma2(double x, double decay) {
  if (x > 0.5) return 1 - decay * (1 + x);
  double sum = 0, term = x * x / 2;
  for (int k = 3; k < 18; ++k) sum += term, term *= x / k;
  return decay * sum;
}
double gamma3(double x, double decay) {
  if (x > 0.5) return 1 - decay * (1 + x + x * x / 2);
  double sum = 0, term = x * x * x / 6;
  for (int k = 4; k < 19; ++k) sum += term, term *= x / k;
  return decay * sum;
}

// The transverse filter in units of its time L/V: z1' = -z1 + n, z2' = -z2 + z1, v = sqrt(3) z1 + (1 -
// sqrt(3)) z2, with stationary covariance [1/2 1/4; 1/4 1/4] and v's variance 1. Over a time a the noise has
// the covariance P - F P F^T, F the transition.
DrydenStep::Transverse transverse(double a) {
  if (!(a > 0)) return {};
  const double keep = dmath::exp(-a), decay = keep * keep, x = 2 * a;
  const double q11 = x > 0.5 ? (1 - decay) / 2 : decay * [x] {
    double sum = 0, term = x / 2;
    for (int k = 2; k < 17; ++k) sum += term, term *= x / k;
    return sum;
  }();
  const double q12 = gamma2(x, decay) / 4, q22 = gamma3(x, decay) / 4;
  DrydenStep::Transverse step{keep, a * keep, std::sqrt(q11), 0, 0};
  step.noise21 = q12 / step.noise11;
  step.noise22 = std::sqrt(std::max(q22 - step.noise21 * step.noise21, 0.0));
  return step;
}

void advance(double* z, const DrydenStep::Transverse& step, double first, double second) {
  const double z1 = z[0];
  z[0] = step.keep * z1 + step.noise11 * first;
  z[1] = step.keep * z[1] + step.feed * z1 + step.noise21 * first + step.noise22 * second;
}

double outputOf(const double* z) { return kSqrt3 * z[0] + (1 - kSqrt3) * z[1]; }

}  // namespace

double exceededIntensity(double heightM, double severity) {
  if (!(severity > 0)) return 0;
  double acrossHeights = 0, acrossExponents = 0;
  const std::size_t column = placeIn(kHeightsFt, heightM / kFootM, acrossHeights);
  const auto row = [&](std::size_t i) {
    return between(kIntensitiesFtS[i][column], kIntensitiesFtS[i][column + 1], acrossHeights);
  };
  if (severity < kExponents.front()) return row(0) * (severity / kExponents.front()) * kFootM;
  const std::size_t i = placeIn(kExponents, severity, acrossExponents);
  return between(row(i), row(i + 1), acrossExponents) * kFootM;
}

DrydenScales drydenScales(double aboveGroundM, double w20Mps, double severity) {
  const double height = std::isfinite(aboveGroundM) ? std::max(aboveGroundM / kFootM, kLowestFt) : kLowestFt;
  const auto low = [&](double h) {
    const double ratio = 0.177 + 0.000823 * h;
    const double sigmaW = 0.1 * w20Mps, sigma = sigmaW / dmath::pow(ratio, 0.4);
    const double length = h / dmath::pow(ratio, 1.2) * kFootM;
    return DrydenScales{{sigma, sigma, sigmaW}, {length, length, h * kFootM}};
  };
  const auto high = [&](double h) {
    return DrydenScales{glm::dvec3(exceededIntensity(h * kFootM, severity)),
                        glm::dvec3(kHighLengthFt * kFootM)};
  };
  if (height <= kLowToFt) return low(height);
  if (height >= kHighFromFt) return high(height);
  const double t = (height - kLowToFt) / (kHighFromFt - kLowToFt);
  const DrydenScales below = low(kLowToFt), above = high(kHighFromFt);
  return {below.intensityMps + (above.intensityMps - below.intensityMps) * t,
          below.lengthM + (above.lengthM - below.lengthM) * t};
}

double whiteNoise(std::uint64_t bits) {
  // Four numbers of 16 bits: mean 2 (2^16 - 1), variance 4 (2^32 - 1) / 12.
  constexpr double kScale = 2.6428997921303018e-05;  // sqrt(3 / (2^32 - 1))
  const double sum =
      static_cast<double>((bits & 0xffff) + (bits >> 16 & 0xffff) + (bits >> 32 & 0xffff) + (bits >> 48));
  return (sum - 131070) * kScale;
}

DrydenStep::DrydenStep(const DrydenScales& scales, double airspeedMps, double seconds) {
  const double way = airspeedMps > 0 && seconds > 0 ? airspeedMps * seconds : 0;  // frozen air (Taylor 1938)
  const double a = way / scales.lengthM.x;
  keepU = dmath::exp(-a);
  const double lost = 1 - keepU * keepU;
  noiseU = std::sqrt(a < 1e-8 ? 2 * a : lost);
  v = transverse(way / scales.lengthM.y);
  w = scales.lengthM.z == scales.lengthM.y ? v : transverse(way / scales.lengthM.z);
}

Dryden::Dryden(std::uint64_t seed) : seed_(core::hashCombine(seed, 0x647279646eull)) {
  core::RandomStream random{core::mix64(seed_), 0};
  const auto noise = [&] { return whiteNoise(random.next()); };
  // The stationary covariance: 1 of u, [1/2 1/4; 1/4 1/4] of the others.
  states_[0] = noise();
  for (double* z : {states_ + 1, states_ + 3}) {
    const double first = noise(), second = noise();
    z[0] = std::sqrt(0.5) * first;
    z[1] = std::sqrt(0.125) * first + std::sqrt(0.125) * second;
  }
}

void Dryden::advance(const DrydenStep& change, std::uint64_t step) {
  core::RandomStream random{seed_, step * kStates};
  states_[0] = change.keepU * states_[0] + change.noiseU * whiteNoise(random.next());
  for (const auto& [z, transverse] : {std::pair(states_ + 1, &change.v), std::pair(states_ + 3, &change.w)}) {
    const double first = whiteNoise(random.next()), second = whiteNoise(random.next());
    weather::advance(z, *transverse, first, second);
  }
}

glm::dvec3 Dryden::gust() const { return {states_[0], outputOf(states_ + 1), outputOf(states_ + 3)}; }

}  // namespace skydrop::weather
