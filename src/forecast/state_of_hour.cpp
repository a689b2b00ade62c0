#include <algorithm>
#include <cmath>

#include "forecast/mapping.h"
#include "forecast/units.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/forecast/forecast_of.h"

namespace skydrop::forecast {
namespace {

namespace dmath = core::dmath;
using weather::Genus;
using weather::Layer;
using weather::State;

// Where layers go, so that from hour to hour each is mixed with its like.
enum Slot { kLow, kTower, kMiddle, kHigh };

class StateMaker {
 public:
  StateMaker(const Hour& hour, const Ground& ground)
      : hour_(hour),
        groundM_(ground.elevationM),
        turn_(ground.isSouthern ? -1 : 1),
        phenomena_(hour.phenomena.value_or(Phenomena())) {}

  State make() {
    precipitate();
    blow();
    if (hour_.layers)
      seenLayers();
    else
      forecastLayers();
    veil();
    const double temperature = value(Quantity::temperatureC, 15 - kLapsePerM * groundM_);
    out_.temperatureC = std::clamp(temperature + kLapsePerM * groundM_, -60.0, 60.0);
    out_.pressurePa = value(Quantity::pressureHpa, 1013.25) * 100;
    out_.lightningPerMinute = !phenomena_.thunder ? 0 : rate_ >= 4 ? 4 : 2;
    out_.turbulenceSeverity = phenomena_.thunder ? 4 : tower_ ? 3 : 2;
    return out_;
  }

 private:
  double value(Quantity quantity, double otherwise) const { return hour_[quantity].value_or(otherwise); }

  void precipitate() {
    rate_ = value(Quantity::precipitationMm, 0);
    convective_ = std::min(value(Quantity::convectiveMm, 0), rate_);
    if (phenomena_.towers && !hour_[Quantity::convectiveMm]) convective_ = rate_;
    const double temperature = value(Quantity::temperatureC, 15);
    const double byTemperature = std::clamp((kRainFromC - temperature) / (kRainFromC - kSnowToC), 0.0, 1.0);
    const double snow = value(Quantity::snowShare, byTemperature);
    double& kind = snow <= kSleetFromShare ? out_.precipitation.rain
                   : snow >= kSleetToShare ? out_.precipitation.snow
                                           : out_.precipitation.sleet;
    const double most = snow <= kSleetFromShare ? 200 : snow >= kSleetToShare ? 50 : 100;
    kind = std::min(rate_, most);
    if (phenomena_.hail) out_.precipitation.hail = 5;
  }

  void blow() {
    weather::Wind& wind = out_.wind;
    wind.speedMps = std::min(value(Quantity::windMps, 0), 50.0);
    wind.directionDeg = value(Quantity::windFromDeg, kUsualFromDeg);
    const double usual = wind.speedMps * kUsualGustShare + (convective_ > 0 ? 3 : 0);
    const auto& gust = hour_[Quantity::gustMps];
    wind.gustMps = wind.speedMps > 0 ? std::clamp(gust ? *gust - wind.speedMps : usual, 0.0, 40.0) : 0;
    // The logarithmic law up to the gradient height (weather/wind_profile.h).
    const double z0 = wind.roughnessM;
    const double free = wind.speedMps * dmath::log(1 + wind.gradientHeightM / z0) / dmath::log(1 + 10 / z0);
    double below = wind.gradientHeightM + 100;
    const double from = wind.directionDeg;
    for (std::size_t i = 0; i < weather::kWindLevels; ++i) {
      const AssumedLevel& assumed = kAssumedLevels[i];
      weather::WindLevel& level = wind.levels[i];
      level = {std::max(assumed.heightM, below), std::min(free * assumed.share, 100.0),
               turned(from + turn_ * assumed.turnDeg)};
      if (const WindAloft* known = nearest(assumed.heightM, below))
        level = {known->heightM, std::min(known->speedMps, 150.0), known->fromDeg};
      below = level.heightM + 1;
    }
  }

