#include "support/hunt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "skydrop/core/hash.h"

namespace skydrop::test {
namespace {

constexpr float kEndless = std::numeric_limits<float>::infinity();
constexpr float kLeastNormal = std::numeric_limits<float>::min();
constexpr float kLeast = std::numeric_limits<float>::denorm_min();

float within(const HuntDomain& domain, float value) {
  const float low = static_cast<float>(domain.low), high = static_cast<float>(domain.high);
  return std::clamp(value, low, high);
}

float movedByUlp(float value, int ulps) {
  for (; ulps > 0; --ulps) value = std::nextafter(value, kEndless);
  for (; ulps < 0; ++ulps) value = std::nextafter(value, -kEndless);
  return value;
}

// A value at an edge of something: of the format, of the domain, of the code.
float edge(const HuntDomain& domain, core::RandomStream& random) {
  static constexpr std::array<float, 18> kPlain = {
      0, -0.0f, kLeast, -kLeast, kLeastNormal, -kLeastNormal, 1e-30f, -1e-30f, 1e-15f,
      1, -1,    0.5f,   2,       1e7f,         1e15f,         1e30f,  -1e30f,  1e-7f};
  const std::size_t count = kPlain.size() + 2 + domain.thresholds.size();
  const std::size_t which = random.next() % count;
  float value = which < kPlain.size()        ? kPlain[which]
                : which == kPlain.size()     ? static_cast<float>(domain.low)
                : which == kPlain.size() + 1 ? static_cast<float>(domain.high)
                                             : domain.thresholds[which - kPlain.size() - 2];
  return within(domain, movedByUlp(value, static_cast<int>(random.next() % 7) - 3));
}

float realValue(const HuntDomain& domain, core::RandomStream& random, const HuntInput& before) {
  const std::uint64_t way = random.next() % 20;
  if (way < 6) return edge(domain, random);
  if (way < 11) {  // any size
    const double size = std::pow(10.0, random.nextUnit() * 60 - 30);
    const double low = domain.low < 0 && (domain.high <= 0 || random.next() % 2 == 0) ? -size : size;
    return within(domain, static_cast<float>(low));
  }
  if (way < 13 && !before.empty()) {  // like another argument
    float value = before[random.next() % before.size()];
    if (random.next() % 4 == 0) value = -value;
    return within(domain, movedByUlp(value, static_cast<int>(random.next() % 5) - 2));
  }
  if (way < 15 && domain.high - domain.low > 1e6) {  // of the sizes of a flight
    const double value = (random.nextUnit() * 2 - 1) * std::pow(10.0, random.nextUnit() * 7);
    return within(domain, static_cast<float>(value));
  }
  return within(domain, static_cast<float>(domain.low + (domain.high - domain.low) * random.nextUnit()));
}

void addDirection(HuntInput& input, core::RandomStream& random) {
  std::array<double, 3> v{};
  for (double& c : v) {
    const std::uint64_t way = random.next() % 4;
    c = way == 0 ? 0 : way == 1 ? std::pow(10.0, -30 * random.nextUnit()) : random.nextUnit();
    if (random.next() % 2 == 0) c = -c;
  }
  double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  if (length == 0) v[1] = length = 1;
  for (const double c : v) input.push_back(static_cast<float>(c / length));
}

std::string numberText(float value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", static_cast<double>(value));
  return text;
}

std::string problem(const char* what, std::size_t result, double actual, double expected) {
  char text[160];
  std::snprintf(text, sizeof text, "r[%zu] = %.9g %s %.9g", result, actual, what, expected);
  return text;
}

using Doubles = std::array<double, kMostHuntArguments>;
using Results = std::array<double, kMostHuntResults>;

}  // namespace

HuntInput huntInput(const HuntedFunction& function, std::uint64_t seed, std::uint64_t number) {
  std::uint64_t name = 0;
  for (const char* c = function.name; *c != 0; ++c) name = name * 131 + static_cast<unsigned char>(*c);
  core::RandomStream random{core::hashCombine(core::hashCombine(seed, name), number), 0};
  HuntInput input;
  while (input.size() < function.arguments.size()) {
    const HuntDomain& domain = function.arguments[input.size()];
    if (domain.kind == HuntDomain::Kind::direction) {
      addDirection(input, random);
    } else if (domain.kind == HuntDomain::Kind::whole) {
      const std::uint64_t way = random.next() % 5;
      const double value = way == 0 ? domain.low
                           : way == 1
                               ? domain.high
                               : domain.low + std::floor((domain.high - domain.low + 1) * random.nextUnit());
      input.push_back(static_cast<float>(std::min(value, domain.high)));
    } else {
      input.push_back(realValue(domain, random, input));
    }
  }
  return input;
}

std::string huntFault(const HuntedFunction& function, std::span<const float> input,
                      std::span<const float> actual, double room) {
  Doubles a{};
  std::copy(input.begin(), input.end(), a.begin());
  Results exact{};
  function.inDouble(a.data(), exact.data());
  Results least = exact, most = exact;
  bool isSpread = false;
  for (std::size_t k = 0; k < function.results.size(); ++k) {
    const HuntRange& range = function.results[k];
    const double value = static_cast<double>(actual[k]);
    if (!std::isfinite(value)) return problem("is not finite; in double", k, value, exact[k]);
    const double margin = 1e-6 * std::max(std::abs(range.low), std::abs(range.high));
    if (value < range.low - margin) return problem("lies below", k, value, range.low);
    if (value > range.high + margin) return problem("lies above", k, value, range.high);
    if (!std::isfinite(exact[k])) return problem("in float, in double", k, value, exact[k]);
    const double tolerance = room + range.abs + range.rel * std::abs(exact[k]);
    if (std::abs(value - exact[k]) <= tolerance) continue;
    if (!isSpread) {
      isSpread = true;
      // Each argument moved by itself; what it changes is added up, upwards and downwards.
      Results up{}, down{};
      for (std::size_t i = 0; i < input.size(); ++i) {
        if (function.arguments[i].kind == HuntDomain::Kind::whole) continue;
        Results high = exact, low = exact;
        for (const int ulps : {-kSlackUlp, -1, 1, kSlackUlp, 0}) {
          Doubles moved = a;
          // 0: a processor may take denormal numbers for 0.
          moved[i] = ulps == 0 ? (std::abs(input[i]) < kLeastNormal * 4 ? 0.0 : a[i])
                               : static_cast<double>(movedByUlp(input[i], ulps));
          if (function.arguments[i].kind != HuntDomain::Kind::direction) {
            moved[i] = std::clamp(moved[i], function.arguments[i].low, function.arguments[i].high);
          }
          Results there{};
          function.inDouble(moved.data(), there.data());
          for (std::size_t j = 0; j < there.size(); ++j) {
            high[j] = std::max(high[j], there[j]);
            low[j] = std::min(low[j], there[j]);
          }
        }
        for (std::size_t j = 0; j < up.size(); ++j) {
          up[j] += high[j] - exact[j];
          down[j] += exact[j] - low[j];
        }
      }
      for (std::size_t j = 0; j < up.size(); ++j) {
        most[j] += up[j];
        least[j] -= down[j];
      }
    }
    const double size = std::max({std::abs(exact[k]), std::abs(most[k]), std::abs(least[k])});
    const double widened = room + range.abs + range.rel * size;
    if (!(value <= most[k] + widened && value >= least[k] - widened))
      return problem("is not that of double,", k, value, exact[k]);
  }
  return {};
}

HuntInput shrunk(const HuntedFunction& function, HuntInput input,
                 const std::function<bool(std::span<const float>)>& fails) {
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < input.size(); ++i) {
      const HuntDomain& domain = function.arguments[i];
      bool isOfDirection = false;  // whose length is to stay 1
      for (std::size_t back = 0; back <= std::min<std::size_t>(i, 2); ++back)
        isOfDirection |= function.arguments[i - back].kind == HuntDomain::Kind::direction;
      if (isOfDirection) continue;
      std::vector<float> plainer = {0,  1,   static_cast<float>(domain.low), static_cast<float>(domain.high),
                                    -1, 0.5f};
      const float value = input[i];
      if (value != 0 && std::isfinite(value)) {
        for (const int digits : {0, 1, 2, 3}) {
          char text[40];
          std::snprintf(text, sizeof text, "%.*e", digits, static_cast<double>(value));
          plainer.push_back(std::strtof(text, nullptr));
        }
      }
      for (const float candidate : plainer) {
        if (candidate == value) break;
        if (domain.kind == HuntDomain::Kind::whole && candidate != std::floor(candidate)) continue;
        if (!(candidate >= static_cast<float>(domain.low) && candidate <= static_cast<float>(domain.high)))
          continue;
        HuntInput tried = input;
        tried[i] = candidate;
        if (!fails(tried)) continue;
        input = tried;
        break;
      }
    }
  }
  return input;
}

