// Contact with land and sea, found between steps and not only at their ends. Pure functions of the height
// source: they work anywhere, whether or not a chunk is loaded there.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "skydrop/terrain/height_source.h"

namespace skydrop::game {

// What can be touched: the land, or the sea at 0 above it. Metres.
struct Surface {
  double height = 0;
  bool water = false;
};
Surface surfaceAt(const terrain::HeightSource& ground, const glm::dvec2& xz);

// Height of a point above the surface, m; negative below it.
double clearanceAt(const terrain::HeightSource& ground, const glm::dvec3& position);

struct Contact {
  double fraction = 0;     // of the way from `from` to `to`, [0, 1]
  glm::dvec3 position{0};  // there: `margin` above the surface, never below it
  bool water = false;
};

// The first point of the straight way from..to that is `margin` (m, >= 0) or less above the surface; none
// when the way stays clear. Within 1 mm along the way, on land that is nowhere steeper than kSteepestSlope;
// an end of land steeper than that (a cliff) within kContactGrain once the way is close to it. A start that
// is already too low is a contact at 0, lifted onto the surface. The clearances are the heights of both ends
// above the surface, which a caller has anyway (clearanceAt). Ways above 200 m are looked at in 10 000
// pieces.
std::optional<Contact> sweepContact(const terrain::HeightSource& ground, const glm::dvec3& from,
                                    const glm::dvec3& to, double margin, double clearanceAtFrom,
                                    double clearanceAtTo);

// Land steeper than this (83 degrees) can be flown into unseen for a moment: the shipped land stays below 4.
inline constexpr double kSteepestSlope = 8;
// Close to the ground the way is looked at this often, m.
inline constexpr double kContactGrain = 0.02;

}  // namespace skydrop::game
