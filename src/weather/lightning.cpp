#include "skydrop/weather/lightning.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/hash.h"

namespace skydrop::weather {
namespace {

namespace dmath = core::dmath;

constexpr double kLatticeM = 2 * kLightningSightM;
constexpr double kMostPerMinute = 31;  // more would be more than one in each slot

// A flash is out after so many decays of its last stroke, and then wholly.
constexpr double kDecays = 6;
constexpr double kRiseS = 0.004, kSoftRiseS = 0.1, kSoftDecayS = 0.08, kSoftPeak = 0.25;
static_assert(kDecays * (kFlashDecayS + kSoftDecayS) <= kLongestFadeS + 1e-9);
static_assert(kFlashStartS + kFlashStrokesS + kLongestFadeS < kFlashSlotS);

// Where charge lies in a storm: strokes to ground come from the main negative region in the lower third,
// flashes within the cloud join it with the positive one above (Rakov and Uman 2003, chapter 3).
constexpr double kLowCharge = 0.3, kHighCharge = 0.7;

std::optional<Layer> stormCloud(const State& state) {
  std::optional<Layer> best;
  for (const Layer& layer : state.layers) {
    if (!(layer.cover > 0)) continue;
    if (layer.genus == Genus::cumulonimbus) return layer;
    if (!best || layer.topM - layer.baseM > best->topM - best->baseM) best = layer;
  }
  return best;
}

double between(core::RandomStream& random, double a, double b) { return a + (b - a) * random.nextUnit(); }

Flash flashOf(const Layer& cloud, const LightningSettings& settings, const glm::dvec2& place, double slotS,
              core::RandomStream random) {
  Flash flash;
  flash.seconds = slotS + kFlashStartS * random.nextUnit();
  flash.seed = random.next();
  flash.toGround = random.nextUnit() < settings.groundShare;
  flash.cloudBaseM = cloud.baseM;
  const double depth = cloud.topM - cloud.baseM;
  const auto heightAt = [&](double share) { return cloud.baseM + depth * share; };
  const double azimuth = dmath::kTwoPi * random.nextUnit();
  const double aside = flash.toGround ? between(random, 0, 1500) : between(random, 2000, 6000);
  const glm::dvec2 end = place + aside * glm::dvec2(dmath::cos(azimuth), dmath::sin(azimuth));
  const double low = kLowCharge * between(random, 0.6, 1.2);
  flash.from = {place.x, heightAt(low), place.y};
  flash.to = {end.x, flash.toGround ? 0 : heightAt(kHighCharge * between(random, 0.5, 1.1)), end.y};
  // Logarithms evenly: a few are much brighter than most.
  flash.strength = dmath::exp(between(random, -0.69, 0.69));
  flash.strokeCount = 1 + static_cast<std::size_t>(random.next() % kMostStrokes);
  double after = 0, share = 1;
  for (std::size_t i = 0; i < flash.strokeCount; ++i) {
    flash.strokes[i] = {after, share};
    after += between(random, 0.06, kFlashStrokesS / (kMostStrokes - 1));
    share = between(random, 0.4, 0.8);
  }
  return flash;
}

// Shape of one stroke's light, 1 near its peak.
double pulse(double sinceS, double riseS, double decayS) {
  if (!(sinceS > 0) || sinceS >= kDecays * decayS) return 0;
  const double end = dmath::exp(-kDecays);
  const double falling = (dmath::exp(-sinceS / decayS) - end) / (1 - end);
  return falling * (1 - dmath::exp(-sinceS / riseS));
}

}  // namespace

void describe(core::SettingsVisitor& visitor, LightningSettings& settings) {
  visitor.number(
      "groundShare", settings.groundShare,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "How many of the flashes strike the ground; at 0 all stay in their clouds. How many "
               "there are, the weather says (flashes a minute).",
       .aliases = "lightning, cloud to ground, strokes, bolt"});
  visitor.number("brightness", settings.brightness,
                 {.unit = "1",
                  .min = 0,
                  .max = 4,
                  .help = "Light of the flashes, against that of usual ones.",
                  .aliases = "lightning, intensity"});
  visitor.number(
      "softness", settings.softness,
      {.unit = "1",
       .min = 0,
       .max = 1,
       .help = "Softens flashes: at 1 each is a single slow glow with a quarter of the peak. There are never "
               "more than three bright moments a second.",
       .aliases = "lightning, photosensitivity, epilepsy, accessibility, strobe"});
}