std::string huntText(const HuntedFunction& function, std::span<const float> input) {
  std::string text = std::string(function.name) + "(";
  for (std::size_t i = 0; i < input.size(); ++i) text += (i > 0 ? ", " : "") + numberText(input[i]);
  return text + ")";
}

HuntFinding hunt(const HuntedFunction& function, std::uint64_t seed, std::uint64_t from, std::uint64_t to) {
  const auto faultOf = [&](std::span<const float> input) {
    std::array<float, kMostHuntArguments> a{};
    std::copy(input.begin(), input.end(), a.begin());
    std::array<float, kMostHuntResults> r{};
    function.inFloat(a.data(), r.data());
    return huntFault(function, input, r);
  };
  HuntFinding finding;
  for (std::uint64_t number = from; number < to; ++number) {
    const HuntInput input = huntInput(function, seed, number);
    if (faultOf(input).empty()) continue;
    if (finding.faults++ > 0) continue;
    finding.first = number;
    const HuntInput plain =
        shrunk(function, input, [&](std::span<const float> tried) { return !faultOf(tried).empty(); });
    finding.text = huntText(function, plain) + ": " + faultOf(plain) + " (seed " + std::to_string(seed) +
                   ", number " + std::to_string(number) + ")";
  }
  return finding;
}

std::uint64_t huntedInputs(std::uint64_t usual) {
  const char* asked = std::getenv("SKYDROP_HUNT");
  return asked ? std::strtoull(asked, nullptr, 10) : usual;
}

}  // namespace skydrop::test
