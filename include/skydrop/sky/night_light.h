// How brightly stars and moon shine on a surface that faces them, above the atmosphere. Pure functions, from
// any thread. Illuminance is in kilolux, colours are linear sRGB.
#pragma once

#include <glm/vec3.hpp>

namespace skydrop::sky {

// By visual magnitude: 2.56e-9 klx at magnitude 0 (Allen, "Astrophysical quantities", 1973, section 94).
double illuminanceOfMagnitude(double magnitude);

// Colour of luminance 1 of a star with this B-V, [-0.4, 6]: a black body of the temperature of Ballesteros
// (2012), with the chromaticity of Kim and others (2002).
glm::dvec3 starColor(double colorIndex);

// By the moon: phaseAngleDegrees between the directions to sun and observer as seen from it (0: full, 180:
// new), distanceKm > 0 to the observer. Magnitude by Allen (1976): 3.2e-4 klx when full, a ninth of it at a
// quarter.
double moonIlluminance(double phaseAngleDegrees, double distanceKm);

// Radiance, kcd/m^2, of a matt moon's disc where its surface is lit and seen at a slant alike, so that the
// whole disc sends moonIlluminance(): Lommel and Seeliger's law, whose disc as a whole follows in closed
// form.
double moonRadiance(double phaseAngleDegrees, double distanceKm);

// Of all the light of the disc at phase angle 0, the share at this one by Lommel and Seeliger's law: 1 to 0.
double lommelSeeligerShare(double phaseAngleDegrees);

inline constexpr double kMoonRadiusKm = 1737.4;

}  // namespace skydrop::sky
