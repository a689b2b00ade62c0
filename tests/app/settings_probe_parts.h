// Parts of settingsProbes(), and what several of them need.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "app/settings_probes.h"
#include "skydrop/core/hash.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::app {

// Of flights: aircraft, packages, gear, pilots, and weather that is flown in.
std::vector<Probe> flightProbes();
// Of the land: its shape, data, streaming, and what stands on it.
std::vector<Probe> landProbes();

// The land of the default settings.
inline const std::shared_ptr<const terrain::HeightSource>& probedLand() {
  static const auto source = terrain::makeNoiseHeightSource(terrain::TerrainSettings(), 1);
  return source;
}

inline void add(core::StateHasher& h, const glm::dvec3& v) { h.add(v.x), h.add(v.y), h.add(v.z); }
inline void add(core::StateHasher& h, const glm::dquat& q) { h.add(q.x), h.add(q.y), h.add(q.z), h.add(q.w); }

}  // namespace skydrop::app
