#include "sky/earth.h"

#include <algorithm>
#include <cmath>

#include "skydrop/core/angles.h"
#include "skydrop/core/deterministic_math.h"

namespace skydrop::sky {
namespace {

namespace dmath = core::dmath;

constexpr double kRadPerArcsecond = dmath::kRadPerDeg / 3600;
constexpr double kEquatorKm = 6378.137, kFlattening = 1 / 298.257223563;  // WGS 84

// Turns axes about x and z: a place's coordinates in axes that were turned by the angle.
glm::dmat3 aboutX(double angle) {
  const double c = dmath::cos(angle), s = dmath::sin(angle);
  return {{1, 0, 0}, {0, c, -s}, {0, s, c}};
}
glm::dmat3 aboutY(double angle) {
  const double c = dmath::cos(angle), s = dmath::sin(angle);
  return {{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
}
glm::dmat3 aboutZ(double angle) {
  const double c = dmath::cos(angle), s = dmath::sin(angle);
  return {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

}  // namespace

double turned(double degrees) { return core::wrappedDegrees(degrees); }

// Nutation by its four largest terms (Meeus, chapter 22): 0.5 seconds of arc in longitude, 0.1 in obliquity.
Earth earthAt(double days) {
  Earth earth;
  const double t = earth.centuries = (days + deltaTSeconds(days) / 86400) / 36525;
  const auto angle = [&](double degrees, double perCentury) {
    return turned(degrees + perCentury * t) * dmath::kRadPerDeg;
  };
  const double node = angle(125.04452, -1934.136261), sun = angle(280.4665, 36000.7698),
               moon = angle(218.3165, 481267.8813);
  earth.nutationRad = (-17.20 * dmath::sin(node) - 1.32 * dmath::sin(2 * sun) - 0.23 * dmath::sin(2 * moon) +
                       0.21 * dmath::sin(2 * node)) *
                      kRadPerArcsecond;
  earth.meanObliquityRad = (84381.448 - t * (46.8150 + t * (0.00059 - t * 0.001813))) * kRadPerArcsecond;
  earth.obliquityRad = earth.meanObliquityRad + (9.20 * dmath::cos(node) + 0.57 * dmath::cos(2 * sun) +
                                                 0.10 * dmath::cos(2 * moon) - 0.09 * dmath::cos(2 * node)) *
                                                    kRadPerArcsecond;
  return earth;
}

// Meeus, chapter 12 (IAU 1982), and the equation of the equinoxes.
double greenwichSiderealDegrees(double days, const Earth& earth) {
  const double t = days / 36525;
  const double mean = 280.46061837 + 360.98564736629 * days + t * t * (0.000387933 - t / 38710000);
  return turned(mean + earth.nutationRad * dmath::cos(earth.obliquityRad) * dmath::kDegPerRad);
}

Observer observerAt(double days, const Earth& earth, const Place& place) {
  Observer observer;
  observer.siderealDegrees = turned(greenwichSiderealDegrees(days, earth) + place.longitudeDegrees);
  const double latitude = std::clamp(place.latitudeDegrees, -90.0, 90.0) * dmath::kRadPerDeg;
  const double sidereal = observer.siderealDegrees * dmath::kRadPerDeg;
  const double sinLat = dmath::sin(latitude), cosLat = dmath::cos(latitude);
  const double sinTime = dmath::sin(sidereal), cosTime = dmath::cos(sidereal);
  const double squash = (1 - kFlattening) * (1 - kFlattening);
  const double normal = kEquatorKm / std::sqrt(cosLat * cosLat + squash * sinLat * sinLat);
  observer.positionKm = {normal * cosLat * cosTime, normal * cosLat * sinTime, normal * squash * sinLat};
  const glm::dvec3 east(-sinTime, cosTime, 0), up(cosLat * cosTime, cosLat * sinTime, sinLat),
      south(sinLat * cosTime, sinLat * sinTime, -cosLat);
  observer.toWorld = glm::transpose(glm::dmat3(east, up, south));
  return observer;
}

// IAU 1976 (Lieske; Meeus, chapter 21).
glm::dmat3 precessionAndNutation(const Earth& earth) {
  const double t = earth.centuries;
  const double zeta = t * (2306.2181 + t * (0.30188 + t * 0.017998)) * kRadPerArcsecond,
               z = t * (2306.2181 + t * (1.09468 + t * 0.018203)) * kRadPerArcsecond,
               theta = t * (2004.3109 - t * (0.42665 + t * 0.041833)) * kRadPerArcsecond;
  const glm::dmat3 precession = aboutZ(-z) * aboutY(theta) * aboutZ(-zeta);
  return aboutX(-earth.obliquityRad) * aboutZ(-earth.nutationRad) * aboutX(earth.meanObliquityRad) *
         precession;
}

glm::dvec3 fromEcliptic(const glm::dvec3& ecliptic, double obliquityRad) {
  return aboutX(-obliquityRad) * ecliptic;
}

}  // namespace skydrop::sky
