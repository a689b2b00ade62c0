#include "skydrop/render/noise/gradient_noise_maker.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace skydrop::render {
namespace {

gl::ComputeShader shaderFor(gl::Context& context, const noise::NoiseSettings& settings,
                            const noise::NoiseSize& size) {
  noise::requireSettings(settings);
  noise::requireSize(size);
  std::vector<std::string> defines;
  if (size.isVolume()) defines.emplace_back("VOLUME");
  return {context, "noise/gradient_noise.comp", defines};
}

std::size_t valuesOf(const noise::NoiseSize& size) {
  return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
         static_cast<std::size_t>(size.layers());
}

GLuint groupsFor(int invocations) { return static_cast<GLuint>(invocations + 7) / 8; }

}  // namespace

GradientNoiseMaker::GradientNoiseMaker(gl::Context& context, const noise::NoiseSettings& settings,
                                       const noise::NoiseSize& size)
    : settings_(settings),
      size_(size),
      shader_(shaderFor(context, settings, size)),
      values_(context, valuesOf(size) * sizeof(float), gl::Buffer::Use::fixed, "noise values") {}

void GradientNoiseMaker::make(int slices) {
  const int count = std::min(slices, this->slices() - made_);
  if (count <= 0) return;
  glm::ivec3 end(size_.width, size_.height, size_.layers());
  (size_.isVolume() ? end.z : end.y) = made_ + count;
  const auto half = [](int side) { return 0.5f / static_cast<float>(side); };
  shader_.use();
  shader_.setIvec3("size", {size_.width, size_.height, size_.layers()});
  shader_.setIvec3("end", end);
  shader_.setVec3("halfTexel", {half(size_.width), half(size_.height), half(size_.layers())});
  shader_.setInt("firstSlice", made_);
  shader_.setUint("seed", static_cast<unsigned>(settings_.seed));
  shader_.setUint("octaves", static_cast<unsigned>(settings_.octaves));
  shader_.setUint("frequency", static_cast<unsigned>(settings_.frequency));
  shader_.setFloat("amplitude", static_cast<float>(settings_.amplitude));
  shader_.setFloat("persistence", static_cast<float>(settings_.persistence));
  values_.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
  const GLuint across = groupsFor(size_.width);
  if (size_.isVolume())
    shader_.dispatch(across, groupsFor(size_.height), static_cast<GLuint>(count));
  else
    shader_.dispatch(across, groupsFor(count));
  values_.context().api().Finish();
  made_ += count;
}

std::vector<float> GradientNoiseMaker::read() const {
  assert(done());
  std::vector<float> values(valuesOf(size_));
  values_.context().api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  values_.read(0, std::as_writable_bytes(std::span(values)));
  return values;
}

}  // namespace skydrop::render
