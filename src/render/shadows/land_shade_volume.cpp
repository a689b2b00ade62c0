#include "skydrop/render/shadows/land_shade_volume.h"

#include <algorithm>
#include <span>
#include <vector>

namespace skydrop::render {
namespace {

constexpr double kLeastScaleM = 1;  // of shade over a level sea

// Of its penumbrae, m.
float widest(const terrain::LandShade& shade, int level) {
  const std::vector<float>& umbra = shade.umbra(level);
  const std::vector<float>& penumbra = shade.penumbra(level);
  float width = 0;
  for (std::size_t i = 0; i < umbra.size(); ++i) width = std::max(width, penumbra[i] - umbra[i]);
  return width;
}

}  // namespace

void LandShadeVolume::take(gl::Context& context, const LandShadowMap& map) {
  key_ = map.key();
  const GLsizei side = key_.layout.side;
  if (!limbs_ || limbs_.width() != side) {
    limbs_ = {};
    taken_.reset();
    limbs_ =
        gl::Texture::make2DArray(context, GL_RG16, side, side, terrain::kShadeLevels, "shade over the land");
  }
  const terrain::LandShade* shade = map.shade();
  if (!shade || taken_ == key_) return;
  taken_ = key_;
  scaleM_ = static_cast<float>(std::max(shade->topM(), kLeastScaleM));
  for (int level = 0; level < terrain::kShadeLevels; ++level)
    scaleM_ = std::max(scaleM_, widest(*shade, level));
  const float code = 65535 / scaleM_;
  std::vector<std::uint16_t> texels;
  for (int level = 0; level < terrain::kShadeLevels; ++level) {
    const std::vector<float>& umbra = shade->umbra(level);
    const std::vector<float>& penumbra = shade->penumbra(level);
    texels.resize(2 * umbra.size());
    const auto coded = [&](float height) {
      return static_cast<std::uint16_t>(std::clamp(height * code, 0.0f, 65535.0f) + 0.5f);
    };
    for (std::size_t i = 0; i < umbra.size(); ++i) {
      texels[2 * i] = coded(penumbra[i] - umbra[i]);
      texels[2 * i + 1] = coded(penumbra[i]);
    }
    limbs_.uploadLayer(level, GL_RG, GL_UNSIGNED_SHORT, std::as_bytes(std::span(texels)));
  }
}

void LandShadeVolume::bind(gl::ShaderProgram& shader, const glm::dvec2& eye) const {
  LandShadowMap::setPlaces(shader, key_, eye);
  shader.setFloat("limbScaleM", scaleM_);
  limbs_.bind(kUnit);
}

}  // namespace skydrop::render
