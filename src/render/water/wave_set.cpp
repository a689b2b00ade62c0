#include "render/water/wave_set.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "skydrop/core/hash.h"
#include "skydrop/core/shared_sea.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f64;

constexpr double kLongestM = 40;                              // of the first octave
constexpr double kLeastBreakingM = 0.5, kMostBreakingM = 14;  // lengths whose crests break
constexpr double kLeastCausticM = 0.4;                        // shorter waves gather light too near to see
constexpr double kNarrowM = 2;
constexpr std::uint64_t kSeed = 0x5ea;

double wrapped(double turns) { return turns - std::floor(turns); }

struct Wave {
  glm::dvec2 along{0};  // unit
  double lengthM = 0, phase = 0;
  double variance = 0;  // of the slope, both axes
};

// Waves that this wind raises, the longest first. Lengths of an octave are spread over it, directions over
// the circle; those that run against the wind are left out, and weights go to 0 before that, so none comes at
// once.
std::vector<Wave> raised(const WaterDetailSettings& settings, const glm::dvec2& wind) {
  std::vector<Wave> waves;
  const double speed = glm::length(wind);
  const double downwind = speed > 0 ? std::atan2(wind.y, wind.x) : 0;
  const auto perOctave = static_cast<std::size_t>(settings.wavesPerOctave);
  std::vector<double> weights;
  for (int octave = 0;; ++octave) {
    core::RandomStream random{core::hashCombine(kSeed, static_cast<std::uint64_t>(octave)), 0};
    const double longest = kLongestM * std::exp2(-octave);
    if (longest < settings.shortestM) break;
    const double variance = shared::octaveVariance(longest / std::numbers::sqrt2, speed);
    const double turn = random.nextUnit();
    double sum = 0;
    std::vector<Wave> group;
    weights.clear();
    for (std::size_t i = 0; i < perOctave; ++i) {
      Wave wave;
      const double share = (static_cast<double>(i) + random.nextUnit()) / static_cast<double>(perOctave);
      wave.lengthM = longest * std::exp2(-share);
      wave.phase = random.nextUnit();
      // By the golden section: neighbours in length come from far apart.
      const double angle =
          2 * std::numbers::pi *
          wrapped(turn + static_cast<double>(i) * 0.6180339887498949 + 0.06 * (random.nextUnit() - 0.5));
      wave.along = {std::cos(angle), std::sin(angle)};
      const double ahead = std::max(std::cos(angle - downwind), 0.0);
      const double weight = longest > kNarrowM ? ahead * ahead : ahead;  // long waves run closer to the wind
      if (weight <= 1e-3) continue;
      weights.push_back(weight);
      sum += weight;
      group.push_back(wave);
    }
    for (std::size_t i = 0; i < group.size(); ++i) {
      group[i].variance = variance * weights[i] / sum;
      if (group[i].lengthM >= settings.shortestM && group[i].variance > 1e-9) waves.push_back(group[i]);
    }
  }
  std::ranges::sort(waves, std::greater{}, &Wave::lengthM);
  if (waves.size() > SeaWaves::kMost) waves.resize(SeaWaves::kMost);
  return waves;
}

}  // namespace

SeaWaves seaWaves(const WaterDetailSettings& settings, const glm::dvec2& eye, double seconds,
                  const glm::dvec2& wind) {
  const double speed = std::min(glm::length(wind), 40.0);
  const glm::dvec2 blows = speed > 0 ? wind * (speed / glm::length(wind)) : glm::dvec2(0);
  const std::vector<Wave> waves = raised(settings, blows);
  double breaking = 0;
  const auto breaks = [](const Wave& w) {
    return w.lengthM >= kLeastBreakingM && w.lengthM <= kMostBreakingM;
  };
  for (const Wave& wave : waves) breaking += breaks(wave) ? wave.variance : 0;

  SeaWaves sea;
  for (const Wave& wave : waves) {
    const double turnsPerMetre = 1 / wave.lengthM;
    const double ahead = wrapped(glm::dot(wave.along, eye) * turnsPerMetre);
    const double behind = wrapped(shared::waveTurnsPerSecond(wave.lengthM) * seconds);
    const double slope = std::sqrt(wave.variance / shared::kProfileVariance);
    const double perLength = 2 * std::numbers::pi * turnsPerMetre;
    sea.ways[sea.count] = glm::vec4(wave.along.x * turnsPerMetre, wave.along.y * turnsPerMetre,
                                    wrapped(ahead - behind + wave.phase), slope);
    sea.shapes[sea.count] = glm::vec4(
        wave.lengthM, breaks(wave) ? std::sqrt(wave.variance / breaking / shared::kProfileVariance) : 0.0,
        perLength, 0);
    if (wave.lengthM >= kLeastCausticM) {
      sea.causticCount = sea.count + 1;
      sea.curvatureVariance += perLength * perLength * wave.variance;
    }
    ++sea.count;
  }
  sea.slope = std::sqrt(0.5 * shared::seaSlopeVariance(speed));
  // Where no wave breaks there are no whitecaps either.
  sea.threshold =
      breaking > 0 && settings.foam > 0 ? shared::normalQuantile(shared::whitecapShare(speed)) : -8;
  sea.surfClock = wrapped(seconds / shared::kSurfSeconds);
  sea.foam = settings.foam;
  sea.turbidity = settings.turbidity;
  sea.caustics = settings.caustics;
  return sea;
}

}  // namespace skydrop::render
