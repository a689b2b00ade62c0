// Below which clouds it rains: the weather map of the clouds' field (clouds::PackedCloudNoise), coarser, so
// that shafts hang under what is drawn. A resource of the frame (FrameResources), published by RainMapPass;
// without one it rains everywhere alike.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "skydrop/clouds/cloud_field.h"
#include "skydrop/clouds/layer_medium.h"
#include "skydrop/core/wind.h"
#include "skydrop/render/frame/pass.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

class RainMap {
 public:
  static constexpr int kSide = 256;  // texels of the map, at most
  static constexpr const char* kDefine = "RAIN_MAP";

  // On the context's thread. Keeps the noise.
  RainMap(gl::Context& context, const clouds::PackedCloudNoise& noise);

  // Of the layer that rains, carried by the wind for so many seconds.
  void place(const clouds::LayerMedium& medium, const core::WindSettings& wind, double seconds);

  // Share of the full rain below a place (x, z; m), [0, 1]: bilinear, as the shader has it.
  double shareAt(const glm::dvec2& xz) const;
  // For a program of kDefine (shaders/precipitation/rain_map.glsl).
  void bind(gl::Shader& shader, const glm::dvec3& eye) const;

 private:
  static constexpr GLuint kUnit = 5;

  int side_ = 0;
  std::vector<glm::vec2> texels_;  // coverage and precipitation
  gl::Texture texture_;            // RG8 with mipmaps
  double periodM_ = 1, coverage_ = 0;
  glm::dvec2 drift_{0};
};

// Publishes the map. Draws nothing.
class RainMapPass final : public Pass {
 public:
  RainMapPass(gl::Context& context, const clouds::PackedCloudNoise& noise, const core::WindSettings& wind)
      : map_(context, noise), wind_(wind) {}

  // For the next frame. Costs nothing.
  void apply(const core::WindSettings& wind) { wind_ = wind; }

  std::string_view name() const override { return "rainMap"; }
  RenderStage stage() const override { return RenderStage::shadows; }
  // Without precipitation, and where it falls below all of the layer.
  std::optional<std::string> skipReason(const FrameInput& frame) const override;
  void draw(FrameContext& context) override;

 private:
  RainMap map_;
  core::WindSettings wind_;
};

}  // namespace skydrop::render
