#include "skydrop/flight/rotation.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "skydrop/core/deterministic_math.h"

namespace skydrop::flight {

namespace dmath = core::dmath;

glm::dquat exponentialMap(const glm::dvec3& v) {
  const double z = glm::dot(v, v) * 0.25;  // square of half the angle
  double cosine = 0, sineOverAngle = 0;    // cos(a/2), sin(a/2)/a
  if (z < 0.0625) {
    // A step of a flying body: Taylor series in z, the next term is below 1e-18.
    cosine =
        1 + z * (-1 / 2.0 +
                 z * (1 / 24.0 +
                      z * (-1 / 720.0 + z * (1 / 40320.0 + z * (-1 / 3628800.0 + z * (1 / 479001600.0 -
                                                                                      z / 87178291200.0))))));
    sineOverAngle =
        0.5 * (1 + z * (-1 / 6.0 +
                        z * (1 / 120.0 +
                             z * (-1 / 5040.0 +
                                  z * (1 / 362880.0 + z * (-1 / 39916800.0 +
                                                           z * (1 / 6227020800.0 - z / 1307674368000.0)))))));
  } else {
    const double half = std::sqrt(z);
    cosine = dmath::cos(half);
    sineOverAngle = 0.5 * dmath::sin(half) / half;
  }
  return {cosine, sineOverAngle * v.x, sineOverAngle * v.y, sineOverAngle * v.z};
}

glm::dvec3 logarithmMap(const glm::dquat& q) {
  const double sign = q.w < 0 ? -1 : 1;  // q and -q are the same rotation; take the short way
  const glm::dvec3 axis = glm::dvec3(q.x, q.y, q.z) * sign;
  const double sine = glm::length(axis);
  if (sine < 1e-12) return 2.0 * axis;
  return axis * (2 * dmath::atan2(sine, q.w * sign) / sine);
}

Attitude attitudeOf(const glm::dquat& q) {
  const glm::dvec3 forward = q * glm::dvec3(0, 0, -1), right = q * glm::dvec3(1, 0, 0),
                   up = q * glm::dvec3(0, 1, 0);
  const double level = std::sqrt(forward.x * forward.x + forward.z * forward.z);  // cosine of the pitch
  Attitude out;
  // atan2 of sine and cosine keeps its precision near +-90 degrees, where asin loses half the digits.
  out.pitchRad = dmath::atan2(forward.y, level);
  if (level > 1e-9) {
    out.headingRad = dmath::atan2(forward.x, -forward.z);
    out.bankRad = dmath::atan2(-right.y, up.y);
    if (out.bankRad <= -dmath::kPi) out.bankRad = dmath::kPi;  // upside down, with -0 or what rounds to it
  } else {
    const double sense = forward.y > 0 ? -1 : 1;  // nose up: the belly points along the heading
    out.headingRad = dmath::atan2(sense * up.x, -sense * up.z);
  }
  if (out.headingRad < 0) out.headingRad += dmath::kTwoPi;
  if (out.headingRad >= dmath::kTwoPi) out.headingRad = 0;
  return out;
}

glm::dquat orientationOf(const Attitude& a) {
  // Body axes at identity: forward north. A compass heading turns clockwise seen from above: about -y.
  const glm::dquat heading = exponentialMap({0, -a.headingRad, 0});
  const glm::dquat pitch = exponentialMap({a.pitchRad, 0, 0});
  const glm::dquat bank = exponentialMap({0, 0, -a.bankRad});
  return glm::normalize(heading * pitch * bank);
}

}  // namespace skydrop::flight
