#include "render/spray/burst_clouds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/guards.h"
#include "skydrop/core/shared_spray.h"

namespace skydrop::render {
namespace {

using game::BurstKind;
using game::SurfaceBurst;
using Look = BurstCloud::Look;

constexpr glm::dvec3 kFoamAlbedo{0.82, 0.84, 0.85}, kSmokeAlbedo{0.035, 0.033, 0.032};
constexpr double kGravity = core::shared::f64::kGravityMps2;
// Speeds of a body that a burst is scaled by, m/s: a package under its parachute, wheels and a hull at
// landing.
constexpr double kPackageMps = 7, kHullMps = 28;

bool isUsable(const SurfaceBurst& burst, double seconds) {
  return core::isFinite(burst.position) && core::isFinite(burst.normal) && core::isFinite(burst.velocity) &&
         core::isFinite(burst.wind) && std::isfinite(burst.seconds) && std::isfinite(seconds) &&
         core::isFinite(burst.ground.albedo) && std::isfinite(burst.ground.looseness);
}

glm::dvec3 upOf(const SurfaceBurst& burst) {
  const double length = glm::length(burst.normal);
  return length > 1e-6 ? burst.normal / length : glm::dvec3(0, 1, 0);
}

// How hard it was, by a speed that is usual: its root, for what is thrown has a share of the energy.
double strengthOf(double speed, double usual) { return std::sqrt(std::clamp(speed / usual, 0.1, 6.0)); }

class Clouds {
 public:
  Clouds(const SurfaceBurst& burst, double age) : burst_(burst), up_(upOf(burst)), age_(age) {}

  // A cloud of the burst that begins so late; null when it is over or has not begun.
  void add(BurstCloud cloud, double delay = 0) {
    ++number_;
    cloud.age = age_ - delay;
    if (cloud.age < 0 || cloud.age > cloud.emitSeconds + cloud.lifeSeconds || cloud.share <= 0 ||
        cloud.opacity <= 0)
      return;
    cloud.place = burst_.position;
    cloud.up = up_;
    cloud.wind = burst_.wind;
    cloud.seed = burst_.number * 8u + number_;
    const double flown = std::min(cloud.age, cloud.lifeSeconds);
    const double thrown = glm::length(cloud.carried) + cloud.outMps + cloud.upMps + 1.8 * cloud.randomMps;
    const double mean = cloud.drag > 0 ? std::min(flown, 1 / cloud.drag) : flown;
    cloud.reachM =
        cloud.sourceM + 2 * std::max(cloud.fromM, cloud.toM) * cloud.stretch + thrown * mean +
        glm::length(cloud.wind) * flown +
        std::abs(cloud.fall) * flown * std::min(0.5 * flown, cloud.drag > 0 ? 1 / cloud.drag : flown);
    clouds_.push_back(cloud);
  }
  std::vector<BurstCloud> take() { return std::move(clouds_); }

