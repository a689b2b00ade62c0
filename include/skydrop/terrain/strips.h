// Grass strips: runways at hashed places, levelled out of the land where it is gentle enough.
//
// The world is cut into cells of kStripCell; each has one strip or none. Where it lies is hashed from the
// cell and the seed, in a few tries: the first of them is taken whose ground is gentle (within kMostCut of a
// plane that rises by at most kMostStripSlope, above the sea, no steeper than kMostStripGround) and whose
// approach is free. On the strip the land is that plane; over kStripMargin around it the two are blended by a
// quintic, so that slopes stay continuous and below kMostStripGround + 1.875 * kMostCut / kStripMargin.
// Immutable: any thread; what has been found is remembered.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "skydrop/core/settings.h"
#include "skydrop/terrain/height_source.h"

namespace skydrop::terrain {

inline constexpr double kStripCell = 8192;       // m
inline constexpr double kStripMargin = 80;       // m
inline constexpr double kMostCut = 5;            // m that are cut or filled
inline constexpr double kMostStripSlope = 0.02;  // m a metre, along it
inline constexpr double kMostStripGround = 0.2;  // m a metre, of the land before
inline constexpr double kStripApproach =
    2000;  // m before its beginning that are free: below a rise of 1 : 25

struct StripSettings {
  double length = 600;  // m, 200 .. 1500
  double width = 40;    // m, 10 .. 120
  double density =
      0;  // share of the cells that may have one, 0 .. 1; at 0 there are none, and the land is as it was
};

void describe(core::SettingsVisitor& visitor, StripSettings& settings);

struct Strip {
  glm::dvec2 middle{0};                     // x, z, m
  double height = 0;                        // of the middle, m
  glm::dvec2 along{0, -1};                  // unit: the way one lands, over the free approach
  double slope = 0;                         // m a metre, that way
  double halfLength = 300, halfWidth = 20;  // m, of what is mown
  bool bothWays = false;                    // the other approach is free too

  // Metres along and to the right of the middle.
  glm::dvec2 local(const glm::dvec2& xz) const {
    const glm::dvec2 d = xz - middle;
    return {d.x * along.x + d.y * along.y, d.y * along.x - d.x * along.y};
  }
  glm::dvec2 world(double metresAlong, double right) const {
    return middle + along * metresAlong + glm::dvec2(-along.y, along.x) * right;
  }
  double heightAt(double metresAlong) const { return height + slope * metresAlong; }
  bool contains(const glm::dvec2& xz) const;
  double headingRad() const;  // compass, [0, 2 pi)
  // The same strip landed on the other way.
  Strip reversed() const;
};

class Strips {
 public:
  virtual ~Strips() = default;
  // The one whose mown ground holds the place.
  virtual std::optional<Strip> at(const glm::dvec2& xz) const = 0;
  // The one whose middle is nearest, within `reach` metres (at most 60 000).
  virtual std::optional<Strip> nearest(const glm::dvec2& xz, double reach) const = 0;
};

// The land with strips. Throws core::RangeError when a setting is outside its described range.
std::shared_ptr<const HeightSource> makeLandWithStrips(std::shared_ptr<const HeightSource> land,
                                                       const StripSettings& settings, std::uint64_t seed);

}  // namespace skydrop::terrain
