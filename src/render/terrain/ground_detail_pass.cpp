#include "skydrop/render/terrain/ground_detail_pass.h"

#include <span>

namespace skydrop::render {

GroundDetailPass::GroundDetailPass(gl::Context& context,
                                   const std::shared_ptr<const terrain::GroundRelief>& relief,
                                   const terrain::GroundDetailSettings& settings)
    : context_(context), settings_(settings) {
  if (relief && relief->texels() == terrain::texelsOf(settings.texels)) upload(*relief);
  apply(settings);
}

void GroundDetailPass::apply(const terrain::GroundDetailSettings& settings) {
  settings_ = settings;
  const int texels = terrain::texelsOf(settings.texels);
  if (squares_.width() != texels) upload(terrain::makeGroundRelief(texels));
}

void GroundDetailPass::upload(const terrain::GroundRelief& relief) {
  const GLsizei texels = relief.texels();
  const auto levels = static_cast<GLsizei>(relief.levels[0].size());
  squares_ = gl::Texture::make2DArray(context_, GL_RGBA8, texels, texels, terrain::kGroundMaterials,
                                      "ground materials", levels);
  for (GLint material = 0; material < terrain::kGroundMaterials; ++material) {
    for (GLint level = 0; level < levels; ++level) {
      const auto& bytes =
          relief.levels[static_cast<std::size_t>(material)][static_cast<std::size_t>(level)].bytes;
      squares_.uploadLayer(material, GL_RGBA, GL_UNSIGNED_BYTE, std::as_bytes(std::span(bytes)), level);
    }
  }
  squares_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  squares_.setWrap(GL_REPEAT);
}

void GroundDetailPass::draw(FrameContext& context) {
  detail_ = {&squares_, settings_.contrast, settings_.relief, settings_.reach,
             terrain::kReliefTileM / squares_.width(), settings_.erosion};
  context.resources.publish(detail_);
}

}  // namespace skydrop::render
