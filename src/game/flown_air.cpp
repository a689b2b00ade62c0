#include "game/flown_air.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "game/state_digest.h"
#include "game/steps.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/fixed_step.h"
#include "skydrop/game/contact.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/game/ice_layers.h"
#include "skydrop/weather/draughts.h"
#include "skydrop/weather/icing.h"
#include "skydrop/weather/standard_atmosphere.h"

namespace skydrop::game {
namespace {

namespace dmath = core::dmath;
using core::FixedStep;

// Edges of rising air take about this long to cross, s: a column does not end like a wall.
constexpr double kDraughtSeconds = 1;
// The slope that air follows is that of so much land along the wind, m to each side.
constexpr double kSlopeReachM = 150;
// The axes of the gusts turn with the flight path, but no faster, radians a second: a path through the
// vertical does not swap them.
constexpr double kAxisTurnPerS = 0.6;
constexpr double kAxisFromMps = 10;  // a slower path has no direction

// The slope along the wind, as a gradient.
glm::dvec2 slopeAlong(const terrain::HeightSource& ground, const glm::dvec3& position,
                      const glm::dvec2& wind) {
  const double speed = std::sqrt(wind.x * wind.x + wind.y * wind.y);
  if (!(speed > 0.1)) return glm::dvec2(0);
  const glm::dvec2 along = wind / speed, here(position.x, position.z);
  const double rise = surfaceAt(ground, here + along * kSlopeReachM).height -
                      surfaceAt(ground, here - along * kSlopeReachM).height;
  return along * (rise / (2 * kSlopeReachM));
}

}  // namespace

FlownAir::FlownAir(const WorldSetup& setup) : setup_(&setup), dryden_(setup.seed) { now_.wind = setup.wind; }

void FlownAir::meet(const glm::dvec3& position, double surface, std::uint64_t step) {
  now_ = setup_->wind;
  ice_ = draught_ = 0;
  if (!setup_->weather) return;
  to_ = from_ = sample(position, surface, setup_->airplane.cruiseSpeed, secondsOf(step));
  ice_ = 0;  // the sample was of a moment, not of the time before it
  sampledStep_ = step;
  mix(1);
}

void FlownAir::advance(const flight::BodyState& aircraft, double clearance, std::uint64_t step) {
  if (!setup_->weather) {
    now_ = setup_->wind;
    return;
  }
  const double airspeed = glm::length(aircraft.velocity - now_.wind);
  if (step >= sampledStep_ + kSampleSteps || step < sampledStep_) {
    const double seconds = kSampleSteps * FixedStep::kStepSeconds;
    const glm::dvec3 ahead = aircraft.position + aircraft.velocity * seconds;
    from_ = mixed_;
    to_ = sample(ahead, aircraft.position.y - clearance, airspeed, secondsOf(step) + seconds);
    sampledStep_ = step;
  }
  dryden_.advance(gustStep_, step);
  turnAxis(aircraft);
  mix(static_cast<double>(step - sampledStep_ + 1) / kSampleSteps);
}

FlownAir::Sample FlownAir::sample(const glm::dvec3& position, double surface, double airspeed,
                                  double seconds) {
  const WeatherSetup& weather = *setup_->weather;
  const weather::WeatherSettings& settings = weather.settings;
  const weather::State state = weather.at(setup_->seed, seconds, {position.x, position.z});
  profile_ = weather::WindProfile(state.wind);
  const double above = std::max(position.y - surface, 0.0);
  const glm::dvec3 wind = profile_.at(position.y, above);
  const weather::Air air = weather::airAt(position.y, state.temperatureC, state.pressurePa);
  temperatureC_ = air.temperatureK - 273.15;

  const FlownClouds clouds(weather.noise, weather.drift, iceWindOf(settings, weather.forecast.get()));
  double rising = 0, cloudSigma2 = 0;
  cloudDensity_ = 0;
  for (const weather::Layer& layer : state.layers) {
    if (!(layer.cover > 0)) continue;
    const double here = clouds.density(layer, position, seconds);
    cloudDensity_ = std::min(cloudDensity_ + here, 1.0);
    const double rough = weather::airOf(layer.genus).turbulenceMps * std::min(layer.density, 2.0) * here;
    cloudSigma2 += rough * rough;
    if (settings.draughts > 0 && position.y < layer.topM) {
      rising += weather::cloudDraught(layer, clouds.column(layer, position, seconds), position.y, surface,
                                      state.precipitation.rain);
    }
  }
  const double interval = kSampleSteps * FixedStep::kStepSeconds;
  draught_ += (rising * settings.draughts - draught_) * (1 - dmath::exp(-interval / kDraughtSeconds));
  double up = draught_;
  if (settings.slopeWind > 0) {
    const glm::dvec2 level(wind.x, wind.z);
    up += settings.slopeWind *
          weather::slopeDraught(level, slopeAlong(*setup_->ground, position, level), above);
  }

  const weather::DrydenScales scales =
      weather::drydenScales(above, profile_.w20Mps(), state.turbulenceSeverity);
  gustStep_ = weather::DrydenStep(scales, airspeed, FixedStep::kStepSeconds);
  const auto sigma = [&](double clear) {
    return settings.turbulence * std::sqrt(clear * clear + cloudSigma2);
  };
  ice_ = settings.icing > 0
             ? weather::iceAfter(ice_, {temperatureC_, cloudDensity_, state.precipitation.rain},
                                 settings.icing, interval)
             : 0;
  return {wind.x,
          up,
          wind.z,
          settings.standardAtmosphere ? air.densityKgM3 / weather::kSeaLevelDensity : 1,
          sigma(scales.intensityMps.x),
          sigma(scales.intensityMps.y),
          sigma(scales.intensityMps.z)};
}

void FlownAir::turnAxis(const flight::BodyState& aircraft) {
  const glm::dvec2 path(aircraft.velocity.x - now_.wind.x, aircraft.velocity.z - now_.wind.z);
  const double speed = std::sqrt(path.x * path.x + path.y * path.y);
  if (!(speed > kAxisFromMps)) return;
  const glm::dvec2 to = path / speed, across(-axis_.y, axis_.x);
  const double most = kAxisTurnPerS * FixedStep::kStepSeconds;
  const double aside = to.x * across.x + to.y * across.y, along = to.x * axis_.x + to.y * axis_.y;
  const double turn = along > 0 ? std::clamp(aside, -most, most) : std::copysign(most, aside);
  axis_ += across * turn;
  axis_ /= std::sqrt(axis_.x * axis_.x + axis_.y * axis_.y);
}

void FlownAir::mix(double share) {
  for (std::size_t i = 0; i < kMixed; ++i) mixed_[i] = from_[i] + (to_[i] - from_[i]) * share;
  const glm::dvec3 gust = dryden_.gust();
  const double u = mixed_[kSigmaU] * gust.x, v = mixed_[kSigmaV] * gust.y;
  now_.wind = {mixed_[kEast] + u * axis_.x - v * axis_.y, mixed_[kUp] + mixed_[kSigmaW] * gust.z,
               mixed_[kSouth] + u * axis_.y + v * axis_.x};
  now_.densityShare = mixed_[kDensity];
  now_.liftShare = 1 - weather::kIceLiftLoss * ice_;
  now_.dragShare = 1 + weather::kIceDragGain * ice_;
}

glm::dvec3 FlownAir::meanWind(const glm::dvec3& position, double surface) const {
  return setup_->weather ? profile_.at(position.y, position.y - surface) : setup_->wind;
}

glm::dvec3 FlownAir::meanWindOf(const glm::dvec3& position, double surface, double seconds) const {
  if (!setup_->weather) return setup_->wind;
  const weather::State state = setup_->weather->at(setup_->seed, seconds, {position.x, position.z});
  return weather::WindProfile(state.wind).at(position.y, position.y - surface);
}

glm::dvec3 FlownAir::windOnPackage(const glm::dvec3& position, const glm::dvec3& velocity, double surface,
                                   double seconds, weather::Dryden& gusts, std::uint64_t count,
                                   double interval) const {
  const WeatherSetup& air = *setup_->weather;
  const double share = air.settings.packageGusts;
  if (!(share > 0)) return meanWindOf(position, surface, seconds);
  const weather::State state = air.at(setup_->seed, seconds, {position.x, position.z});
  const weather::WindProfile profile(state.wind);
  const double above = std::max(position.y - surface, 0.0);
  const glm::dvec3 mean = profile.at(position.y, position.y - surface);
  const weather::DrydenScales scales =
      weather::drydenScales(above, profile.w20Mps(), state.turbulenceSeverity);
  const glm::dvec3 sigma = share * air.settings.turbulence * scales.intensityMps;
  gusts.advance(weather::DrydenStep(scales, std::max(glm::length(velocity - mean), 1.0), interval), count);
  const glm::dvec3 gust = sigma * gusts.gust();
  double rising = 0;
  if (air.settings.draughts > 0) {
    const FlownClouds clouds(air.noise, air.drift);
    for (const weather::Layer& layer : state.layers) {
      if (!(layer.cover > 0) || position.y >= layer.topM) continue;
      rising += weather::cloudDraught(layer, clouds.column(layer, position, seconds), position.y, surface,
                                      state.precipitation.rain);
    }
  }
  const double level = std::sqrt(mean.x * mean.x + mean.z * mean.z);
  const glm::dvec2 along = level > 0.1 ? glm::dvec2(mean.x, mean.z) / level : glm::dvec2(1, 0);
  return mean + glm::dvec3(gust.x * along.x - gust.y * along.y,
                           gust.z + share * air.settings.draughts * rising,
                           gust.x * along.y + gust.y * along.x);
}

AirSnapshot FlownAir::snapshot(const flight::BodyState& aircraft) const {
  AirSnapshot out;
  if (!setup_->weather) return out;
  out.present = true;
  out.wind = {mixed_[kEast], 0, mixed_[kSouth]};
  out.velocity = now_.wind;
  out.risingMps = mixed_[kUp];
  out.densityShare = now_.densityShare;
  out.turbulenceMps = std::sqrt((mixed_[kSigmaU] * mixed_[kSigmaU] + mixed_[kSigmaV] * mixed_[kSigmaV] +
                                 mixed_[kSigmaW] * mixed_[kSigmaW]) /
                                3);
  out.cloudDensity = cloudDensity_;
  out.temperatureC = temperatureC_;
  out.icing = ice_;
  const glm::dvec3 through = aircraft.velocity - now_.wind;
  out.indicatedMps = glm::length(through) * std::sqrt(now_.densityShare);
  const glm::dvec2 over(aircraft.velocity.x, aircraft.velocity.z);
  out.groundMps = std::sqrt(over.x * over.x + over.y * over.y);
  const glm::dvec3 nose = aircraft.orientation * glm::dvec3(0, 0, -1);
  const double ahead = over.x * nose.x + over.y * nose.z, right = over.y * nose.x - over.x * nose.z;
  out.driftRad = ahead == 0 && right == 0 ? 0 : dmath::atan2(right, ahead);
  return out;
}

void FlownAir::addTo(core::StateHasher& h) const {
  if (!setup_->weather) return;
  for (int i = 0; i < weather::Dryden::kStates; ++i) h.add(dryden_.states()[i]);
  for (const Sample* sample : {&from_, &to_, &mixed_}) {
    for (const double value : *sample) h.add(value);
  }
  h.add(axis_.x), h.add(axis_.y), h.add(draught_), h.add(ice_), h.add(sampledStep_);
}

}  // namespace skydrop::game
