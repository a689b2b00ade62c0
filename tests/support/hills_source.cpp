#include "support/hills_source.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace skydrop::test {
namespace {

struct Wave {
  double height, metres, phase;  // amplitude, wavelength along each axis
};
constexpr std::array<Wave, 3> kWaves{{{420, 7680, 0.4}, {90, 1536, 1.1}, {12, 256, 2.0}}};
constexpr double kMeanHeight = 250;
constexpr double kPi = 3.14159265358979323846;

class HillsSource final : public terrain::HeightSource {
 public:
  terrain::HeightSample sample(glm::dvec2 xz) const override {
    terrain::HeightSample s{kMeanHeight, {0.0, 0.0}};
    for (const Wave& w : kWaves) {
      const double k = 2 * kPi / w.metres;
      const double x = std::fmod(xz.x, w.metres) * k + w.phase, z = std::fmod(xz.y, w.metres) * k - w.phase;
      s.height += w.height * std::sin(x) * std::cos(z);
      s.gradient += w.height * k * glm::dvec2(std::cos(x) * std::cos(z), -std::sin(x) * std::sin(z));
    }
    return s;
  }

  terrain::HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    const glm::dvec2 middle = 0.5 * (lo + hi), half = 0.5 * (hi - lo);
    terrain::HeightBounds b{kMeanHeight, kMeanHeight};
    for (const Wave& w : kWaves) {
      const double k = 2 * kPi / w.metres;
      const double x = std::fmod(middle.x, w.metres) * k + w.phase,
                   z = std::fmod(middle.y, w.metres) * k - w.phase;
      const double here = w.height * std::sin(x) * std::cos(z);
      const double change = w.height * k * std::sqrt(half.x * half.x + half.y * half.y);
      b.lowest += std::max(here - change, -w.height);
      b.highest += std::min(here + change, w.height);
    }
    return b;
  }

  terrain::HeightBounds range() const override {
    double sum = 0;
    for (const Wave& w : kWaves) sum += w.height;
    return {kMeanHeight - sum, kMeanHeight + sum};
  }
};

}  // namespace

std::shared_ptr<const terrain::HeightSource> makeHillsSource() { return std::make_shared<HillsSource>(); }

}  // namespace skydrop::test
