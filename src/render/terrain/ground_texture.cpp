#include "skydrop/render/terrain/ground_texture.h"

#include <glm/vec4.hpp>
#include <span>

namespace skydrop::render {

GroundTexture::GroundTexture(gl::Context& context, const terrain::GroundPicture& picture)
    : texture_(gl::Texture::make2D(context, GL_SRGB8_ALPHA8, picture.levels[0].width,
                                   picture.levels[0].height, "ground picture",
                                   static_cast<GLsizei>(picture.levels.size()))),
      corner_(picture.corner),
      size_(picture.metresAcross(), picture.metresDown()),
      texelM_(picture.texelM) {
  for (std::size_t i = 0; i < picture.levels.size(); ++i) {
    texture_.upload(GL_RGBA, GL_UNSIGNED_BYTE, std::as_bytes(std::span(picture.levels[i].rgba)),
                    static_cast<GLint>(i));
  }
  texture_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
}

void GroundTexture::set(gl::Shader& shader, const glm::dvec2& base,
                        const terrain::GroundPictureSettings& settings) const {
  texture_.bind(kUnit);
  const glm::dvec2 from = (base - corner_) / size_;
  shader.setVec4("groundPlace", glm::vec4(from.x, from.y, 1 / size_.x, 1 / size_.y));
  shader.setVec4("groundWorn", glm::vec4(settings.share, settings.nearShare, settings.nearM, settings.gain));
  shader.setFloat("groundTexelM", static_cast<float>(texelM_));
}

}  // namespace skydrop::render
