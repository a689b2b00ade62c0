// Makes periodic noise textures and volumes on the processor. The definition is
// shaders/shared/gradient_noise.glsl; render::GradientNoiseMaker runs the same on the GPU and noise_scripts/
// in Python (docs/noise.md). Any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>

#include "skydrop/core/dds.h"
#include "skydrop/noise/noise_settings.h"

namespace skydrop::noise {

class NoiseRows;

// Texels. Sides are powers of two: then every texel's place between lattice points is exact in float, and mip
// levels halve evenly. A plane has sides up to 8192, a volume up to 1024.
struct NoiseSize {
  int width = 0;
  int height = 0;
  int slices = 0;  // 0: a plane, else a volume

  bool isVolume() const { return slices > 0; }
  int layers() const { return isVolume() ? slices : 1; }
  bool operator==(const NoiseSize&) const = default;
};

inline constexpr int kMostPlaneSide = 8192, kMostVolumeSide = 1024;

// Throws core::RangeError with one line that names the value at fault ("octaves: 0 is out of range 1 to 16",
// "width: 3 is not a power of two"), also for values that are not finite.
void requireSettings(const NoiseSettings& settings);
void requirePostProcess(const PostProcess& postProcess);
void requireSize(const NoiseSize& size);
// Also more than 256 MiB of texels, and a format that noise is not made in (MakeOptions).
void requireTexture(const NoiseSize& size, core::TexelFormat format);

// Values in [0, 1] of one texture, row by row: for previews, and for what makeNoise() does not do. A value
// depends on the settings, the size and its texel alone, never on the rows that are asked for together, the
// thread or the processor's instruction set.
class NoiseGenerator {
 public:
  // Throws as requireSettings() and requireSize() do.
  NoiseGenerator(const NoiseSettings& settings, const NoiseSize& size);

  const NoiseSettings& settings() const { return settings_; }
  const NoiseSize& size() const { return size_; }

  // The rows firstRow, firstRow + 1, ... of a layer (0 of a plane), values.size() / width of them.
  // Neighbouring rows share work: 64 at a time cost a fraction of 64 calls.
  void fillRows(int layer, int firstRow, std::span<float> values) const;

  // One texel by the plain definition; what fillRows() gives, bit for bit.
  float valueAt(int x, int y, int layer = 0) const;

 private:
  NoiseSettings settings_;
  NoiseSize size_;
  std::shared_ptr<const NoiseRows> rows_;  // copies share it
};

// The cut to clouds, in place.
void applyPostProcess(const PostProcess& postProcess, std::span<float> values);

// How a texture is made. Formats: a8 (ALPHA), r8, r16 and r32f (LUMINANCE); bytes and 16-bit words hold the
// nearest step, so a texel is off by half a step (1/510, 1/131070) at most.
struct MakeOptions {
  core::TexelFormat format = core::TexelFormat::a8;
  std::optional<PostProcess> postProcess = std::nullopt;  // none: the noise as it is
  std::stop_token stop = {};
  std::function<void(double)> progress = {};  // 0 .. 1, on the calling thread, at most once a row
};

// The whole texture, or an empty one (width 0) when it was stopped before. Throws as NoiseGenerator does, and
// core::RangeError for another format or more than 256 MiB of texels.
core::TextureData makeNoise(const NoiseSettings& settings, const NoiseSize& size, const MakeOptions& options);
core::TextureData make2d(const NoiseSettings& settings, int width, int height,
                         const MakeOptions& options = {});
core::TextureData make3d(const NoiseSettings& settings, int width, int height, int slices,
                         const MakeOptions& options = {});

// Values in [0, 1] as texels of one of those formats, clamped; texels.size() = values.size() *
// texelBytes(format).
void quantise(std::span<const float> values, core::TexelFormat format, std::span<std::byte> texels);

}  // namespace skydrop::noise
