#include "skydrop/render/gl/gpu_resource_tracker.h"

#include <numeric>

namespace skydrop::render::gl {

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
