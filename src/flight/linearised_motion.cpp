#include "flight/linearised_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>

#include "skydrop/flight/rotation.h"

namespace skydrop::flight {
namespace {

// Displacements are this share of the motion, so that a force that bends is seen at the scale of the motion
// (not of what a stiff force makes of it in a step) ...
constexpr double kShareOfMotion = 1e-4;
// ... but not so small that the rounding of the forces is taken for a slope: at least so many metres or
// radians over the step, and this share of a far position.
constexpr double kLeastDisplacement = 1e-9;
constexpr double kShareOfPosition = 1e-10;
constexpr double kLargestTurn = 1e-2;  // rad: the attitude is no vector

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

std::array<double, 6> row(const Acceleration& a) {
  return {a.linear.x, a.linear.y, a.linear.z, a.angular.x, a.angular.y, a.angular.z};
}

template <std::size_t N>
double rowSumNorm(const std::array<std::array<double, N>, N>& m) {
  double norm = 0;
  for (const auto& r : m) {
    double sum = 0;
    for (const double value : r) sum += std::abs(value);
    if (!(sum <= norm)) norm = sum;  // keeps NaN
  }
  return norm;
}

}  // namespace

Acceleration Dynamics::operator()(const BodyState& at, double time) const {
  const Wrench w = (*wrench)(at, time);
  const glm::dvec3& spin = at.angularVelocity;
  const glm::dvec3 gyro = gyroscopic ? glm::cross(spin, body->inertia * spin) : glm::dvec3(0);
  return {w.force / body->mass, body->inverseInertia * (w.torque - gyro)};
}

LinearisedMotion::LinearisedMotion(const Dynamics& dynamics, const BodyState& at, double time, double dt)
    : acceleration_(dynamics(at, time)) {
  const std::array<double, 6> here = row(acceleration_);
  const double speed = largest(at.velocity), spin = largest(at.angularVelocity);
  const double least = kLeastDisplacement / dt;
  const double byVelocity = std::max(kShareOfMotion * speed, least),
               bySpin = std::max(kShareOfMotion * spin, least);
  const double byPosition =
      std::max({kShareOfMotion * dt * speed, kLeastDisplacement, kShareOfPosition * largest(at.position)});
  const double byTurn = std::clamp(kShareOfMotion * dt * spin, kLeastDisplacement, kLargestTurn);
  const auto setColumn = [&](Matrix6& matrix, std::size_t column, const BodyState& displaced, double scale) {
    const std::array<double, 6> there = row(dynamics(displaced, time));
    for (std::size_t i = 0; i < 6; ++i) matrix[i][column] = scale * (there[i] - here[i]);
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto column = static_cast<std::size_t>(axis);
    // Divided by the difference that is left after rounding.
    BodyState moved = at;
    moved.velocity[axis] += byVelocity;
    setColumn(byVelocity_, column, moved, dt / (moved.velocity[axis] - at.velocity[axis]));
    moved = at;
    moved.angularVelocity[axis] += bySpin;
    setColumn(byVelocity_, column + 3, moved, dt / (moved.angularVelocity[axis] - at.angularVelocity[axis]));
    moved = at;
    moved.position[axis] += byPosition;
    setColumn(byPlace_, column, moved, dt * dt / (moved.position[axis] - at.position[axis]));
    moved = at;
    glm::dvec3 turn(0);
    turn[axis] = byTurn;
    moved.orientation = glm::normalize(at.orientation * exponentialMap(turn));
    setColumn(byPlace_, column + 3, moved, dt * dt / byTurn);
  }
}

double LinearisedMotion::stiffness() const {
  // A bound by norms first; it settles most doubts.
  const double v = rowSumNorm(byVelocity_), x = rowSumNorm(byPlace_);
  const double bound = 0.5 * (v + std::sqrt(v * v + 4 * x));
  if (!std::isfinite(bound) || bound < 0.1) return bound;
  // The spectral radius of the motion of (place / dt, velocity) is the limit of |M^k|^(1/k) (Gelfand): k =
  // 128 leaves a factor of 1.1 where axes of different units differ by 1e5.
  constexpr int kSquarings = 7;
  std::array<std::array<double, 12>, 12> m{};
  for (std::size_t i = 0; i < 6; ++i) {
    m[i][i + 6] = 1;
    for (std::size_t k = 0; k < 6; ++k) m[i + 6][k] = byPlace_[i][k], m[i + 6][k + 6] = byVelocity_[i][k];
  }
  std::array<double, kSquarings + 1> norms{};
  for (int n = 0;; ++n) {
    const double norm = norms[static_cast<std::size_t>(n)] = rowSumNorm(m);
    if (norm == 0) return 0;
    if (n == kSquarings) break;
    for (auto& r : m) {
      for (double& value : r) value /= norm;
    }
    std::array<std::array<double, 12>, 12> square{};
    for (std::size_t i = 0; i < 12; ++i) {
      for (std::size_t k = 0; k < 12; ++k) {
        for (std::size_t j = 0; j < 12; ++j) square[i][j] += m[i][k] * m[k][j];
      }
    }
    m = square;
  }
  double radius = norms[kSquarings];
  for (int n = kSquarings - 1; n >= 0; --n) radius = norms[static_cast<std::size_t>(n)] * std::sqrt(radius);
  return radius;
}

Acceleration LinearisedMotion::answerTo(const Acceleration& change) const {
  const std::array<double, 6> right = row(change);
  std::array<std::array<double, 7>, 6> m{};  // the system and its right side
  for (std::size_t i = 0; i < 6; ++i) {
    m[i][6] = right[i];
    for (std::size_t k = 0; k < 6; ++k) m[i][k] = (i == k ? 1 : 0) - byVelocity_[i][k] - byPlace_[i][k];
  }
  // Gaussian elimination with the largest pivot of the column.
  for (std::size_t column = 0; column < 6; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < 6; ++i) {
      if (std::abs(m[i][column]) > std::abs(m[pivot][column])) pivot = i;
    }
    std::swap(m[column], m[pivot]);
    for (std::size_t i = column + 1; i < 6; ++i) {
      const double factor = m[i][column] / m[column][column];
      for (std::size_t k = column; k < 7; ++k) m[i][k] -= factor * m[column][k];
    }
  }
  std::array<double, 6> answer{};
  for (std::size_t i = 6; i-- > 0;) {
    double sum = m[i][6];
    for (std::size_t k = i + 1; k < 6; ++k) sum -= m[i][k] * answer[k];
    answer[i] = sum / m[i][i];
  }
  return {{answer[0], answer[1], answer[2]}, {answer[3], answer[4], answer[5]}};
}

