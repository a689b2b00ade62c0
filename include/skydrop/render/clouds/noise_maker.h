// Makes a noise texture of the clouds by compute shader, some slices at a time so that a window stays alive.
#pragma once

#include <cstdint>

#include "skydrop/clouds/noise_textures.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// On the context's thread; owns its buffer until it goes. What it makes differs from clouds::makeNoise() by
// at most one 8-bit step. Calls: make() until done(), then read().
class NoiseMaker {
 public:
  // The seed is that of clouds::makeNoise(). Throws core::DataError when the shader does not compile.
  NoiseMaker(gl::Context& context, clouds::NoiseTexture texture, std::uint32_t seed);

  // Dispatches the next `slices` (all that are left when there are fewer) and waits for them. On a software
  // renderer a slice of the shape takes 10 to 20 ms; on hardware all take about as long as one.
  void make(int slices);
  bool done() const { return made_ == clouds::noiseLayout(texture_).slices(); }
  double progress() const;  // 0 to 1

  // The whole texture, once it is done(). Waits for the GPU.
  core::TextureData read() const;
  // Its first texels.size() bytes, which must have been made: slices along z, rows along y, RGBA8 or RG8 as
  // clouds::noiseLayout() says.
  void read(std::span<std::byte> texels) const;

 private:
  clouds::NoiseTexture texture_;
  std::uint32_t seed_;
  int made_ = 0;
  gl::ComputeShader shader_;
  gl::Buffer texels_;
};

}  // namespace skydrop::render