  // The known wind nearest to a height, above `below` and within the part of the air that the level is for.
  const WindAloft* nearest(double heightM, double below) const {
    const WindAloft* best = nullptr;
    for (const WindAloft& wind : hour_.aloft) {
      if (wind.heightM < below || std::abs(wind.heightM - heightM) > 0.45 * heightM) continue;
      if (!best || std::abs(wind.heightM - heightM) < std::abs(best->heightM - heightM)) best = &wind;
    }
    return best;
  }

  // Of what cools by rising, m above the ground.
  double condensationM() const {
    const auto& temperature = hour_[Quantity::temperatureC];
    auto dew = hour_[Quantity::dewPointC];
    const auto& humidity = hour_[Quantity::humidity];
    if (!dew && humidity && temperature) {
      // Magnus' formula, with the constants of WMO 2008.
      const double gamma =
          dmath::log(std::clamp(*humidity, 0.01, 1.0)) + 17.62 * *temperature / (243.12 + *temperature);
      dew = 243.12 * gamma / (17.62 - gamma);
    }
    if (!dew || !temperature) return kUsualLowBaseM;
    return std::clamp(kBaseMPerDegree * (*temperature - *dew), kLeastBaseM, kMostBaseM);
  }

  void put(Slot slot, Genus genus, double baseM, double topM, double cover, double density = 1) {
    const double base = std::clamp(baseM, -400.0, 14000.0);
    out_.layers[slot] = {genus, base, std::clamp(topM, base + 100, 18000.0), std::clamp(cover, 0.0, 1.0),
                         density};
  }

  void low(double cover, double baseM) {
    const double base = groundM_ + baseM;
    if (phenomena_.fog || baseM < kStratusBelowM) return put(kLow, Genus::stratus, base, base + 350, cover);
    if (cover > kBrokenCover) return put(kLow, Genus::stratocumulus, base, base + 500, cover);
    put(kLow, Genus::cumulus, base, base + 500 + 1200 * cover, cover);
  }

  void tower(bool cumulonimbus, double cover, double baseM) {
    tower_ = true;
    const double base = groundM_ + baseM;
    if (cumulonimbus)
      return put(kTower, Genus::cumulonimbus, base, std::max(kCumulonimbusTopM, base + 4000), cover);
    put(kTower, Genus::cumulus, base, base + kToweringM, cover, 1.3);
  }

  void middle(double cover, double base) {
    if (cover > kSheetCover) return put(kMiddle, Genus::altostratus, base, base + kAltostratusM, cover);
    put(kMiddle, Genus::altocumulus, base, base + kAltocumulusM, cover);
  }

  void high(double cover, double base) {
    put(kHigh, cover > kSheetCover ? Genus::cirrostratus : Genus::cirrus, base, base + kHighM, cover);
  }

  bool isEvenRain() const { return rate_ - convective_ >= kNimbostratusFromMm && convective_ < rate_ / 2; }

  void nimbostratus(double cover, double baseM) {
    const double base = groundM_ + std::clamp(baseM, 300.0, 1500.0);
    put(kMiddle, Genus::nimbostratus, base, std::max(kNimbostratusTopM, base + 2000), cover);
  }

  void forecastLayers() {
    const double total = value(Quantity::totalCover, 0);
    const bool hasLayers =
        hour_[Quantity::lowCover] || hour_[Quantity::middleCover] || hour_[Quantity::highCover];
    // Of a total alone nothing says where it is: it is taken for low cloud, which matters most to a flight.
    const double lowCover = value(Quantity::lowCover, hasLayers ? 0 : total);
    const double middleCover = value(Quantity::middleCover, 0), highCover = value(Quantity::highCover, 0);
    const double base = condensationM();
    if (lowCover > 0) low(lowCover, base);
    if (middleCover > 0) middle(middleCover, std::max(kMiddleBaseM, groundM_ + 2200));
    if (highCover > 0) high(highCover, kHighBaseM);
    const double overhead = std::max({lowCover, middleCover, total});
    if (isEvenRain() && overhead >= kNimbostratusCover) nimbostratus(overhead, base);
    const bool cumulonimbus = phenomena_.thunder || convective_ >= kCumulonimbusFromMm;
    if (cumulonimbus || convective_ >= kToweringFromMm || phenomena_.towers)
      tower(cumulonimbus, std::clamp(0.5 * std::max(lowCover, total), 0.1, kMostTowerCover), base);
  }

