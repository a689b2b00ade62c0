#include "skydrop/accuracy/study_flight.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace skydrop::accuracy {

std::array<double, 6> flownPose(const std::array<double, 6>& pose, const StudyFlight& flight, int frame) {
  constexpr double kGravity = 9.81;  // m/s^2
  const double seconds = frame / kFlightFramesPerSecond, way = flight.speedMps * seconds;
  // A coordinated turn (v omega = g tan bank); yaw grows to the right.
  const double rate =
      flight.speedMps > 0 ? kGravity * std::tan(glm::radians(flight.bankDegrees)) / flight.speedMps : 0;
  const double before = glm::radians(pose[3]), half = 0.5 * rate * seconds;
  const double chord = std::abs(half) > 1e-9 ? way * std::sin(half) / half : way;
  const double towards = before + half;
  std::array<double, 6> flown = pose;
  flown[0] += chord * std::cos(towards);
  flown[2] += chord * std::sin(towards);
  flown[3] = glm::degrees(before + 2 * half);
  flown[5] = flight.bankDegrees;
  return flown;
}

}  // namespace skydrop::accuracy
