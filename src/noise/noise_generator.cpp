#include "skydrop/noise/noise_generator.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "noise/noise_rows.h"
#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/error.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/core/shared.h"

namespace skydrop::noise {
namespace {

namespace shared = core::shared::f32;

constexpr std::uint64_t kMostBytes = std::uint64_t{256} << 20;  // what core::decodeDds() reads

template <class Settings>
void requireInRange(Settings settings) {
  const core::SettingsTable table(settings);
  for (const core::Field& field : table.fields()) core::setField(field, field.get());
}

void requireSide(const char* name, int side, int most) {
  if (side < 1 || side > most) {
    throw core::RangeError(std::string(name) + ": " + std::to_string(side) + " is out of range 1 to " +
                           std::to_string(most));
  }
  if (!std::has_single_bit(static_cast<unsigned>(side))) {
    throw core::RangeError(std::string(name) + ": " + std::to_string(side) +
                           " is not a power of two, which exact tiling and mip levels need");
  }
}

float halfTexel(int side) { return 0.5f / static_cast<float>(side); }

template <class Word>
void quantiseTo(std::span<const float> values, std::span<std::byte> texels) {
  constexpr float kMost = static_cast<float>(static_cast<Word>(-1));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto word = static_cast<Word>(std::clamp(values[i], 0.0f, 1.0f) * kMost + 0.5f);
    std::memcpy(texels.data() + i * sizeof word, &word, sizeof word);
  }
}

bool isNoiseFormat(core::TexelFormat format) {
  using core::TexelFormat;
  return format == TexelFormat::a8 || format == TexelFormat::r8 || format == TexelFormat::r16 ||
         format == TexelFormat::r32f;
}

}  // namespace

void requireSettings(const NoiseSettings& settings) { requireInRange(settings); }
void requirePostProcess(const PostProcess& postProcess) { requireInRange(postProcess); }

void requireSize(const NoiseSize& size) {
  const int most = size.slices == 0 ? kMostPlaneSide : kMostVolumeSide;
  requireSide("width", size.width, most);
  requireSide("height", size.height, most);
  if (size.slices != 0) requireSide("slices", size.slices, most);
}

void requireTexture(const NoiseSize& size, core::TexelFormat format) {
  requireSize(size);
  if (!isNoiseFormat(format)) {
    throw core::RangeError("noise is made as a8, r8, r16 or r32f, not as " +
                           std::string(core::texelFormatName(format)));
  }
  const std::uint64_t bytes = std::uint64_t(size.width) * std::uint64_t(size.height) *
                              std::uint64_t(size.layers()) * core::texelBytes(format);
  if (bytes > kMostBytes) {
    throw core::RangeError("size: " + std::to_string(bytes >> 20) + " MiB of texels: more than 256 MiB");
  }
}

NoiseGenerator::NoiseGenerator(const NoiseSettings& settings, const NoiseSize& size)
    : settings_(settings), size_(size) {
  requireSettings(settings);
  requireSize(size);
  rows_ = std::make_shared<const NoiseRows>(settings, size, bestOctaveKernels());
}

void NoiseGenerator::fillRows(int layer, int firstRow, std::span<float> values) const {
  assert(values.size() % static_cast<std::size_t>(size_.width) == 0);
  rows_->fill(layer, firstRow, values);
}

float NoiseGenerator::valueAt(int x, int y, int layer) const {
  const auto unsignedOf = [](auto value) { return static_cast<std::uint32_t>(value); };
  const std::uint32_t seed = unsignedOf(settings_.seed), octaves = unsignedOf(settings_.octaves),
                      frequency = unsignedOf(settings_.frequency);
  const auto amplitude = static_cast<float>(settings_.amplitude);
  const auto persistence = static_cast<float>(settings_.persistence);
  if (!size_.isVolume()) {
    return shared::octaveNoise2(
        {unsignedOf(x), unsignedOf(y)}, {unsignedOf(size_.width), unsignedOf(size_.height)},
        {halfTexel(size_.width), halfTexel(size_.height)}, seed, octaves, frequency, amplitude, persistence);
  }
  return shared::octaveNoise3({unsignedOf(x), unsignedOf(y), unsignedOf(layer)},
                              {unsignedOf(size_.width), unsignedOf(size_.height), unsignedOf(size_.slices)},
                              {halfTexel(size_.width), halfTexel(size_.height), halfTexel(size_.slices)},
                              seed, octaves, frequency, amplitude, persistence);
}

void applyPostProcess(const PostProcess& postProcess, std::span<float> values) {
  requirePostProcess(postProcess);
  // In double and without libm: the same bits on every machine.
  const double logDensity = core::dmath::log(postProcess.density);
  for (float& value : values) {
    const double above = static_cast<double>(value) - postProcess.cutoff;
    value = above > 0 ? static_cast<float>(1 - core::dmath::exp(logDensity * (255 * above))) : 0.0f;
  }
}

void quantise(std::span<const float> values, core::TexelFormat format, std::span<std::byte> texels) {
  assert(isNoiseFormat(format) && texels.size() == values.size() * core::texelBytes(format));
  switch (core::texelBytes(format)) {
    case 1:
      return quantiseTo<std::uint8_t>(values, texels);
    case 2:
      return quantiseTo<std::uint16_t>(values, texels);
    default:
      std::memcpy(texels.data(), values.data(), texels.size());
  }
}

core::TextureData makeNoise(const NoiseSettings& settings, const NoiseSize& size,
                            const MakeOptions& options) {
  const NoiseGenerator generator(settings, size);
  if (options.postProcess) requirePostProcess(*options.postProcess);
  requireTexture(size, options.format);
  core::TextureData texture(options.format, size.width, size.height, size.slices);
  // Rows that are made together share lattice rows; this many fit the cache, and stop within a moment.
  constexpr int kTexelsAtOnce = 1 << 16;
  const int block = std::clamp(kTexelsAtOnce / size.width, 1, size.height);
  std::vector<float> values(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(block));
  const std::size_t blockBytes = values.size() * core::texelBytes(options.format);
  const std::span<std::byte> texels = texture.texels;
  const int blocks = size.layers() * (size.height / block);
  for (int i = 0; i < blocks; ++i) {
    if (options.stop.stop_requested()) return {};
    if (options.progress) options.progress(static_cast<double>(i) / blocks);
    generator.fillRows(i * block / size.height, i * block % size.height, values);
    if (options.postProcess) applyPostProcess(*options.postProcess, values);
    quantise(values, options.format, texels.subspan(static_cast<std::size_t>(i) * blockBytes, blockBytes));
  }
  if (options.progress) options.progress(1);
  return texture;
}

core::TextureData make2d(const NoiseSettings& settings, int width, int height, const MakeOptions& options) {
  return makeNoise(settings, {width, height, 0}, options);
}

core::TextureData make3d(const NoiseSettings& settings, int width, int height, int slices,
                         const MakeOptions& options) {
  if (slices == 0)
    throw core::RangeError("slices: 0 is out of range 1 to " + std::to_string(kMostVolumeSide));
  return makeNoise(settings, {width, height, slices}, options);
}

}  // namespace skydrop::noise
