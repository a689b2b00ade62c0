// The march through a cloud layer in double precision, on the processor: what the compute shader is judged
// by. No grid, no skipping, no tiers: steps of one length, midpoint samples, the analytic integral over each
// step, all of the way to the sun sampled again at every step. Any thread.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "skydrop/clouds/cloud_field.h"

namespace skydrop::clouds {

// A ray from the eye: metres, unit direction, [beginM, endM] of it.
struct MarchRay {
  glm::dvec3 origin{0};
  glm::dvec3 direction{0, 0, -1};
  double beginM = 0;
  double endM = 1e30;  // where the scene's surface is
};

struct MarchLight {
  // Unit; for the way through the layer a sine of its elevation below kLeastSunSine is raised to it. At the
  // horizon and below the sun lights nothing.
  glm::dvec3 toSun{0, 1, 0};
  double anisotropy = 0;    // g, [-0.95, 0.95]
  double forwardShare = 0;  // [0, 1]
};

struct MarchSteps {
  int steps = 2048;
  int sunSamples = 128;
};

// Light that a ray brings, per illuminance of each source (1/sr), and what is left of the light behind it.
struct MarchResult {
  double sun = 0, sky = 0, ground = 0;
  double transmittance = 1;
  double distanceM = 1e30;  // mean of where the light comes from; the far marker where there is no cloud
};

// A medium: extinction (1/m, >= 0) at a place, between two heights, out to a distance from the eye.
struct MarchMedium {
  std::function<double(const glm::dvec3&)> extinction;
  double baseM = 0, topM = 0;
  double fadeDistanceM = 1e30;
  bool isShell = false;  // around the earth, which falls away from the eye (rayBend()); else a flat layer
};
MarchMedium mediumOf(const CloudField& field);  // the field has to outlive it

// No steps, no length or a layer without thickness leave the background. Directions that are not of length 1
// throw core::RangeError. In a smooth medium errors fall with the square of both numbers of steps; in the
// default clouds 2048 x 128 is within 5e-4 of 8192 x 512 and takes 2 ms a ray in the mean, 15 ms in thick
// cloud.
MarchResult referenceMarch(const MarchMedium& medium, const MarchLight& light, const MarchRay& ray,
                           const MarchSteps& steps = {});

// What the march knows of a sample.
struct LitPlace {
  glm::dvec3 place{0};
  double heightFraction = 0;  // in the layer
  double sunDepth = 0;        // optical depth towards the sun
  double extinction = 0;      // 1/m
  glm::dvec4 sunPhases{0};    // of the ray: cloudPhases()
  double sunCosine = 0;       // between the ray and the way to the sun
};
// Light of sun, sky and ground that turns into the ray there, per illuminance of each (1/sr).
using ScatteredLight = std::function<glm::dvec3(const LitPlace&)>;
// The game's octaves, and even light of sky and ground.
glm::dvec3 octavesOfLight(const LitPlace& at);

// The same with another model of scattered light, which is asked with a sun at the horizon and below too,
// where the sun's part is not used.
MarchResult referenceMarch(const MarchMedium& medium, const MarchLight& light, const MarchRay& ray,
                           const MarchSteps& steps, const ScatteredLight& scattered);

// Optical depth from a place to the top of the layer, towards the sun. Parts as sunPartBegin() cuts them.
double sunDepth(const MarchMedium& medium, const glm::dvec3& toSun, const glm::dvec3& place, int samples);

}  // namespace skydrop::clouds
