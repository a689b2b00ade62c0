#include "skydrop/render/noise/noise_volume_view.h"

#include <cassert>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <span>

namespace skydrop::render {
namespace {

constexpr double kElevationRad = 0.45;
constexpr float kExtinction = 14;  // of a density of 1, over an edge
constexpr int kSteps = 48;

glm::mat3 viewToVolume(double angleRad) {
  const auto sine = [](double a) { return static_cast<float>(std::sin(a)); };
  const auto cosine = [](double a) { return static_cast<float>(std::cos(a)); };
  const float s = sine(angleRad), c = cosine(angleRad), t = sine(kElevationRad), e = cosine(kElevationRad);
  const glm::mat3 about(c, 0, -s, 0, 1, 0, s, 0, c), above(1, 0, 0, 0, e, -t, 0, t, e);
  return about * above;
}

}  // namespace

NoiseVolumeView::NoiseVolumeView(gl::Context& context, int side)
    : context_(context),
      shader_(context, "noise/volume.comp", {}),
      picture_(gl::Texture::make2D(context, GL_RGBA8, side, side, "noise volume picture")) {}

void NoiseVolumeView::show(const core::TextureData& volume) {
  assert(volume.isVolume() && volume.format == core::TexelFormat::r8);
  if (!volume_ || volume_.width() != volume.width || volume_.height() != volume.height ||
      volume_.depth() != volume.depth) {
    volume_ = gl::Texture::make3D(context_, GL_R8, volume.width, volume.height, volume.depth, "noise volume");
    volume_.setWrap(GL_REPEAT);
  }
  volume_.upload(GL_RED, GL_UNSIGNED_BYTE, std::span(volume.texels));
}

void NoiseVolumeView::draw(double angleRad, double threshold) {
  if (!volume_) return;
  shader_.use();
  shader_.setMatrix("viewToVolume", viewToVolume(angleRad));
  shader_.setFloat("threshold", static_cast<float>(threshold));
  shader_.setFloat("extinction", kExtinction);
  shader_.setInt("steps", kSteps);
  volume_.bind(0);
  picture_.bindImage(0, GL_WRITE_ONLY);
  const auto groups = static_cast<GLuint>(picture_.width() + 7) / 8;
  shader_.dispatch(groups, groups);
  context_.api().MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace skydrop::render
