// Packages, targets and the score, after the rule of skydrop/game/world.h.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "game/event_log.h"
#include "game/flown_air.h"
#include "skydrop/core/hash.h"
#include "skydrop/flight/package.h"
#include "skydrop/flight/rigid_body.h"
#include "skydrop/game/snapshot.h"
#include "skydrop/game/world.h"
#include "skydrop/weather/dryden.h"

namespace skydrop::game {

class Deliveries {
 public:
  // Keeps all four, which must outlive it; the settings may change between steps.
  Deliveries(const WorldSetup& setup, const FlownAir& air, core::RandomStream& random, EventLog& eventLog);

  void drawNextTarget(const glm::dvec3& around);

  // Once a step, before the aircraft moves.
  void coolDown();
  // A package leaves the aircraft, unless the last one left too recently.
  void drop(const flight::BodyState& aircraft);
  // Once a step, number `step`, after it: packages fall and land, missing targets are searched again.
  void step(const std::optional<glm::dvec3>& aircraft, std::uint64_t step);

  // Where a package dropped now would land; none when that is nowhere.
  std::optional<glm::dvec3> predictLanding(const flight::BodyState& aircraft) const;

  // Of the landings, the newest kMostDeliveries.
  const std::vector<Delivery>& log() const { return log_; }
  std::optional<glm::dvec3> target() const;

  // Target, packages, score and cool-down. `aircraft`: from where the target is measured.
  void fill(Snapshot& out, const std::optional<glm::dvec3>& aircraft) const;
  // Whether a package that lands there scores.
  bool isInTarget(const glm::dvec3& landing) const;
  void addTo(core::StateHasher& hash) const;

 private:
  struct Target {
    std::uint32_t id = 0;
    glm::dvec3 position{0};
    double radius = 0;
    // For the points, no part of the digest: when it was drawn, and the way there.
    std::uint64_t drawnStep = 0;
    double wayM = 0;
  };
  // How a package left, for what is said of its landing; no part of the digest.
  struct Release {
    flight::PointState state;
    std::uint64_t step = 0;
  };
  struct FlyingPackage {
    std::uint32_t id = 0;
    flight::Package body;
    std::optional<Target> target;      // the one that was current at the release
    double clearance = 0;              // it is at least so far above the surface
    glm::dvec3 wind{0};                // that it was last asked for, with weather
    std::uint64_t stepsToWind = 0;     // until it is asked for again
    std::uint64_t windsAsked = 0;      // so far
    weather::Dryden gusts{0};          // that it feels
    std::uint64_t stepsToRemoval = 0;  // once landed
    bool onWater = false;
    glm::dvec3 groundNormal{0, 1, 0};  // of where it landed
    Release release;
    std::optional<PackageLanding> landing;  // predicted, for the view
    std::uint64_t stepsToPrediction = 0;    // until it is predicted again
  };

  void fall(FlyingPackage& package, const std::optional<glm::dvec3>& aircraft, std::uint64_t step);
  void judge(const FlyingPackage& package, const std::optional<glm::dvec3>& aircraft, std::uint64_t step);
  void follow(FlyingPackage& package) const;
  std::optional<flight::Landing> landingOf(const flight::PointState& state, double age) const;
  Delivery deliveryOf(const FlyingPackage& package, std::uint64_t step) const;
  static void addTo(core::StateHasher& hash, const std::optional<Target>& target);

  const WorldSetup* setup_;
  const FlownAir* air_;
  core::RandomStream* random_;
  EventLog* eventLog_;
  std::vector<FlyingPackage> packages_;
  std::optional<Target> target_;
  std::uint32_t targetsDrawn_ = 0;
  std::uint64_t stepsToTargetRetry_ = 0;
  std::uint64_t stepsToDrop_ = 0;
  std::int64_t score_ = 0, drops_ = 0, misses_ = 0;
  std::int64_t points_ = 0;  // of what score_ counts
  std::vector<Delivery> log_;
};

}  // namespace skydrop::game
