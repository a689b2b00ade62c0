// Which drops and flakes a frame shows around the eye: what falls, in classes of size, and for each class the
// cells of space around the view that hold a drop. Pure functions; any thread. The vertex shader
// (shaders/precipitation/drops.glsl) hashes place and look of a drop from its cell.
//
// A class falls through the air at one speed. Its cells move with it, so that a drop stays in its cell; what
// is in a cell is hashed from the cell's number and from the number of a span of time of kSpanS. At its end a
// set of cells fades and is replaced, so a wind that changes never has to be integrated from the first second
// on; each class has two sets that relieve each other, so as many drops are seen at any moment. Numbers of
// cells and spans are wrapped to 32 bits: nothing repeats within 2^32 cells or spans.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "skydrop/render/frame/view.h"
#include "skydrop/render/precipitation/precipitation_settings.h"
#include "skydrop/weather/state.h"

namespace skydrop::render {

enum class FallKind { rain, snow, sleet, hail };

// Drops of about one size.
struct FallClass {
  FallKind kind = FallKind::rain;
  double diameterMm = 1;
  double speedMps = 4;    // through the air, downwards
  double extinction = 0;  // of all of them, 1/m
};

// Those of what falls at a place: three of rain with a third of its water each, two of snow, one of sleet and
// hail; none of what does not fall. Extinctions sum up to those of shared/precipitation.glsl.
std::vector<FallClass> fallClasses(const weather::Precipitation& fall);

inline constexpr int kMostSets = 14;          // two a class
inline constexpr int kMostDropsASet = 16383;  // whose corners 16-bit indices can name
inline constexpr double kSpanS = 6;

// As in shaders/precipitation/drops.glsl, std140.
struct DropSet {
  glm::vec4 corner;   // xyz: corner of the first cell relative to the eye; w: side of a cell, m
  glm::vec4 passing;  // xyz: velocity relative to the eye, m/s; w: share of the cells that are filled, [0, 1]
  glm::vec4 look;     // diameter (m), cross section that a drop stands for (m^2), most opacity, flutter (m)
  glm::vec4 light;   // of the kind: x: share of the sun's light that goes on forward; y: seconds of the span;
                     // z: least width, pixels
  glm::uvec4 first;  // number of the first cell, wrapped; w: salt of class and span
  glm::ivec4 counts;  // cells along x, y, z; all
};

struct DropSets {
  std::array<DropSet, kMostSets> sets{};
  int count = 0;
  int mostDrops = 0;  // of a set
};

// eyeVelocity, air: m/s, world axes. seconds: simulated, finite.
DropSets dropSets(const PrecipitationSettings& settings, std::span<const FallClass> classes, const View& view,
                  const glm::dvec3& eyeVelocity, const glm::dvec3& air, double seconds);

}  // namespace skydrop::render
