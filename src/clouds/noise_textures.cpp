#include "skydrop/clouds/noise_textures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "skydrop/core/shared.h"

namespace skydrop::clouds {
namespace {

namespace shared = core::shared::f32;

constexpr std::array<NoiseLayout, 3> kLayouts = {
    {{"shape", 128, true}, {"detail", 32, true}, {"weather", 512, false}}};

float centre(int index, int side) { return (static_cast<float>(index) + 0.5f) / static_cast<float>(side); }

std::byte quantised(float value) {
  return static_cast<std::byte>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

glm::vec4 noiseAt(NoiseTexture texture, glm::vec3 place, std::uint32_t seed) {
  switch (texture) {
    case NoiseTexture::shape:
      return shared::cloudShapeNoise(place, seed);
    case NoiseTexture::detail:
      return shared::cloudDetailNoise(place, seed);
    case NoiseTexture::weather:
      return shared::cloudWeatherNoise(glm::vec2(place), seed);
  }
  return {};
}

void fillRow(NoiseTexture texture, std::uint32_t seed, int side, float v, float w, std::byte* texels) {
  for (int x = 0; x < side; ++x) {
    const glm::vec4 value = noiseAt(texture, {centre(x, side), v, w}, seed);
    for (int channel = 0; channel < 4; ++channel) *texels++ = quantised(value[channel]);
  }
}

// Texels along one axis, seen as lines of `count` texels `stride` bytes apart.
struct Axis {
  std::size_t count, stride;
};

// Mean step over the border, divided by that between neighbours inside. 0 for an axis of one texel, which has
// neither. Steps from or to a float that is not finite are not counted.
template <class Value>
double seamAlong(std::span<const Value> values, const Axis& axis) {
  if (axis.count < 2) return 0;
  struct Mean {
    double sum = 0;
    std::size_t count = 0;
    void add(double a, double b) {
      if (!std::isfinite(a - b)) return;
      sum += std::abs(a - b);
      ++count;
    }
    double value() const { return sum / static_cast<double>(std::max<std::size_t>(count, 1)); }
  } inside, across;
  const auto at = [&](std::size_t i) { return static_cast<double>(values[i]); };
  for (std::size_t block = 0; block < values.size(); block += axis.stride * axis.count) {
    for (std::size_t start = block; start < block + axis.stride; ++start) {
      for (std::size_t i = 0; i + 1 < axis.count; ++i)
        inside.add(at(start + i * axis.stride), at(start + (i + 1) * axis.stride));
      across.add(at(start), at(start + (axis.count - 1) * axis.stride));
    }
  }
  return across.value() / std::max(inside.value(), 1e-9);
}

template <class Value>
double roughestSeam(const core::TextureData& texture) {
  std::vector<Value> values(texture.texels.size() / sizeof(Value));
  std::memcpy(values.data(), texture.texels.data(), values.size() * sizeof(Value));
  double roughest = 0;
  auto stride = static_cast<std::size_t>(core::channelCount(texture.format));
  for (const int side : {texture.width, texture.height, std::max(texture.depth, 1)}) {
    const auto count = static_cast<std::size_t>(side);
    roughest = std::max(roughest, seamAlong<Value>(values, {count, stride}));
    stride *= count;
  }
  return roughest;
}

}  // namespace

std::size_t NoiseLayout::sliceBytes() const {
  const auto texels = static_cast<std::size_t>(side);
  return (isVolume ? texels * texels : texels) * core::texelBytes(core::TexelFormat::rgba8);
}

const NoiseLayout& noiseLayout(NoiseTexture texture) { return kLayouts[static_cast<std::size_t>(texture)]; }

core::TextureData emptyNoise(NoiseTexture texture) {
  const NoiseLayout& layout = noiseLayout(texture);
  return {core::TexelFormat::rgba8, layout.side, layout.side, layout.isVolume ? layout.side : 0};
}

void fillNoise(NoiseTexture texture, std::uint32_t seed, int first, std::span<std::byte> texels) {
  const NoiseLayout& layout = noiseLayout(texture);
  assert(texels.size() % layout.sliceBytes() == 0);
  const int count = static_cast<int>(texels.size() / layout.sliceBytes());
  const std::size_t rowBytes = static_cast<std::size_t>(layout.side) * 4;
  std::byte* row = texels.data();
  for (int slice = first; slice < first + count; ++slice) {
    for (int y = layout.isVolume ? 0 : slice; y < (layout.isVolume ? layout.side : slice + 1); ++y) {
      fillRow(texture, seed, layout.side, centre(y, layout.side),
              layout.isVolume ? centre(slice, layout.side) : 0, row);
      row += rowBytes;
    }
  }
}

core::TextureData makeNoise(NoiseTexture texture, std::uint32_t seed, std::stop_token stop) {
  const NoiseLayout& layout = noiseLayout(texture);
  core::TextureData made = emptyNoise(texture);
  const std::span<std::byte> texels = made.texels;
  for (int slice = 0; slice < layout.slices(); ++slice) {
    if (stop.stop_requested()) return {};
    fillNoise(texture, seed, slice,
              texels.subspan(static_cast<std::size_t>(slice) * layout.sliceBytes(), layout.sliceBytes()));
  }
  return made;
}

NoiseDifference noiseDifference(const core::TextureData& a, const core::TextureData& b) {
  assert(a.texels.size() == b.texels.size());
  NoiseDifference difference;
  for (std::size_t i = 0; i < a.texels.size(); ++i) {
    const int apart = std::abs(std::to_integer<int>(a.texels[i]) - std::to_integer<int>(b.texels[i]));
    difference.largest = std::max(difference.largest, apart);
    difference.mean += apart;
  }
  difference.mean /= static_cast<double>(std::max<std::size_t>(a.texels.size(), 1));
  return difference;
}

double seamRoughness(const core::TextureData& texture) {
  switch (texture.format) {
    case core::TexelFormat::r32f:
    case core::TexelFormat::rgba32f:
      return roughestSeam<float>(texture);
    case core::TexelFormat::r16:
      return roughestSeam<std::uint16_t>(texture);
    default:
      return roughestSeam<std::uint8_t>(texture);
  }
}

}  // namespace skydrop::clouds
