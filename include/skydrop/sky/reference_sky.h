// The light of the shell of air (shaders/shared/atmosphere_shell.glsl) worked out in double precision without
// tables of it: what the models of the game are measured against. Slow; for studies and tests.
//
// Light scattered once is a sum of midpoints, whose error falls with the square of the number of steps; light
// scattered more often is an estimate by random paths with its standard error (reference_paths.h). All is per
// irradiance of the light outside the air, 1/sr. The light's disc (0.267 degrees) is taken as a point, but
// for its setting behind the ground.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "skydrop/core/shared.h"

namespace skydrop::sky {

// What is looked along, and where the light stands.
struct ReferenceRay {
  double heightM = 0;     // of the eye, >= 0
  double sine = 0;        // of the ray's elevation, [-1, 1]
  double cosAzimuth = 1;  // of the angle between the azimuths of ray and light, [-1, 1]
  double sunSine = 1;     // of the light's elevation, [-1, 1]
};

struct ReferenceEstimate {
  glm::dvec3 mean{0};   // red, green, blue
  glm::dvec3 error{0};  // standard error of the mean
};

// Length of the ray to the ground or the end of the air, m; cosine of its angle with the light.
double endOf(const ReferenceRay& ray);
double betweenOf(const ReferenceRay& ray);

// Pure functions, from any thread. The constructor takes about half a second.
class ReferenceSky {
 public:
  explicit ReferenceSky(const core::shared::f64::Atmosphere& air);

  // Of light from outside the air down to a height; 0 where the ground is in the way.
  glm::dvec3 transmittance(double heightM, double cosine, int steps) const;
  // Light that was scattered once.
  glm::dvec3 once(const ReferenceRay& ray, int steps) const;
  // Light that was scattered, or sent back by ground of albedo kGroundAlbedo, more than once
  // (ReferencePaths::upTo).
  ReferenceEstimate often(const ReferenceRay& ray, int paths, std::uint64_t seed) const;

 private:
  friend class ReferencePaths;

  glm::dvec3 depth(double heightM, double cosine, int steps) const;
  glm::dvec3 sunLight(double heightM, double cosine) const;  // by the table
  void makeExpected();
  glm::dvec3 expected(double heightM, double sunSine) const;

  core::shared::f64::Atmosphere air_;
  std::vector<glm::dvec3> depths_;  // of rays to the end of the air, for paths
  // Mean radiance of light scattered before, about: what paths are led by. By height and light's elevation.
  std::vector<glm::dvec3> expected_;
};

}  // namespace skydrop::sky
