// Makes a texture of gradient noise by compute shader, some slices at a time so that a window stays alive.
#pragma once

#include <span>
#include <vector>

#include "skydrop/noise/noise_generator.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader.h"

namespace skydrop::render {

// On the context's thread; owns its buffer until it goes. The values are those of noise::NoiseGenerator: bit
// for bit where the driver contracts nothing (llvmpipe), within 1e-6 where it uses fused multiply-add. Calls:
// make() until done(), then read().
class GradientNoiseMaker {
 public:
  // Throws core::RangeError as noise::NoiseGenerator does, core::DataError when the shader does not compile.
  GradientNoiseMaker(gl::Context& context, const noise::NoiseSettings& settings,
                     const noise::NoiseSize& size);

  // Dispatches the next `slices` (layers of a volume, rows of a plane; all that are left when there are
  // fewer) and waits for them.
  void make(int slices);
  bool done() const { return made_ == slices(); }
  double progress() const { return static_cast<double>(made_) / slices(); }  // 0 to 1

  // All values, x fastest, then y, then z, once it is done(). Waits for the GPU.
  std::vector<float> read() const;

 private:
  int slices() const { return size_.isVolume() ? size_.slices : size_.height; }

  noise::NoiseSettings settings_;
  noise::NoiseSize size_;
  int made_ = 0;
  gl::ComputeShader shader_;
  gl::Buffer values_;
};

}  // namespace skydrop::render
