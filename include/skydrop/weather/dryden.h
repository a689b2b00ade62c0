// Turbulence after Dryden in the form of MIL-F-8785C (1980), 3.7.2 and 3.7.3: white noise through filters
// whose output has the spectra
//
//   longitudinal   S(w) = s^2 2L/(pi V)                       / (1 + (L w/V)^2)
//   transverse     S(w) = s^2  L/(pi V) (1 + 3 (L w/V)^2)     / (1 + (L w/V)^2)^2
//
// of angular frequency w >= 0, with intensity s (standard deviation), scale length L and airspeed V. The
// filters are advanced by their exact state transition, with noise of the exact covariance (van Loan 1978 in
// closed form), so that variance and spectrum hold for steps of any length. Deterministic; the noise is
// hashed from seed and step, so that a replay or another frame rate meets the same gusts.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

namespace skydrop::weather {

inline constexpr double kFootM = 0.3048;

// Longitudinal (u), lateral (v) and vertical (w).
struct DrydenScales {
  glm::dvec3 intensityMps{0};  // standard deviations of u, v, w
  glm::dvec3 lengthM{533.4};   // scale lengths of u, v, w; > 0
};

// By the height above the ground, m, the wind 20 feet above it, m/s, and the severity of the air above
// (State::turbulenceSeverity). Below 1000 feet by height and wind (figures 10 and 11), above 2000 feet 1750
// feet long and with the intensity of figure 7 for the severity, between linear. Heights count from 10 feet
// on.
DrydenScales drydenScales(double aboveGroundM, double w20Mps, double severity);

// The intensity of figure 7, m/s: linear between its heights and probabilities, 0 for a severity of 0.
double exceededIntensity(double heightM, double severity);

// Uniform bits summed to noise of mean 0 and variance 1 (four terms: what the filters make of hundreds of
// them is Gaussian).
double whiteNoise(std::uint64_t bits);

// What a step changes, the same for all steps of a length at an airspeed.
struct DrydenStep {
  DrydenStep() = default;  // none
  DrydenStep(const DrydenScales& scales, double airspeedMps, double seconds);

  double keepU = 1, noiseU = 0;
  struct Transverse {
    double keep = 1, feed = 0;                     // of the state itself, and from the first into the second
    double noise11 = 0, noise21 = 0, noise22 = 0;  // Cholesky factor of the noise's covariance
  };
  Transverse v, w;
};

class Dryden {
 public:
  // Begins in the stationary state, drawn from the seed.
  explicit Dryden(std::uint64_t seed);

  // Advances by one step, number `step`.
  void advance(const DrydenStep& change, std::uint64_t step);

  // u, v and w in units of their intensities: variance 1.
  glm::dvec3 gust() const;

  // The filters' states, for a digest.
  const double* states() const { return states_; }
  static constexpr int kStates = 5;

 private:
  std::uint64_t seed_;
  double states_[kStates] = {};  // u; v's two; w's two
};

}  // namespace skydrop::weather
