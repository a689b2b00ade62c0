// The sky's tables on the GPU (sky/sky_view.h): what shaders/sky/atmosphere.glsl reads with the model of the
// shell.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "skydrop/render/frame/sky_light.h"
#include "skydrop/render/gl/context.h"
#include "skydrop/render/gl/texture.h"

namespace skydrop::render {

// What the shaders of a frame are compiled with where its light is that of the shell.
inline constexpr std::string_view kSkyShellDefine = "SKY_SHELL";
// No pass binds textures here.
inline constexpr GLuint kSkyTablesUnit = 15, kAirTablesUnit = 14;

// In light times exposure; the night's radiance is in what is even. The three layers of the whole sky have
// six times the columns and three times the rows of sky::SkyView, on curves, so that mixing two texels shows
// no kink. The air up to each distance is one layer, the haze's multiplied by its phase function, so that a
// pixel asks once; its columns are dense towards the light, where that is steep (airTableColumn()): with the
// default haze (anisotropy .7) mixing texels errs by 1 % of the glow. 1.5 MB in RGBA32F: half floats would show
// their steps in the sky.
class SkyTables {
 public:
  // Makes the textures where there are none, writes what has changed since the last call, and binds them.
  // `light` is a shell's.
  void bind(gl::Context& context, const SkyLight& light);

 private:
  void write(gl::Context& context, const SkyLight& light);
  void writeAir(const SkyLight& light);
  // Of a layer of the whole sky; valid until the next call.
  const std::vector<glm::vec4>& finer(std::span<const glm::vec4> texels);
  // A light of so many times the tables' own; of a share of it the direction is kept.
  void add(const sky::SkyView& view, const glm::dvec3& times, double glow);

  gl::Texture sky_, air_;
  std::vector<glm::vec4> texels_, wide_, finer_, airTexels_;
  // What was written.
  std::shared_ptr<const sky::SkyView> view_, moon_;
  double exposure_ = 0, glowSine_ = 0, anisotropy_ = 0;
};

}  // namespace skydrop::render
