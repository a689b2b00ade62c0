#include "skydrop/audio/listener.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/guards.h"

namespace skydrop::audio {
namespace {

constexpr double kFastest = 0.95 * kSoundMps;
constexpr double kFarthestM = 30000;  // beyond it nothing is heard
constexpr double kTakenOverM = 2500;  // of what is audible of an engine, the air leaves 1/e over this

glm::dvec3 atMost(const glm::dvec3& velocity, double speed) {
  const double length = glm::length(velocity);
  return length > speed ? velocity * (speed / length) : velocity;
}

}  // namespace

Arrival arrivalFrom(const glm::dvec3& source, const glm::dvec3& velocity, const Listener& listener) {
  const glm::dvec3 apart = listener.position - source;
  if (!core::isFinite(apart) || !core::isFinite(velocity) || !core::isFinite(listener.velocity))
    return {.gain = 0};
  if (glm::dot(apart, apart) > kFarthestM * kFarthestM) return {.gain = 0};
  const glm::dvec3 flown = atMost(velocity, kFastest), moved = atMost(listener.velocity, kFastest);
  // |apart + flown t| = c t: the way from where the source was.
  const double along = glm::dot(apart, flown);
  const double slack = kSoundMps * kSoundMps - glm::dot(flown, flown);
  const double root = std::sqrt(along * along + slack * glm::dot(apart, apart));
  // Neither is a difference of numbers that are alike.
  const double seconds =
      along > 0 ? (along + root) / slack : glm::dot(apart, apart) / std::max(root - along, 1e-9);
  const glm::dvec3 way = apart + flown * seconds;
  const double distance = glm::length(way);
  Arrival arrival;
  arrival.seconds = seconds;
  arrival.gain = kFullGainM / std::max(distance, kFullGainM) *
                 std::exp(-std::max(distance - kFullGainM, 0.0) / kTakenOverM);
  if (distance > 1e-3) {
    const glm::dvec3 towards = way / distance;
    arrival.pitch =
        std::clamp((kSoundMps - glm::dot(moved, towards)) / (kSoundMps - glm::dot(flown, towards)), 0.5, 2.0);
    // Within a few metres a sound is all around.
    arrival.pan =
        std::clamp(-glm::dot(towards, listener.right), -1.0, 1.0) * std::min(distance / kFullGainM, 1.0);
  }
  return arrival;
}

}  // namespace skydrop::audio
