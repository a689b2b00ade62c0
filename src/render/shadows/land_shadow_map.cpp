#include "skydrop/render/shadows/land_shadow_map.h"

#include <array>
#include <span>

namespace skydrop::render {

void LandShadowMap::makeTexture(gl::Context& context) {
  const GLsizei side = key_.layout.side;
  if (clearances_ && clearances_.width() == side) return;
  clearances_ = {};
  clearances_ =
      gl::Texture::make2DArray(context, GL_R16, side, side, terrain::kShadeLevels, "shade of the land");
}

void LandShadowMap::takeNone(gl::Context& context, const terrain::ShadeLayout& layout) {
  shade_ = nullptr;
  key_ = {};
  key_.layout = layout;
  makeTexture(context);
}

void LandShadowMap::take(gl::Context& context, const terrain::LandShade& shade) {
  shade_ = &shade;
  key_ = shade.key();
  makeTexture(context);
  for (int level = 0; level < terrain::kShadeLevels; ++level)
    clearances_.uploadLayer(level, GL_RED, GL_UNSIGNED_SHORT,
                            std::as_bytes(std::span(shade.clearances(level))));
}

void LandShadowMap::setPlaces(gl::ShaderProgram& shader, const terrain::ShadeKey& key,
                              const glm::dvec2& eye) {
  const terrain::ShadeAxes axes(key.toSun);
  const auto shear = static_cast<float>(-axes.shear);
  shader.setVec4("shadeAxes", axes.alongX ? glm::vec4(1, 0, shear, 1) : glm::vec4(0, 1, 1, shear));
  const glm::dvec2 at = axes.fromWorld(eye);
  std::array<glm::vec4, terrain::kShadeLevels> levels;
  for (int level = 0; level < terrain::kShadeLevels; ++level) {
    const auto index = static_cast<std::size_t>(level);
    const double texel = key.layout.texelM(level), side = key.layout.side;
    const auto place = [&](double metres, std::int64_t first) {
      return static_cast<float>((metres / texel - static_cast<double>(first) + 0.5) / side);
    };
    levels[index] = {static_cast<float>(1 / (texel * side)), place(at.y, key.first[index][1]),
                     place(at.x, key.first[index][0]), static_cast<float>(key.layout.reachM(level))};
  }
  shader.setVec4s("shadeLevels", levels);
}

void LandShadowMap::bind(gl::ShaderProgram& shader, const glm::dvec2& eye) const {
  setPlaces(shader, key_, eye);
  clearances_.bind(kUnit);
}

}  // namespace skydrop::render