std::vector<Flash> flashesBetween(const Moment& moment, const LightningSettings& settings, double from,
                                  double to, const glm::dvec2& place) {
  std::vector<Flash> all;
  if (!moment || !(to > from)) return all;
  const double first = std::floor((from - kFlashStartS) / kFlashSlotS), last = std::floor(to / kFlashSlotS);
  for (double slot = first; slot <= last; ++slot) {
    const std::uint64_t ofSlot =
        core::hashCombine(core::hashCombine(moment.seed, 0x6c69676874ull),
                          static_cast<std::uint64_t>(static_cast<std::int64_t>(slot)));
    core::RandomStream offset{ofSlot};
    const glm::dvec2 origin{kLatticeM * offset.nextUnit(), kLatticeM * offset.nextUnit()};
    const glm::dvec2 relative = place - origin;
    const auto lowest = [](double x) { return std::ceil((x - kLightningSightM) / kLatticeM); };
    const auto highest = [](double x) { return std::floor((x + kLightningSightM) / kLatticeM); };
    for (double i = lowest(relative.x); i <= highest(relative.x); ++i) {
      for (double j = lowest(relative.y); j <= highest(relative.y); ++j) {
        const glm::dvec2 at = origin + kLatticeM * glm::dvec2(i, j);
        const glm::dvec2 way = at - place;
        if (glm::dot(way, way) >= kLightningSightM * kLightningSightM) continue;
        const auto bits = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(x)); };
        core::RandomStream random{core::hashCombine(core::hashCombine(ofSlot, bits(i)), bits(j))};
        const double drawn = random.nextUnit();
        // Of all points of the lattice so many are within sight of a place, in the mean.
        constexpr double kInSight = dmath::kPi / 4;
        constexpr double kPerFlashAMinute = kFlashSlotS / 60 / kInSight;
        if (drawn >= kPerFlashAMinute * kMostPerMinute) continue;
        const double slotS = slot * kFlashSlotS;
        Moment then = moment;
        then.seconds = slotS;
        const State state = then.at(at);
        if (drawn >= kPerFlashAMinute * state.lightningPerMinute) continue;
        const std::optional<Layer> cloud = stormCloud(state);
        if (!cloud) continue;
        const Flash flash = flashOf(*cloud, settings, at, slotS, random);
        if (flash.seconds > from && flash.seconds <= to) all.push_back(flash);
      }
    }
  }
  return all;
}

std::vector<Flash> flashesShining(const Moment& moment, const LightningSettings& settings, double seconds,
                                  const glm::dvec2& place) {
  std::vector<Flash> all =
      flashesBetween(moment, settings, seconds - kFlashStrokesS - kLongestFadeS, seconds, place);
  std::erase_if(all, [&](const Flash& flash) { return !(brightnessAt(flash, settings, seconds) > 0); });
  return all;
}

double brightnessAt(const Flash& flash, const LightningSettings& settings, double seconds) {
  const double soft = settings.softness;
  const double rise = kRiseS + kSoftRiseS * soft, decay = kFlashDecayS + kSoftDecayS * soft;
  const double peak = 1 - (1 - kSoftPeak) * soft;
  double sum = 0;
  for (std::size_t i = 0; i < flash.strokeCount; ++i) {
    const double share = i == 0 ? 1 : flash.strokes[i].share * (1 - soft);
    sum = std::max(sum, share * pulse(seconds - flash.seconds - flash.strokes[i].afterS, rise, decay));
  }
  return sum * peak * flash.strength * settings.brightness;
}

}  // namespace skydrop::weather
