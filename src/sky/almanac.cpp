#include "skydrop/sky/almanac.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "sky/earth.h"
#include "sky/earth_series.h"
#include "sky/moon_series.h"
#include "skydrop/core/deterministic_math.h"

namespace skydrop::sky {
namespace {

namespace dmath = core::dmath;

constexpr double kRadPerArcsecond = dmath::kRadPerDeg / 3600;
constexpr double kAstronomicalUnitKm = 149597870.7;
constexpr double kSunRadiusKm = 695700, kMoonRadiusKm = 1737.4;
constexpr double kSunUp = -0.8333;  // degrees: refraction of 34 minutes of arc and half a disc

double sum(std::span<const EarthTerm> terms, double millennia) {
  double total = 0;
  for (const EarthTerm& term : terms) total += term.a * dmath::cos(term.b + term.c * millennia);
  return total;
}

glm::dvec3 polar(double longitudeRad, double latitudeRad, double distance) {
  const double across = distance * dmath::cos(latitudeRad);
  return {across * dmath::cos(longitudeRad), across * dmath::sin(longitudeRad),
          distance * dmath::sin(latitudeRad)};
}

// Geocentric, apparent, on the ecliptic of date without nutation.
struct Ecliptic {
  double longitudeRad, latitudeRad, distanceKm;
};

Ecliptic geocentricSun(const Earth& earth) {
  const double t = earth.centuries / 10;
  const double longitude =
      (sum(kEarthL0, t) +
       t * (sum(kEarthL1, t) +
            t * (sum(kEarthL2, t) +
                 t * (sum(kEarthL3, t) + t * (sum(kEarthL4, t) + t * sum(kEarthL5, t)))))) *
      1e-8;
  const double latitude = (sum(kEarthB0, t) + t * sum(kEarthB1, t)) * 1e-8;
  const double radius =
      (sum(kEarthR0, t) +
       t * (sum(kEarthR1, t) + t * (sum(kEarthR2, t) + t * (sum(kEarthR3, t) + t * sum(kEarthR4, t))))) *
      1e-8;
  // From the series' own equinox to that of the FK5, and aberration (Meeus, chapter 25).
  const double corrected = longitude + dmath::kPi - (0.09033 + 20.4898 / radius) * kRadPerArcsecond;
  return {corrected, -latitude, radius * kAstronomicalUnitKm};
}

// Meeus, chapter 47; the light's travel time is in the mean longitude.
Ecliptic geocentricMoon(const Earth& earth) {
  const double t = earth.centuries;
  const auto angle = [](double degrees) { return turned(degrees) * dmath::kRadPerDeg; };
  const double longitude =
      angle(218.3164477 + t * (481267.88123421 + t * (-0.0015786 + t * (1 / 538841.0 - t / 65194000))));
  const double d =
      angle(297.8501921 + t * (445267.1114034 + t * (-0.0018819 + t * (1 / 545868.0 - t / 113065000))));
  const double m = angle(357.5291092 + t * (35999.0502909 + t * (-0.0001536 + t / 24490000)));
  const double n =
      angle(134.9633964 + t * (477198.8675055 + t * (0.0087414 + t * (1 / 69699.0 - t / 14712000))));
  const double f =
      angle(93.2720950 + t * (483202.0175233 + t * (-0.0036539 + t * (-1 / 3526000.0 + t / 863310000))));
  const double venus = angle(119.75 + 131.849 * t), jupiter = angle(53.09 + 479264.290 * t),
               flattening = angle(313.45 + 481266.484 * t);
  // The sun's share shrinks with the eccentricity of the earth's orbit.
  const double eccentricity = 1 - t * (0.002516 + t * 0.0000074);
  const auto weight = [&](int ofSun) {
    return ofSun == 0 ? 1 : ofSun == 1 || ofSun == -1 ? eccentricity : eccentricity * eccentricity;
  };
  double along = 3958 * dmath::sin(venus) + 1962 * dmath::sin(longitude - f) + 318 * dmath::sin(jupiter);
  double distance = 0;
  for (const MoonTerm& term : kMoonLongitudeAndDistance) {
    const double argument = term.d * d + term.m * m + term.n * n + term.f * f;
    along += term.longitude * weight(term.m) * dmath::sin(argument);
    distance += term.distance * weight(term.m) * dmath::cos(argument);
  }
  double across = -2235 * dmath::sin(longitude) + 382 * dmath::sin(flattening) +
                  175 * (dmath::sin(venus - f) + dmath::sin(venus + f)) + 127 * dmath::sin(longitude - n) -
                  115 * dmath::sin(longitude + n);
  for (const MoonLatitudeTerm& term : kMoonLatitude) {
    const double argument = term.d * d + term.m * m + term.n * n + term.f * f;
    across += term.latitude * weight(term.m) * dmath::sin(argument);
  }
  return {longitude + along * 1e-6 * dmath::kRadPerDeg, across * 1e-6 * dmath::kRadPerDeg,
          385000.56 + distance * 1e-3};
}

glm::dvec3 equatorialKm(const Ecliptic& place, const Earth& earth) {
  return fromEcliptic(polar(place.longitudeRad + earth.nutationRad, place.latitudeRad, place.distanceKm),
                      earth.obliquityRad);
}

// `seen`: from the observer, equatorial axes of date.
Body bodyAt(const glm::dvec3& seen, const Observer& observer, double radiusKm) {
  Body body;
  body.horizontal = horizontalOf(observer.toWorld * seen);
  const double across = std::sqrt(seen.x * seen.x + seen.y * seen.y);
  body.rightAscensionDegrees = turned(dmath::atan2(seen.y, seen.x) * dmath::kDegPerRad);
  body.declinationDegrees = dmath::atan2(seen.z, across) * dmath::kDegPerRad;
  body.hourAngleDegrees = turned(observer.siderealDegrees - body.rightAscensionDegrees + 180) - 180;
  body.distanceKm = glm::length(seen);
  body.radiusDegrees = dmath::asin(radiusKm / body.distanceKm) * dmath::kDegPerRad;
  return body;
}

double angleOf(double left, double up) { return turned(dmath::atan2(left, up) * dmath::kDegPerRad); }

}  // namespace

glm::dvec3 worldDirection(const Horizontal& place) {
  const double azimuth = place.azimuthDegrees * dmath::kRadPerDeg,
               elevation = place.elevationDegrees * dmath::kRadPerDeg;
  const double across = dmath::cos(elevation);
  return {across * dmath::sin(azimuth), dmath::sin(elevation), -across * dmath::cos(azimuth)};
}

Horizontal horizontalOf(const glm::dvec3& given) {
  // Lengths whose squares are no doubles go first.
  const double largest = std::max({std::abs(given.x), std::abs(given.y), std::abs(given.z)});
  const bool isPlain = largest > 1e-140 && largest < 1e140;
  const glm::dvec3 direction = isPlain ? given : given / largest;
  const double across = std::sqrt(direction.x * direction.x + direction.z * direction.z);
  constexpr double kNoAzimuth = 1e-12;  // what a double's rounding leaves of a vertical direction
  return {across > kNoAzimuth * std::abs(direction.y)
              ? turned(dmath::atan2(direction.x, -direction.z) * dmath::kDegPerRad)
              : 0,
          dmath::atan2(direction.y, across) * dmath::kDegPerRad};
}

glm::dvec3 equatorialDirection(double rightAscensionDegrees, double declinationDegrees) {
  return polar(rightAscensionDegrees * dmath::kRadPerDeg, declinationDegrees * dmath::kRadPerDeg, 1);
}

Body sunAt(double days, const Place& place) {
  const Earth earth = earthAt(days);
  const Observer observer = observerAt(days, earth, place);
  return bodyAt(equatorialKm(geocentricSun(earth), earth) - observer.positionKm, observer, kSunRadiusKm);
}

Body moonAt(double days, const Place& place) {
  const Earth earth = earthAt(days);
  const Observer observer = observerAt(days, earth, place);
  return bodyAt(equatorialKm(geocentricMoon(earth), earth) - observer.positionKm, observer, kMoonRadiusKm);
}

MoonPhase moonPhase(double days, const Place& place) {
  const Earth earth = earthAt(days);
  const Observer observer = observerAt(days, earth, place);
  const Ecliptic sunPlace = geocentricSun(earth), moonPlace = geocentricMoon(earth);
  const glm::dvec3 sun = equatorialKm(sunPlace, earth) - observer.positionKm,
                   moon = equatorialKm(moonPlace, earth) - observer.positionKm;
  MoonPhase result;
  result.phase = turned((moonPlace.longitudeRad - sunPlace.longitudeRad) * dmath::kDegPerRad) / 360;
  const glm::dvec3 toSun = glm::normalize(sun - moon), toMoon = glm::normalize(moon);
  result.illuminatedFraction = std::clamp((1 - glm::dot(toSun, toMoon)) / 2, 0.0, 1.0);
  const glm::dvec3 east(-toMoon.y, toMoon.x, 0), north = glm::cross(toMoon, east);
  result.brightLimbDegrees = angleOf(glm::dot(toSun, east), glm::dot(toSun, north));
  // As the elevation grows, also at the zenith, where the azimuth is 0 by definition.
  const glm::dvec3 moonInWorld = observer.toWorld * toMoon, sunInWorld = observer.toWorld * toSun;
  Horizontal above = horizontalOf(moonInWorld);
  above.elevationDegrees += 90;
  const glm::dvec3 up = worldDirection(above), left = glm::cross(up, moonInWorld);
  result.brightLimbTiltDegrees = angleOf(glm::dot(sunInWorld, left), glm::dot(sunInWorld, up));
  return result;
}

const char* phaseName(double phase) {
  constexpr const char* kNames[] = {"new moon",  "waxing crescent", "first quarter", "waxing gibbous",
                                    "full moon", "waning gibbous",  "last quarter",  "waning crescent"};
  constexpr double kHalf = 1.0 / 60;  // of what counts as a point of the cycle
  const double share = phase - std::floor(phase);
  for (int quarter = 0; quarter <= 4; ++quarter) {
    if (share < quarter / 4.0 - kHalf) return kNames[2 * quarter - 1];
    if (share <= quarter / 4.0 + kHalf) return kNames[2 * quarter % 8];
  }
  return kNames[0];
}

Twilight twilightOf(double elevation) {
  if (elevation >= kSunUp) return Twilight::day;
  if (elevation >= -6) return Twilight::civil;
  if (elevation >= -12) return Twilight::nautical;
  return elevation >= -18 ? Twilight::astronomical : Twilight::night;
}

const char* twilightName(Twilight twilight) {
  constexpr const char* kNames[] = {"day", "civil", "nautical", "astronomical", "night"};
  return kNames[static_cast<int>(twilight)];
}

double siderealDegrees(double days, double longitudeDegrees) {
  return turned(greenwichSiderealDegrees(days, earthAt(days)) + longitudeDegrees);
}

glm::dmat3 j2000ToWorld(double days, const Place& place) {
  const Earth earth = earthAt(days);
  return observerAt(days, earth, place).toWorld * precessionAndNutation(earth);
}

}  // namespace skydrop::sky
