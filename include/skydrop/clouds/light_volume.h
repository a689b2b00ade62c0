// Light that was scattered in a cloud layer, everywhere in a period of its weather: solved on a coarse grid
// by source iteration over discrete directions (Chandrasekhar 1950; Lathrop and Carlson 1966), for what a
// march adds to the exact light scattered once. Immutable; any thread.
#pragma once

#include <array>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

class LightVolume {
 public:
  static constexpr int kSide = 256;  // cells of a weather period, east and south
  static constexpr int kRows = 16;   // from the base of the layer to its top
  static constexpr int kIterations = 16;

  // The field without drift. The sun lights nothing at the horizon and below; else its way is that of
  // raisedSun(). Takes about 1 s of one core; a stop that is requested leaves it unsolved (isSolved()).
  LightVolume(const CloudField& field, const glm::dvec3& toSun, std::stop_token stop = {});

  bool isSolved() const { return isSolved_; }

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
  double baseM_, thicknessM_, periodM_;
  bool isSolved_ = false;
  std::vector<Texel> texels_;
};

}  // namespace skydrop::clouds