 private:
  const SurfaceBurst& burst_;
  glm::dvec3 up_;
  double age_;
  std::uint32_t number_ = 0;
  std::vector<BurstCloud> clouds_;
};

void addDust(Clouds& all, const SurfaceBurst& burst, double amount, BurstCloud like) {
  like.look = Look::dust;
  like.albedo = burst.ground.albedo;
  like.opacity = std::min(like.opacity * amount * std::sqrt(std::max(burst.ground.looseness, 0.0)), 0.9);
  all.add(like);
}

// Grains that fly as stones do.
void addClods(Clouds& all, const SurfaceBurst& burst, double amount, double strength, double share) {
  BurstCloud c;
  c.look = Look::drops;
  c.lifeSeconds = 1.3 * strength;
  c.drag = 0.4, c.fall = kGravity;
  c.outMps = 2.6 * strength, c.upMps = 5 * strength, c.randomMps = 0.6 * strength;
  c.sourceM = 0.4 * strength;
  c.carried = burst.velocity * 0.12;
  c.fromM = c.toM = 0.07 * strength;
  c.opacity = std::min(amount * burst.ground.looseness, 1.0);
  c.stretch = 1.6;
  c.albedo = burst.ground.albedo * 0.75;
  c.share = share;
  c.sinks = true;
  all.add(c);
}

// A crown that opens, the jet that rises in its middle once the hole closes, and mist.
void addSplash(Clouds& all, const SurfaceBurst& burst, double amount, double strength, double size) {
  BurstCloud crown;
  crown.look = Look::drops;
  crown.lifeSeconds = 1.5 * strength;
  crown.drag = 0.5, crown.fall = kGravity;
  crown.emitSeconds = 0.10;
  crown.outMps = 3.4 * strength, crown.upMps = 7.2 * strength, crown.randomMps = 0.35 * strength;
  crown.sourceM = 0.6 * size;
  crown.carried = glm::dvec3(burst.velocity.x, 0, burst.velocity.z) * 0.15;
  crown.fromM = 0.11 * size, crown.toM = 0.21 * size;
  crown.opacity = std::min(0.75 * amount, 1.0);
  crown.stretch = 3;
  crown.albedo = kFoamAlbedo;
  crown.sinks = true;
  all.add(crown);

  BurstCloud jet = crown;
  jet.emitSeconds = 0.35;
  jet.lifeSeconds = 1.7 * strength;
  jet.outMps = 0.5 * strength, jet.upMps = 9.6 * strength, jet.randomMps = 0.3 * strength;
  jet.sourceM = 0.25 * size;
  jet.fromM = 0.13 * size, jet.toM = 0.22 * size;
  jet.share = 0.35;
  all.add(jet, 0.22 * strength);

  BurstCloud mist;
  mist.lifeSeconds = 2.4;
  mist.drag = 1.6, mist.fall = 1.2;
  mist.emitSeconds = 0.25;
  mist.outMps = 3.2 * strength, mist.upMps = 6.5 * strength, mist.randomMps = 0.6;
  mist.sourceM = 0.5 * size;
  mist.carried = crown.carried;
  mist.fromM = 0.35 * size, mist.toM = 1.5 * size;
  mist.opacity = std::min(0.16 * amount, 0.9);
  mist.albedo = kFoamAlbedo;
  mist.share = 0.12;
  all.add(mist);
}

// Sheets to both sides of a hull.
void addSheets(Clouds& all, const SurfaceBurst& burst, double amount, double share, double strength) {
  BurstCloud drops;
  drops.look = Look::drops;
  drops.lifeSeconds = 1.35 * strength;
  drops.drag = 0.7, drops.fall = kGravity;
  drops.emitSeconds = 0.08;
  drops.outMps = 6.5 * strength, drops.upMps = 5.2 * strength, drops.randomMps = 0.8 * strength;
  drops.sourceM = 0.9;
  drops.carried = glm::dvec3(burst.velocity.x, 0, burst.velocity.z) * 0.42;
  drops.sideways = 0.8;
  drops.fromM = 0.11, drops.toM = 0.22;
  drops.opacity = std::min(0.75 * amount, 1.0);
  drops.stretch = 3;
  drops.albedo = kFoamAlbedo;
  drops.share = share;
  drops.sinks = true;
  all.add(drops);

  BurstCloud mist = drops;
  mist.look = Look::dust;
  mist.lifeSeconds = 1.9;
  mist.drag = 1.8, mist.fall = 1.5;
  mist.outMps *= 0.8, mist.upMps *= 0.8;
  mist.fromM = 0.4, mist.toM = 1.7;
  mist.opacity = std::min(0.13 * amount, 0.9);
  mist.stretch = 1;
  mist.share = 0.15 * share;
  mist.sinks = false;
  all.add(mist);
}

void addCrashOnLand(Clouds& all, const SurfaceBurst& burst, double amount, double strength) {
  SurfaceBurst ground = burst;  // a crash tears up what wheels leave in place
  ground.ground.looseness = std::max(burst.ground.looseness, 0.5);
  addDust(all, ground, amount,
          {.lifeSeconds = 7,
           .drag = 1.3,
           .fall = 0.1,
           .outMps = 9 * strength,
           .upMps = 5.5 * strength,
           .randomMps = 1.5,
           .sourceM = 2,
           .carried = burst.velocity * 0.12,
           .fromM = 0.9,
           .toM = 4.2,
           .opacity = 0.62,
           .share = 0.22});
  addClods(all, ground, amount, 1.5 * strength, 0.4);
  BurstCloud smoke;
  smoke.lifeSeconds = 7;
  smoke.emitSeconds = 9;
  smoke.drag = 0.5, smoke.fall = -1.3;
  smoke.outMps = 0.7, smoke.upMps = 2, smoke.randomMps = 0.6;
  smoke.sourceM = 1.2;
  smoke.fromM = 0.7, smoke.toM = 4.6;
  smoke.opacity = std::min(0.7 * amount, 0.9);
  smoke.albedo = kSmokeAlbedo;
  smoke.share = 0.25;
  all.add(smoke, 0.2);
}

}  // namespace

std::vector<BurstCloud> cloudsOf(const SurfaceBurst& burst, double seconds, double amount) {
  if (!isUsable(burst, seconds) || !(amount > 0)) return {};
  const double age = seconds - burst.seconds;
  if (age < 0 || age > game::kBurstSeconds) return {};
  Clouds all(burst, age);
  const double speed = glm::length(burst.velocity);
  const double into = std::abs(glm::dot(burst.velocity, upOf(burst)));
  switch (burst.kind) {
    case BurstKind::package: {
      const double strength = strengthOf(into, kPackageMps);
      if (burst.onWater) {
        addSplash(all, burst, amount, strength, strength);
        break;
      }
      addDust(all, burst, amount,
              {.lifeSeconds = 4.8,
               .drag = 2.2,
               .fall = 0.15,
               .outMps = 5.5 * strength,
               .upMps = 2.4 * strength,
               .randomMps = 0.9,
               .sourceM = 0.5,
               .carried = burst.velocity * 0.1,
               .fromM = 0.3,
               .toM = 1.8,
               .opacity = 0.56,
               .share = 0.18});
      addClods(all, burst, amount, 0.8 * strength, 0.2);
      break;
    }
    case BurstKind::touchDown:
      if (burst.onWater) break;
      addDust(all, burst, amount,
              {.emitSeconds = 0.12,
               .lifeSeconds = 4.2,
               .drag = 1.6,
               .fall = 0.05,
               .outMps = 2.2,
               .upMps = 1.7,
               .randomMps = 0.6,
               .sourceM = 0.3,
               .carried = burst.velocity * 0.2,
               .fromM = 0.2,
               .toM = 1.7,
               .opacity = 0.56,
               .share = 0.12});
      break;
    case BurstKind::rolling: {
      if (burst.onWater) break;
      const double fast = std::clamp(speed / kHullMps, 0.0, 1.0);
      addDust(all, burst, amount,
              {.emitSeconds = 0.1,
               .lifeSeconds = 3.4,
               .drag = 1.8,
               .fall = 0.05,
               .outMps = 0.9,
               .upMps = 1.2,
               .randomMps = 0.5,
               .sourceM = 0.4,
               .carried = burst.velocity * 0.15,
               .fromM = 0.15,
               .toM = 1.35,
               .opacity = 0.4 * fast,
               .share = 0.022});
      break;
    }
    case BurstKind::ditching:
      addSheets(all, burst, amount, 0.6, strengthOf(speed, kHullMps) * 1.15);
      break;
    case BurstKind::swimming:
      addSheets(all, burst, amount, 0.16, std::clamp(speed / kHullMps, 0.15, 1.2));
      break;
    case BurstKind::crash:
      if (burst.onWater) {
        addSplash(all, burst, amount, std::min(strengthOf(speed, 30), 1.5) * 1.25, 2.4);
      } else {
        addCrashOnLand(all, burst, amount, std::min(strengthOf(speed, 40), 1.4));
      }
      break;
    case BurstKind::sliding:
      if (burst.onWater) {
        addSheets(all, burst, amount, 0.16, std::clamp(speed / kHullMps, 0.15, 1.2));
        break;
      }
      addDust(all, burst, amount,
              {.emitSeconds = 0.15,
               .lifeSeconds = 4,
               .drag = 1.5,
               .fall = 0.05,
               .outMps = 2.5,
               .upMps = 2.2,
               .randomMps = 0.7,
               .sourceM = 1,
               .carried = burst.velocity * 0.2,
               .fromM = 0.4,
               .toM = 2.2,
               .opacity = 0.6,
               .share = 0.045});
      break;
  }
  return all.take();
}

std::optional<BurstWake> wakeOf(const SurfaceBurst& burst, double seconds, double amount) {
  if (!burst.onWater || !isUsable(burst, seconds) || !(amount > 0)) return {};
  const double age = seconds - burst.seconds;
  if (age < 0 || age > game::kBurstSeconds) return {};
  BurstWake wake;
  const double speed = glm::length(burst.velocity);
  double foamSeconds = 5, spreadMps = 0.35;
  switch (burst.kind) {
    case BurstKind::package: {
      const double strength = strengthOf(std::abs(burst.velocity.y), kPackageMps);
      wake.radiusM = 0.6 * strength, wake.slope = 4;
      wake.foamM = 1.5 * strength, wake.foam = 1.2;
      break;
    }
    case BurstKind::crash:
      wake.radiusM = 1.5, wake.slope = 4;
      wake.foamM = 4, wake.foam = 2.2;
      foamSeconds = 8;
      break;
    case BurstKind::ditching:
      wake.radiusM = 1.4, wake.slope = 1.5;
      wake.foamM = 2.2, wake.foam = 0.8;
      foamSeconds = 6;
      break;
    default: {
      const double fast = std::clamp(speed / kHullMps, 0.0, 1.0);
      wake.radiusM = 1.1, wake.slope = 0.8 * fast;
      wake.foamM = 1.1 + 0.5 * fast, wake.foam = 0.5 * std::sqrt(fast);
      foamSeconds = 6, spreadMps = 0.45 * fast;
      break;
    }
  }
  const double calm = 1 - age / game::kBurstSeconds;
  wake.place = burst.position;
  wake.age = age;
  wake.slope *= std::min(amount, 1.5) * calm * calm;
  wake.foam *= std::min(amount, 2.0) * std::exp(-age / foamSeconds) * std::min(age / 0.25, 1.0);
  wake.foamM += spreadMps * age;
  // Waves run at the speed of the longest that the body makes, some ahead of them.
  wake.reachM = 3 * wake.radiusM + 1.6 * std::sqrt(kGravity * wake.radiusM) * age + wake.foamM;
  return wake;
}

}  // namespace skydrop::render
