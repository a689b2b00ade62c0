// The judge of light in clouds: paths of light through a layer's medium by Monte Carlo, in doubles, on the
// processor. It shares the medium and the phase function with the game and no approximation of scattering:
// free paths by weighted delta tracking and light of the sun by ratio tracking (Galtier and others 2013;
// Novák, Selle and Jarosz 2014), both exact in the mean whatever the bounds of extinction. The layer is flat.
// Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/extinction_bounds.h"
#include "skydrop/clouds/reference_march.h"
#include "skydrop/core/hash.h"

namespace skydrop::core {
class JobPool;
}

namespace skydrop::clouds {

// Henyey and Greenstein (1941) in two lobes, as the first of the march's octaves.
struct TracedPhase {
  double anisotropy = 0;         // g, [-0.95, 0.95]
  double forwardShare = 0;       // [0, 1], of the light: goes into the forward lobe
  double forwardAnisotropy = 0;  // its g
  double albedo = 1;             // [0, 1], of each scattering
};
TracedPhase tracedPhaseOf(const CloudLayerSettings& layer);

struct TracedMedium {
  std::function<double(const glm::dvec3&)> extinction;  // 1/m, >= 0, 0 outside base and top
  double baseM = 0, topM = 0;
  std::shared_ptr<const ExtinctionBounds> bounds;
};
// The field has to outlive it. Cells of 100 m by 75 m.
TracedMedium tracedMediumOf(const CloudField& field);
// One extinction from base to top.
TracedMedium homogeneousMedium(double extinction, double baseM, double topM);

// As MarchResult: scattered light per illuminance of each source (1/sr): a sun without size, a sky and a
// ground that are even and fill half of all directions each. The ground sends light back; it reflects none.
struct TracedLight {
  double sun = 0, sky = 0, ground = 0;
  double transmittance = 1;
};

// One path from the eye. The sun lights nothing at the horizon and below; its way through the layer is that
// of raisedSun(), as in the march. Draws from the stream; a path ends at the layer's borders, or after
// 1000 km without an event.
TracedLight tracePath(const TracedMedium& medium, const TracedPhase& phase, const glm::dvec3& toSun,
                      const MarchRay& ray, core::RandomStream& random);

// What is left of light between a place and the border of the layer, or `lengthM` on: right in the mean.
double ratioTrackedTransmittance(const TracedMedium& medium, const glm::dvec3& place,
                                 const glm::dvec3& direction, double lengthM, core::RandomStream& random);

struct TracedPixel {
  TracedLight mean, error;  // error: one standard error of the mean
};

// The mean of so many paths for each ray: a function of the arguments, whoever works on it. A pool shares the
// rays out; null: this thread does it all. Do not call it on a worker of the pool. Directions that are not
// of length 1, and less than two paths, throw core::RangeError.
std::vector<TracedPixel> traceRays(const TracedMedium& medium, const TracedPhase& phase,
                                   const glm::dvec3& toSun, std::span<const MarchRay> rays, int paths,
                                   std::uint64_t seed, core::JobPool* pool = nullptr);

}  // namespace skydrop::clouds
