#include "skydrop/render/gl/gpu_resource_tracker.h"

#include <algorithm>
#include <numeric>

namespace skydrop::render::gl {

void GpuResourceTracker::setOwner(std::string_view name) {
  const auto found = std::ranges::find(owners_, name, &OwnerEntry::name);
  owner_ = static_cast<Owner>(found - owners_.begin());
  if (found == owners_.end()) owners_.push_back({std::string(name), {}});
}

OwnedResources GpuResourceTracker::ownedBy(std::string_view name) const {
  const auto found = std::ranges::find(owners_, name, &OwnerEntry::name);
  return found == owners_.end() ? OwnedResources() : found->held;
}

std::int64_t GpuResourceTracker::liveObjects() const {
  return std::accumulate(live_.begin(), live_.end(), std::int64_t{0});
}

PassCounts GpuResourceTracker::total() const {
  PassCounts sum;
  for (const auto& [name, counts] : counts_) {
    sum.draws += counts.draws;
    sum.dispatches += counts.dispatches;
  }
  return sum;
}

void GpuResourceTracker::unknownUniform(std::string_view program, std::string_view uniform) {
  ++unknownUniforms_;
  lastUnknownUniform_ = std::string(program) + ": " + std::string(uniform);
}

}  // namespace skydrop::render::gl
