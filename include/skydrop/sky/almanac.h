// Where sun, moon and stars stand, by place and time. Pure functions, from any thread; the same bits on every
// machine (core/deterministic_math.h). Sources: J. Meeus, "Astronomical algorithms", 2nd edition, 1998 (his
// chapters below); I. Reda, A. Andreas, "Solar position algorithm", 2004.
//
// Times are days of UTC since 2000-01-01T12:00:00Z (instant.h); UTC counts as the time of the earth's
// rotation (UT1), from which it is at most 0.9 s away: 14 seconds of arc in azimuth. Angles are degrees.
// Equatorial places are apparent (with aberration and nutation) and refer to equinox and equator of date;
// they, the distances and all else are as seen from the observer's place on the ellipsoid of the earth at sea
// level (topocentric) unless told otherwise. Elevations are geometric, without refraction (refraction.h).
//
// Errors, against Skyfield with DE421 from 1950 to 2050: docs/sky.md. Beyond, hours of azimuth are lost by
// the year 1000: nobody knows the earth's rotation better than some minutes then.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "skydrop/sky/instant.h"

namespace skydrop::sky {

// At sea level. Any finite angles; latitudes beyond a pole are taken as the pole.
struct Place {
  double latitudeDegrees = 0;   // geodetic, north
  double longitudeDegrees = 0;  // east
};

// Compass azimuth, [0, 360): 0 north, 90 east; elevation [-90, 90]. At zenith and nadir the azimuth is 0. At
// a pole north is where the meridian of the place's longitude leads to (as if latitude came within a hair of
// it).
struct Horizontal {
  double azimuthDegrees = 0;
  double elevationDegrees = 0;
};

// As a unit vector of the world: +x east, +y up, -z north.
glm::dvec3 worldDirection(const Horizontal& place);
Horizontal horizontalOf(const glm::dvec3& worldDirection);  // of any length but 0

struct Body {
  Horizontal horizontal;
  double rightAscensionDegrees = 0;  // [0, 360)
  double declinationDegrees = 0;
  double hourAngleDegrees = 0;  // [-180, 180), positive in the west
  double distanceKm = 0;        // to the observer
  double radiusDegrees = 0;     // of the disc
};

// Heliocentric longitude and latitude of the earth by the series of Bretagnon's VSOP87 as Meeus (appendix 3)
// shortened them.
Body sunAt(double days, const Place& place);

// By Meeus's (chapter 47) shortened form of Chapront's ELP-2000/82.
Body moonAt(double days, const Place& place);

// What of the moon is lit, and how it lies.
struct MoonPhase {
  // Share of the cycle, [0, 1): 0 new, 1/4 first quarter, 1/2 full, 3/4 last quarter. The difference of the
  // geocentric apparent ecliptic longitudes of moon and sun, as almanacs define the phases.
  double phase = 0;
  double illuminatedFraction = 0;  // of the disc, [0, 1]
  // Where the middle of the bright limb is, from the centre of the disc: counter-clockwise as one sees it,
  // from the direction to the celestial north pole and from that to the zenith. [0, 360). The first quarter
  // on the meridian of Europe has its tilt near 270: bright on the right. 0 where the sun is exactly behind
  // or opposite.
  double brightLimbDegrees = 0;
  double brightLimbTiltDegrees = 0;
};
MoonPhase moonPhase(double days, const Place& place);

// "new moon", "waxing crescent", ... ; the four points of the cycle hold a day or so (1/30 of it).
const char* phaseName(double phase);

// By the sun's geometric elevation: day above -0.833 (its upper edge is seen above the horizon), then -6,
// -12, -18.
enum class Twilight { day, civil, nautical, astronomical, night };
Twilight twilightOf(double sunElevationDegrees);
const char* twilightName(Twilight twilight);

// Hour angle of the equinox at the place: local apparent sidereal time as an angle, [0, 360).
double siderealDegrees(double days, double longitudeDegrees);

// Mean equinox and equator of J2000 (the frame of star catalogues) to axes of the world at the place:
// precession, nutation, rotation of the earth. Takes directions of stars to where they stand, without
// aberration (20 seconds of arc) and parallax.
glm::dmat3 j2000ToWorld(double days, const Place& place);

// The unit vector of a right ascension and a declination, and the place of the equator's own axes in the
// world: x to the equinox, z to the pole.
glm::dvec3 equatorialDirection(double rightAscensionDegrees, double declinationDegrees);

}  // namespace skydrop::sky