BodyState implicitStep(const Dynamics& dynamics, const BodyState& start, double time, double dt) {
  constexpr int kNewtonSteps = 4, kHalvings = 60;
  constexpr double kLeastGain = 0.25;  // of the share of the step that is taken
  const double end = time + dt;
  const auto arriving = [&](const Acceleration& change) {
    BodyState out = start;
    out.velocity += change.linear;
    out.angularVelocity += change.angular;
    out.position += out.velocity * dt;
    out.orientation = glm::normalize(start.orientation * exponentialMap(out.angularVelocity * dt));
    return out;
  };
  const auto missing = [&](const Acceleration& change, const Acceleration& there) {
    return Acceleration{dt * there.linear - change.linear, dt * there.angular - change.angular};
  };
  // As an energy, so that both parts count alike. The root, for what is left of the motion may be tiny.
  const auto size = [&](const Acceleration& a) {
    const double largestPart = std::max(largest(a.linear), largest(a.angular));
    if (largestPart == 0) return 0.0;
    const glm::dvec3 l = a.linear / largestPart, r = a.angular / largestPart;
    return largestPart *
           std::sqrt(dynamics.body->mass * glm::dot(l, l) + glm::dot(r, dynamics.body->inertia * r));
  };
  Acceleration change;
  // Goes along `way`, halved until it helps; the share that was gone, 0 where none helps.
  const auto go = [&](const Acceleration& way, double before) {
    double share = 1;
    for (int n = 0; n <= kHalvings; ++n, share /= 2) {
      const Acceleration next{change.linear + share * way.linear, change.angular + share * way.angular};
      if (!(size(missing(next, dynamics(arriving(next), end))) <= (1 - kLeastGain * share) * before))
        continue;
      change = next;
      return share;
    }
    return 0.0;
  };
  for (int i = 0; i < kNewtonSteps; ++i) {
    const LinearisedMotion motion(dynamics, arriving(change), end, dt);
    const Acceleration left = missing(change, motion.acceleration());
    const double before = size(left);
    if (before == 0) break;
    double share = go(motion.answerTo(left), before);
    // A slope that is small beside what the force bends may have the wrong sign (dry friction, along the
    // motion): then the way of the force itself.
    if (share == 0) share = go(left, before);
    if (share == 0 || share == 1) break;  // nothing but rounding is left, or no step helps; or there
  }
  return arriving(change);
}

}  // namespace skydrop::flight
