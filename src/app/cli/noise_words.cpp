#include "app/cli/noise_words.h"

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/noise/noise_generator.h"

namespace skydrop::app {
namespace {

using core::UsageError;

core::TexelFormat noiseTexels(bool alpha, int bits) {
  using core::TexelFormat;
  if (alpha && bits != 8) {
    throw UsageError("--bits " + std::to_string(bits) +
                     ": DDS has alpha alone in 8 bits only; --channel luminance has 16 and 32");
  }
  switch (bits) {
    case 8:
      return alpha ? TexelFormat::a8 : TexelFormat::r8;
    case 16:
      return TexelFormat::r16;
    case 32:
      return TexelFormat::r32f;
    default:
      throw UsageError("--bits: " + std::to_string(bits) + " is not one of 8 16 32");
  }
}

}  // namespace

NoiseTextureRequest noiseTexture(const NoiseWords& words, std::uint64_t seed) {
  NoiseTextureRequest request;
  noise::NoiseSettings& settings = request.recipe.settings;
  settings.octaves = words.octaves.value_or(static_cast<int>(settings.octaves));
  settings.frequency = words.frequency.value_or(static_cast<int>(settings.frequency));
  settings.amplitude = words.amplitude.value_or(settings.amplitude);
  settings.persistence = words.persistence.value_or(settings.persistence);
  settings.seed = static_cast<std::uint32_t>(seed);
  if (words.cutoff || words.density) {
    noise::PostProcess cut;
    cut.cutoff = words.cutoff.value_or(cut.cutoff);
    cut.density = words.density.value_or(cut.density);
    request.recipe.postProcess = cut;
  }
  const bool volume = words.volume.value_or(false);
  if (!volume && words.slices) throw UsageError("--slices belongs to --generate 3d");
  request.size.width = words.width.value_or(volume ? 128 : 512);
  request.size.height = words.height.value_or(request.size.width);
  if (volume) request.size.slices = words.slices.value_or(request.size.width);
  request.texels = noiseTexels(words.alpha.value_or(words.bits.value_or(8) == 8), words.bits.value_or(8));
  try {
    noise::requireSettings(settings);
    if (request.recipe.postProcess) noise::requirePostProcess(*request.recipe.postProcess);
    if (volume && request.size.slices == 0) throw core::RangeError("slices: 0 layers make no volume");
    noise::requireTexture(request.size, request.texels);
  } catch (const core::RangeError& refusal) {
    throw UsageError(std::string("--") + refusal.what());
  }
  return request;
}

std::string noiseExportName(const std::filesystem::path& file) {
  return core::isStandardInput(file) ? "stdin" : file.stem().string();
}

}  // namespace skydrop::app
