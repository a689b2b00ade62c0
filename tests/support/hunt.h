// A hunt for inputs at which a function of shaders/shared fails: each is run in float, in double and (by
// tests/gl) as GLSL over the whole of its contract, most often at its edges. Inputs follow from a seed and a
// number, so a failure names what brings it back. docs/hunt.md tells what was hunted, how long, and what was
// found.
//
// What must hold of every result:
//  - it is finite and in the range that the table states;
//  - it is that of double within `abs` + `rel` times its size, or lies among the results that double has for
//    inputs no more than kSlackUlp units in the last place away: a function need not be better than its
//    inputs are known, and must not be worse (backward stability: Higham, "Accuracy and Stability of
//    Numerical Algorithms", 2002, section 1.5).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace skydrop::test {

inline constexpr std::size_t kMostHuntArguments = 16, kMostHuntResults = 4;
inline constexpr int kSlackUlp = 4;  // of float

// What an argument may be, by the contract of the function.
struct HuntDomain {
  enum class Kind { real, whole, direction };
  double low = 0, high = 1;
  Kind kind = Kind::real;         // a direction is a unit vector of this and the next two arguments
  std::vector<float> thresholds;  // of the code: places at which it goes another way
};
inline HuntDomain in(double low, double high, std::vector<float> thresholds = {}) {
  return {low, high, HuntDomain::Kind::real, std::move(thresholds)};
}
inline HuntDomain unit(std::vector<float> thresholds = {}) { return in(0, 1, std::move(thresholds)); }
inline HuntDomain signedUnit() { return in(-1, 1); }
inline HuntDomain whole(double low, double high) { return {low, high, HuntDomain::Kind::whole, {}}; }
// Three of them in a row stand for one unit vector.
inline HuntDomain direction() { return {-1, 1, HuntDomain::Kind::direction, {}}; }

// What a result is by the contract, and how far float may be from double.
struct HuntRange {
  double low = 0, high = 1;
  double rel = 1e-5, abs = 1e-6;
};
inline HuntRange out(double low, double high, double rel = 1e-5, double abs = 1e-6) {
  return {low, high, rel, abs};
}
inline HuntRange share(double abs = 1e-5) { return {0, 1, 0, abs}; }

struct HuntedFunction {
  const char* name;
  std::vector<HuntDomain> arguments;
  std::vector<HuntRange> results;
  void (*inFloat)(const float* a, float* r);
  void (*inDouble)(const double* a, double* r);
  const char* glsl;  // the same statements
};

// All that are hunted.
const std::vector<HuntedFunction>& huntedFunctions();

using HuntInput = std::vector<float>;

// Input `number` of a function under a seed, within its domains.
HuntInput huntInput(const HuntedFunction& function, std::uint64_t seed, std::uint64_t number);

// Why a result is wrong, or empty. `actual`: of the function in float, wherever it ran; `room` is added to
// each `abs`.
std::string huntFault(const HuntedFunction& function, std::span<const float> input,
                      std::span<const float> actual, double room = 0);

// A failing input whose numbers are as plain as they can be: each in turn is replaced by 0, 1, an end of its
// domain or fewer digits while it still fails.
HuntInput shrunk(const HuntedFunction& function, HuntInput input,
                 const std::function<bool(std::span<const float>)>& fails);

// "oneMinusExpOverX(0.5)", every number exact.
std::string huntText(const HuntedFunction& function, std::span<const float> input);

struct HuntFinding {
  std::uint64_t faults = 0;
  std::uint64_t first = 0;  // number of the first that fails
  std::string text;         // of that, made plain, and what is wrong with it
};
// The function in float over inputs [from, to) of a seed.
HuntFinding hunt(const HuntedFunction& function, std::uint64_t seed, std::uint64_t from, std::uint64_t to);

// $SKYDROP_HUNT, or `usual`: how many inputs of each function are tried.
std::uint64_t huntedInputs(std::uint64_t usual);

}  // namespace skydrop::test
