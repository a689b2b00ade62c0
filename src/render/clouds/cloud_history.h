// What the last frame saw of the clouds, for the next one: each frame marches a share of its rays in turns
// and takes the others from here, from where their cloud was in the last picture. Rays whose cloud the last
// frame cannot tell are listed to be marched with the others. docs/clouds.md tells when that is. Sources:
// Schneider and Vos 2015 (a sixteenth of the pixels a frame), Hillaire 2016 (reprojection by the clouds' mean
// distance).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/clouds/march_plan.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/render/clouds/cloud_rays.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/buffer.h"

namespace skydrop::render {

// All that a picture of clouds depends on but the surfaces in it.
struct CloudFrame {
  View view{};
  glm::dvec3 eyeInField{0};  // the wind's drift taken off, m
  double seconds = 0;        // simulated
  double exposure = 1;
  glm::dvec3 toSun{0, 1, 0};
  AtmosphereSettings atmosphere{};
  clouds::CloudSettings settings{};
  std::vector<std::string> defines{};
};

// Whether a frame shows what the one before it showed, a moment later: not after a cut, a leap in time, or
// with other settings. Pure.
bool continues(const CloudFrame& past, const CloudFrame& now);

// Context's thread. One frame: begin(), recallTiles(), recallCandidates() for each spacing, keep().
class CloudHistory {
 public:
  // Takes the picture of the last frame, if it fits, and gives back the one before it to be overwritten;
  // makes what is missing. `picture`: rays one pixel apart.
  void begin(const FrameContext& context, const glm::dvec3& eyeInField, const clouds::CloudSettings& settings,
             CloudRays& picture);
  // Fills the rays of all tiles, `spacing` pixels apart, and lists those that have to be marched.
  const gl::Buffer& recallTiles(FrameContext& context, std::span<const std::string> defines, int spacing,
                                const CloudRays& rays, const gl::Buffer& tiles, const glm::ivec2& tileCount);
  // Where shaders/clouds/refine.glsl lists rays. Those that are known, and whose turn it is not, are filled;
  // the others are listed.
  gl::Buffer& candidates() { return candidates_; }
  void recallCandidates(FrameContext& context, std::span<const std::string> defines, const CloudRays& rays,
                        const glm::ivec2& tileCount, gl::Buffer& list);
  // After the frame: keeps what the next one has to know.
  void keep(const FrameContext& context);

  const gl::Buffer& widestRays() const { return widestRays_; }

 private:
  void resize(gl::Context& context, const View& view, const clouds::CloudSettings& settings);
  gl::ComputeShader& prepare(FrameContext& context, const std::string& file,
                             std::span<const std::string> defines, int round, const CloudRays& rays,
                             const glm::ivec2& tileCount, gl::Buffer& list);

  std::optional<CloudFrame> lastFrame_;
  CloudFrame frame_;  // that is being drawn
  bool isKnown_ = false;
  unsigned turn_ = 0;
  glm::mat4 toPast_{1};
  glm::vec3 eyeMoved_{0};
  glm::vec4 past_{0};
  CloudRays rays_;     // of the last frame
  gl::Texture depth_;  // of its surfaces
  // A texel a pixel: by how much what was not marched may be off, squared; of the last frame and of this one.
  gl::Texture pastDoubts_, doubts_;
  gl::Buffer candidates_, widestRays_;
  int round_ = 4;
};

}  // namespace skydrop::render
