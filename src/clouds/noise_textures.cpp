#include "skydrop/clouds/noise_textures.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

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

// Mean step between neighbours inside, and over the border.
double seamAlong(const core::TextureData& texture, const Axis& axis) {
  const std::size_t total = texture.texels.size();
  const auto at = [&](std::size_t i) { return std::to_integer<int>(texture.texels[i]); };
  double inside = 0, across = 0;
  std::size_t lines = 0;
  for (std::size_t block = 0; block < total; block += axis.stride * axis.count) {
    for (std::size_t start = block; start < block + axis.stride; ++start, ++lines) {
      for (std::size_t i = 0; i + 1 < axis.count; ++i) {
        inside += std::abs(at(start + i * axis.stride) - at(start + (i + 1) * axis.stride));
      }
      across += std::abs(at(start) - at(start + (axis.count - 1) * axis.stride));
    }
  }
  inside /= static_cast<double>(lines * (axis.count - 1));
  across /= static_cast<double>(lines);
  return across / std::max(inside, 1e-9);
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
  const std::size_t texel = core::texelBytes(texture.format);
  const auto width = static_cast<std::size_t>(texture.width),
             height = static_cast<std::size_t>(texture.height);
  double roughest = std::max(seamAlong(texture, {width, texel}), seamAlong(texture, {height, texel * width}));
  if (texture.depth > 1) {
    roughest = std::max(
        roughest, seamAlong(texture, {static_cast<std::size_t>(texture.depth), texel * width * height}));
  }
  return roughest;
}

}  // namespace skydrop::clouds
