// Optical depth of a cloud layer towards the sun at its base, in a grid of columns that stand on sun rays:
// each is a sum along one ray, from the top of the layer down. The lower the sun, the finer the nodes lie
// along a column and the wider apart the columns: across the light they are as dense as with the sun
// overhead.
//
// A grid belongs to a place of the field, not to the eye: it moves in steps of several columns, and what it
// holds depends on its layout and the medium alone. Context's thread.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <string>

#include "render/clouds/weather_layers.h"
#include "skydrop/clouds/cloud_settings.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader_cache.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

struct SunOpticalDepthGridLayout {
  glm::dvec3 foot{0};  // the first node, in the field (drift taken off); on the base of the layer
  glm::dvec3 along{0}, across{0}, sunward{0};  // from a node to the next, metres
  glm::ivec3 nodes{0};
  bool operator==(const SunOpticalDepthGridLayout&) const = default;
};

// Nodes `cellM` apart across the light, for all places of the layer's base within `radiusM` of a middle (in
// the field). toSun: unit, at least kLeastSunSine high.
SunOpticalDepthGridLayout sunOpticalDepthGridLayout(const clouds::CloudLayerSettings& layer,
                                                    const glm::dvec3& toSun, double cellM, double radiusM,
                                                    const glm::dvec3& middle);

// Rows that carry a place relative to the eye (and 1) to the texture's coordinates.
std::array<glm::vec4, 3> toSunOpticalDepthGrid(const SunOpticalDepthGridLayout& layout,
                                               const glm::dvec3& eyeInField);

class SunOpticalDepthGrid {
 public:
  explicit SunOpticalDepthGrid(std::string label) : label_(std::move(label)) {}

  const SunOpticalDepthGridLayout& layout() const { return layout_; }
  const gl::Texture& depths() const { return depths_; }

  // Fills it again where layout or medium differ from what it holds. The layer is one of the settings', and
  // its field's textures have to be bound.
  void update(gl::Context& context, gl::ShaderCache& shaders, const SunOpticalDepthGridLayout& layout,
              const clouds::CloudLayerSettings& layer, const clouds::CloudSettings& settings,
              double meanDetail);
  // The same of several layers, a channel each; `layout` is of their hull, and samples lie so far apart,
  // about.
  void update(gl::Context& context, gl::ShaderCache& shaders, const SunOpticalDepthGridLayout& layout,
              std::span<const DrawnLayer> layers, const clouds::CloudSettings& settings, double meanDetail,
              double sampleM);
  void forget() { layout_ = {}; }  // the medium changed

 private:
  std::string label_;
  SunOpticalDepthGridLayout layout_;
  gl::Texture depths_;
  gl::Buffer uniforms_;
};

}  // namespace skydrop::render
