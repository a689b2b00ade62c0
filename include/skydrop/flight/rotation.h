// Attitude arithmetic without libm: the exponential map of the rotation group and the angles a pilot reads.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace skydrop::flight {

// The rotation by |v| radians about v, as a unit quaternion; exact for a constant rate however far it turns
// in the step. |v| up to 1e15 is meaningful. Zero gives the identity.
glm::dquat exponentialMap(const glm::dvec3& rotationVector);

// The rotation vector of a unit quaternion, |v| <= pi; the inverse of the above.
glm::dvec3 logarithmMap(const glm::dquat& q);

// Attitude as a pilot reads it. Compass heading in [0, 2 pi), 0 = north (-z), pi/2 = east (+x); pitch of the
// nose above the horizon in [-pi/2, pi/2]; bank, right wing down positive, in (-pi, pi].
struct Attitude {
  double headingRad = 0;
  double pitchRad = 0;
  double bankRad = 0;
};

// Read from a unit quaternion (body forward -z, right +x, up +y). Within 1e-4 degrees up to a pitch of 89.9
// degrees at every heading. Straight up or down heading and bank are one angle: all of it is given to the
// bank-free heading of the belly (up) or the back (down), bank is 0, nothing is undefined.
Attitude attitudeOf(const glm::dquat& orientation);

// The inverse: heading, then pitch, then bank, about the body's own axes.
glm::dquat orientationOf(const Attitude& attitude);

}  // namespace skydrop::flight
