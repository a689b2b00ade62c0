// Light that was scattered, or sent back by the ground, more than once, as one ray of a reference sky
// (reference_sky.h) sees it: an estimate by random paths.
//
// At each place of a path all light that was scattered once on the way to it in one direction is summed, not
// sampled at a point, so that light far away in thin air is met at twilight. Places and directions are chosen
// by how much light is expected from there (the game's own tables, lobes about the horizon and the light):
// that decides how sure the mean is, and not what it is. Paths are points of a lattice, moved at random
// (Cools, Kuo and Nuyens, "Constructing embedded lattice rules for multivariate integration", 2006).
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/sky/reference_sky.h"

namespace skydrop::sky {

// Light is per irradiance of the light outside the air, 1/sr. One thread; `sky` must outlive it.
class ReferencePaths {
 public:
  // Equal seeds give equal paths.
  ReferencePaths(const ReferenceSky& sky, const ReferenceRay& ray, std::uint64_t seed);

  // Of the first so many paths, at least kGroups; not fewer than it was last asked for. Takes 4 us a path.
  ReferenceEstimate upTo(int paths);

 private:
  // With a lattice of their own, moved apart from each other: their means tell the error.
  static constexpr int kGroups = 2;

  class Point;
  struct Place;
  struct Sight;

  glm::dvec3 pathOf(Point& point) const;
  Place firstPlace(double share) const;
  Sight look(const Place& from, const glm::dvec3& direction, double offset) const;
  bool chooseNext(const Sight& sight, double share, Place& place) const;
  glm::dvec3 chooseDirection(Place& place, double share, double azimuth) const;

  const ReferenceSky* sky_;
  std::uint64_t seed_;
  glm::dvec3 toSun_, direction_, eye_;
  double length_;  // of the ray, m
  // Of the ray's steps: what the first scattering is chosen by, summed up; transmittance to their beginnings.
  std::vector<double> chances_;
  std::vector<glm::dvec3> left_;
  glm::dvec3 weigh_{1};  // makes the expected light of all channels alike
  std::array<glm::dvec3, kGroups> sums_{};
  int ofGroup_ = 0;  // paths in the sums
};

}  // namespace skydrop::sky
