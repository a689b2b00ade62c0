#include "skydrop/render/clouds/noise_maker.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>

namespace skydrop::render {
namespace {

using clouds::NoiseTexture;

std::string defineOf(NoiseTexture texture) {
  switch (texture) {
    case NoiseTexture::shape:
      return "SHAPE";
    case NoiseTexture::detail:
      return "DETAIL";
    case NoiseTexture::weather:
      return "WEATHER";
  }
  return {};
}

gl::ComputeShader shaderFor(gl::Context& context, NoiseTexture texture) {
  const std::array defines = {defineOf(texture)};
  return {context, "clouds/noise.comp", defines};
}

std::size_t bytesOf(NoiseTexture texture) {
  const clouds::NoiseLayout& layout = clouds::noiseLayout(texture);
  return layout.sliceBytes() * static_cast<std::size_t>(layout.slices());
}

GLuint groupsFor(int invocations) { return static_cast<GLuint>(invocations + 7) / 8; }

}  // namespace

NoiseMaker::NoiseMaker(gl::Context& context, NoiseTexture texture, std::uint32_t seed)
    : texture_(texture),
      seed_(seed),
      shader_(shaderFor(context, texture)),
      texels_(context, bytesOf(texture), gl::Buffer::Use::fixed, "noise texels") {}

void NoiseMaker::make(int slices) {
  const clouds::NoiseLayout& layout = clouds::noiseLayout(texture_);
  const int count = std::min(slices, layout.slices() - made_);
  if (count <= 0) return;
  shader_.use();
  shader_.setUint("seed", seed_);
  shader_.setUint("side", static_cast<unsigned>(layout.side));
  shader_.setUint("firstSlice", static_cast<unsigned>(made_));
  texels_.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
  const GLuint across = groupsFor(layout.side);
  if (layout.isVolume)
    shader_.dispatch(across, across, static_cast<GLuint>(count));
  else
    shader_.dispatch(across, groupsFor(count));
  texels_.context().api().Finish();
  // The rows of a map come in groups of eight: those beyond `count` are made again next time, with the same
  // result.
  made_ += count;
}

double NoiseMaker::progress() const {
  return static_cast<double>(made_) / clouds::noiseLayout(texture_).slices();
}

core::TextureData NoiseMaker::read() const {
  assert(done());
  core::TextureData made = clouds::emptyNoise(texture_);
  read(std::span(made.texels));
  return made;
}

void NoiseMaker::read(std::span<std::byte> texels) const {
  texels_.context().api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  texels_.read(0, texels);
}

}  // namespace skydrop::render