  // The layers that an observer named: the first of each kind in its slot, others where there is room.
  void seenLayers() {
    for (const SeenLayer& seen : *hour_.layers) {
      if (seen.cumulonimbus || seen.toweringCumulus) {
        if (!tower_) tower(seen.cumulonimbus, seen.cover, std::max(seen.baseM, kLeastBaseM));
        continue;
      }
      const Slot slot = seen.baseM < 2000 ? kLow : seen.baseM < 6000 ? kMiddle : kHigh;
      // Two of a kind: the one that covers more.
      if (out_.layers[slot].cover >= seen.cover) continue;
      if (slot == kLow) low(seen.cover, std::max(seen.baseM, 30.0));
      if (slot == kMiddle) middle(seen.cover, groundM_ + seen.baseM);
      if (slot == kHigh) high(seen.cover, groundM_ + seen.baseM);
    }
    const Layer& below = out_.layers[kLow];
    const double cover = value(Quantity::totalCover, 0);
    if (isEvenRain() && cover >= kNimbostratusCover)
      nimbostratus(cover, below.cover > 0 ? below.baseM - groundM_ : condensationM());
    // Thunder is heard of a cumulonimbus, seen or not.
    if (phenomena_.thunder && !tower_)
      tower(true, std::clamp(cover / 2, 0.1, kMostTowerCover), condensationM());
  }

  void veil() {
    double visibility = value(Quantity::visibilityM, kUsualVisibilityM);
    const bool isLikely = value(Quantity::fogProbability, 0) >= kLikelyFog;
    const auto& given = hour_[Quantity::visibilityM];
    if (!given && (isLikely || (phenomena_.fog && !hour_[Quantity::fogProbability])))
      visibility = kLikelyFogVisibilityM;
    if (visibility < kFogVisibilityM) {
      out_.fog.extinction = std::min(kKoschmieder / std::max(visibility, 1.0), 0.2);
      const double depth = visibility < 300 ? kDeepFogDepthM : kFogDepthM;
      out_.fog.topM = std::clamp(groundM_ + depth, -500.0, 5000.0);
      // Above it the air is clear; what the figure says is the fog.
      out_.visibilityM = kUsualVisibilityM / 2;
      return;
    }
    out_.fog.topM = std::clamp(groundM_ + kFogDepthM, -500.0, 5000.0);
    out_.visibilityM = std::clamp(visibility, 1000.0, 200000.0);
  }

  const Hour& hour_;
  double groundM_, turn_;
  Phenomena phenomena_;
  State out_;
  double rate_ = 0, convective_ = 0;
  bool tower_ = false;
};

}  // namespace

Ground groundOf(const Report& report) { return {report.elevationM, report.latitudeDegrees.value_or(0) < 0}; }

weather::State stateOf(const Hour& hour, const Ground& ground) { return StateMaker(hour, ground).make(); }

weather::State farStateOf(const Hour& hour, const Ground& ground) {
  State state = stateOf(hour, ground);
  if (!hour[Quantity::totalCover]) return state;
  constexpr double kMost = 0.999;
  const double total = std::clamp(*hour[Quantity::totalCover], 0.0, kMost);
  double clear = 1;
  for (const Layer& layer : state.layers) clear *= 1 - std::min(layer.cover, kMost);
  if (clear >= 1) {  // a total, and no layer that it could be
    if (total <= 0) return state;
    Hour alone = hour;
    alone.layers.reset();
    for (const Quantity q : {Quantity::lowCover, Quantity::middleCover, Quantity::highCover})
      alone[q].reset();
    return stateOf(alone, ground);
  }
  // 1 - (1 - cover)^k for each, with the k for which all together leave 1 - total of the sky clear.
  const double k = dmath::log(1 - total) / dmath::log(clear);
  for (Layer& layer : state.layers) {
    if (layer.cover > 0)
      layer.cover = std::clamp(1 - dmath::pow(1 - std::min(layer.cover, kMost), k), 0.0, 1.0);
  }
  return state;
}

}  // namespace skydrop::forecast
