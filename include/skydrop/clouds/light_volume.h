// Light that was scattered in a cloud layer, everywhere in a period of its weather: solved on a coarse grid
// by source iteration over discrete directions (Chandrasekhar 1950; Lathrop and Carlson 1966), for what a
// march adds to the exact light scattered once. Immutable; any thread.
#pragma once

#include <array>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

class LightVolume {
 public:
  static constexpr int kSide = 256;    // cells of a weather period, east and south, unless told: the most
  static constexpr int kMinSide = 32;  // the fewest
  static constexpr int kRows = 16;     // from the base of the layer to its top
  static constexpr int kIterations = 16;

  // The field without drift. `side` is a power of two, kMinSide .. kSide: half as many cells take a
  // quarter of the time, which is about 1 s of one core with kSide. The sun lights nothing at the horizon and
  // below; else its way is that of raisedSun(). A stop that is requested leaves it unsolved (isSolved()).
  LightVolume(const CloudField& field, const glm::dvec3& toSun, int side = kSide, std::stop_token stop = {});

  struct Texel;
  // A square of so many cells (a power of two from kMinPart on) of the `side` across a period, beginning with
  // `first`, x and z, solved alone: as if it repeated, so light comes in over its edge from the other one.
  // Empty after a stop.
  static std::vector<Texel> part(const CloudField& field, const glm::dvec3& toSun, int side,
                                 const glm::ivec2& first, int cells, std::stop_token stop = {});
  static constexpr int kMinPart = 16;

  bool isSolved() const { return isSolved_; }
  int side() const { return side_; }

  // In a cell: mean radiance of what the sun sent and cloud has scattered; of all light of the sky, scattered
  // or not: per illuminance of each source, 1/sr.
  struct Texel {
    float sun = 0, sky = 0;
    // Of the ground. Nothing absorbs: of even light from above and below there is as much in cloud as
    // outside.
    float ground() const { return 1 / glm::pi<float>() - sky; }
  };
  // x fastest, then row, then z.
  std::span<const Texel> texels() const { return texels_; }
  // Trilinear between middles of cells; repeats east and south, and keeps its lowest and highest row beyond.
  Texel at(const glm::dvec3& place) const;

 private:
  int side_;
  double baseM_, thicknessM_, periodM_;
  std::vector<Texel> texels_;  // none where a stop left it unsolved
  bool isSolved_ = false;
};

}  // namespace skydrop::clouds
