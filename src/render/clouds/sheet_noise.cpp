#include "skydrop/render/clouds/sheet_noise.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include "skydrop/noise/noise_generator.h"

namespace skydrop::render {
namespace {

std::vector<float> floatsOf(const core::TextureData& texture) {
  std::vector<float> values(texture.texels.size() / sizeof(float));
  if (!values.empty()) std::memcpy(values.data(), texture.texels.data(), texture.texels.size());
  return values;
}

template <class Settings>
noise::NoiseSettings noiseOf(const Settings& s) {
  return {.octaves = s.octaves,
          .frequency = s.frequency,
          .amplitude = s.amplitude,
          .persistence = s.persistence,
          .seed = s.seed};
}

noise::MakeOptions asFloats(std::stop_token stop) {
  noise::MakeOptions options;
  options.format = core::TexelFormat::r32f;
  options.stop = std::move(stop);
  return options;
}

// Half the side of `finer`, which is `side`.
std::vector<float> halved(const std::vector<float>& finer, std::size_t side) {
  const std::size_t half = side / 2;
  std::vector<float> coarser(half * half);
  for (std::size_t y = 0; y < half; ++y) {
    const float* low = &finer[2 * y * side];
    const float* high = low + side;
    for (std::size_t x = 0; x < half; ++x) {
      coarser[y * half + x] = 0.25f * (low[2 * x] + low[2 * x + 1] + high[2 * x] + high[2 * x + 1]);
    }
  }
  return coarser;
}

double varianceOf(std::span<const float> values, double mean) {
  double sum = 0;
  for (const float value : values) {
    const double apart = static_cast<double>(value) - mean;
    sum += apart * apart;
  }
  return sum / static_cast<double>(values.size());
}

void measure(SheetNoise& noise) {
  const std::vector<float>& whole = noise.levels.front();
  double sum = 0;
  for (const float value : whole) sum += static_cast<double>(value);
  noise.mean = sum / static_cast<double>(whole.size());
  const double all = varianceOf(whole, noise.mean);
  noise.spread = std::sqrt(all);
  noise.lost.clear();
  // Texels of a level are means of disjoint squares, so what is lost is what their variance lacks.
  for (const std::vector<float>& level : noise.levels)
    noise.lost.push_back(std::sqrt(std::max(all - varianceOf(level, noise.mean), 0.0)));
}

}  // namespace

SheetNoise makeSheetNoise(const clouds::CloudPlaneSettings& settings, std::stop_token stop) {
  const int side = static_cast<int>(settings.textureSide);
  SheetNoise made;
  std::vector<float> values = floatsOf(noise::make2d(noiseOf(settings), side, side, asFloats(stop)));
  if (values.empty()) return made;
  made.side = side;
  made.levels.push_back(std::move(values));
  for (auto length = static_cast<std::size_t>(side); length > 1; length /= 2)
    made.levels.push_back(halved(made.levels.back(), length));
  measure(made);
  return made;
}

SheetNoise makeSheetNoise(const clouds::CloudDomeSettings& settings, std::stop_token stop,
                          std::function<void(double)> progress) {
  const int side = static_cast<int>(settings.textureSide);
  SheetNoise made;
  made.isVolume = true;
  noise::MakeOptions options = asFloats(std::move(stop));
  options.progress = std::move(progress);
  std::vector<float> values = floatsOf(noise::make3d(noiseOf(settings), side, side, side, options));
  if (values.empty()) return made;
  made.side = side;
  made.levels.push_back(std::move(values));
  measure(made);
  return made;
}

}  // namespace skydrop::render
