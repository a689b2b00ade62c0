#include "game/surface_bursts.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "skydrop/flight/landing_gear.h"
#include "skydrop/game/contact.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::game {
namespace {

using flight::GearPoint;

// A way is marked once every so many metres: puffs and sheets of spray of one mark reach the next.
constexpr double kRollingM = 3, kSwimmingM = 1.6, kSlidingM = 2.5;
// Slower than this nothing is thrown up on the way, m/s.
constexpr double kSlowest = 3, kSlowestHull = 1.5;
// A wheel is on the ground within this, m: the compression of its leg and the bumps that it rolls on.
constexpr double kWheelReachM = 0.25;
// A hull touches while its middle is so near, m.
constexpr double kHullReachM = 1.8;
// The wind near the ground that carries dust, m above it.
constexpr double kWindAboveM = 3;

glm::dvec3 placeOf(const AircraftSnapshot& aircraft, GearPoint point) {
  return aircraft.position + aircraft.orientation * flight::kGearPlaces[static_cast<std::size_t>(point)];
}

}  // namespace

void SurfaceBursts::clear() {
  bursts_.clear();
  lastOfWay_.reset();
}

void SurfaceBursts::record(BurstKind kind, const glm::dvec3& place, const glm::dvec3& velocity) {
  const terrain::HeightSource& ground = *setup_->ground;
  const glm::dvec2 xz(place.x, place.z);
  const Surface surface = surfaceAt(ground, xz);
  SurfaceBurst burst;
  burst.number = ++recorded_;
  burst.kind = kind;
  burst.seconds = seconds_;
  burst.position = {place.x, surface.height, place.z};
  burst.velocity = velocity;
  burst.onWater = surface.water;
  burst.wind = air_->meanWind(burst.position + glm::dvec3(0, kWindAboveM, 0), surface.height);
  if (!surface.water) {
    burst.normal = terrain::normalOf(ground.sample(xz));
    burst.ground = looseGroundAt(ground, burst.position, setup_->alpineBelts);
  }
  if (bursts_.size() == kMostBursts) bursts_.erase(bursts_.begin());
  bursts_.push_back(burst);
}

void SurfaceBursts::step(double seconds, std::span<const GameEvent> events, const Snapshot& before,
                         const AircraftSnapshot* aircraft) {
  if (!setup_->keepsBursts) return;
  seconds_ = seconds;
  std::erase_if(bursts_, [&](const SurfaceBurst& b) { return seconds - b.seconds > kBurstSeconds; });
  for (const GameEvent& event : events) {
    switch (event.kind) {
      case GameEventKind::packageLanded: {
        const auto fell = std::ranges::find(before.packages, event.id, &PackageSnapshot::id);
        record(BurstKind::package, event.position,
               fell == before.packages.end() ? glm::dvec3(0) : fell->velocity);
        break;
      }
      case GameEventKind::crashed:
        record(BurstKind::crash, event.position, before.aircraft.velocity);
        break;
      case GameEventKind::ditched:
        record(BurstKind::ditching, event.position, before.aircraft.velocity);
        break;
      case GameEventKind::touchedDown:
        if (!aircraft) break;
        for (const GearPoint wheel : {GearPoint::leftWheel, GearPoint::rightWheel}) {
          const glm::dvec3 place = placeOf(*aircraft, wheel);
          if (clearanceAt(*setup_->ground, place) < kWheelReachM)
            record(BurstKind::touchDown, place, before.aircraft.velocity);
        }
        break;
      case GameEventKind::respawned:
      case GameEventKind::reset:
        lastOfWay_.reset();
        break;
      default:
        break;
    }
  }
  if (aircraft) follow(*aircraft);
}

void SurfaceBursts::follow(const AircraftSnapshot& aircraft) {
  const double speed = glm::length(aircraft.velocity);
  const bool slides = aircraft.crashed && aircraft.gear.present;
  const bool swims = aircraft.gear.swims && !aircraft.crashed;
  const bool rolls = !slides && !swims && aircraft.gear.wheelsDown > 0;
  if ((!slides && !swims && !rolls) || speed < (swims ? kSlowestHull : kSlowest)) {
    lastOfWay_.reset();
    return;
  }
  const double every = slides ? kSlidingM : swims ? kSwimmingM : kRollingM;
  if (!lastOfWay_) lastOfWay_ = aircraft.position;
  if (glm::distance(*lastOfWay_, aircraft.position) < every) return;
  lastOfWay_ = aircraft.position;
  if (!rolls) {
    if (aircraft.heightAboveGround < kHullReachM)
      record(slides ? BurstKind::sliding : BurstKind::swimming, aircraft.position, aircraft.velocity);
    return;
  }
  for (const GearPoint wheel : {GearPoint::leftWheel, GearPoint::rightWheel}) {
    const glm::dvec3 place = placeOf(aircraft, wheel);
    if (clearanceAt(*setup_->ground, place) < kWheelReachM)
      record(BurstKind::rolling, place, aircraft.velocity);
  }
}

}  // namespace skydrop::game
