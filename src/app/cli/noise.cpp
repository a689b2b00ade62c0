// skydrop noise: makes, checks, exports and reads the noise textures of the clouds.
#include <algorithm>
#include <optional>
#include <set>
#include <system_error>

#include "app/cli/noise_picture.h"
#include "app/cli/noise_words.h"
#include "app/cli/verbs.h"
#include "app/console/message.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/measure/stopwatch.h"
#include "app/session/noise_store.h"
#include "app/session/open_context.h"
#include "app/window/noise_tool_run.h"
#include "skydrop/clouds/noise_cache.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/message.h"
#include "skydrop/core/output_file.h"
#include "skydrop/noise/noise_recipe.h"
#include "skydrop/render/clouds/noise_maker.h"

namespace skydrop::app {
namespace {

using clouds::NoiseTexture;
using core::TextureData;

// The largest texture that core::decodeDds() reads, and both its headers.
constexpr std::size_t kMostFileBytes = (std::size_t{256} << 20) + 148;

std::string nameOf(NoiseTexture texture) { return std::string(clouds::noiseLayout(texture).name); }

std::string sizeOf(const TextureData& texture) {
  std::string text = std::to_string(texture.width) + "x" + std::to_string(texture.height);
  if (texture.isVolume()) text += "x" + std::to_string(texture.depth);
  return text + " " + std::string(core::texelFormatName(texture.format));
}

// Writes textures to the folder that was asked for, none of them over another one or over a file that is
// read.
class Exports {
 public:
  explicit Exports(const NoiseRequest& request) : request_(request) {}

  void add(const TextureData& texture, const std::string& name) {
    if (!request_.folder) return;
    core::makeFolder(*request_.folder);
    switch (request_.format) {
      case NoiseFormat::dds:
        return core::writeDds(target(name + ".dds"), texture, core::DdsHeader::legacy);
      case NoiseFormat::dx10:
        return core::writeDds(target(name + ".dds"), texture, core::DdsHeader::dx10);
      case NoiseFormat::png:
        return addPng(texture, name);
    }
  }

 private:
  void addPng(const TextureData& texture, const std::string& name) {
    for (int layer = 0; layer < std::max(texture.depth, 1); ++layer)
      core::writePng(target(layerFile(name + ".png", texture, layer)), pictureOf(texture, layer));
  }

  std::filesystem::path target(const std::string& name) {
    const std::filesystem::path file = *request_.folder / name;
    if (!written_.insert(file).second)
      throw core::DataError(file.string(), "export", "would replace another one");
    std::error_code ignored;
    for (const std::filesystem::path& input : request_.files) {
      if (std::filesystem::equivalent(input, file, ignored))
        throw core::DataError(file.string(), "export", "would replace the file that is read");
    }
    return file;
  }

  const NoiseRequest& request_;
  std::set<std::filesystem::path> written_;
};

// What is written is opened or refused before anything is made.
void requireExports(const CommandLine& line) {
  if (!line.noise.folder) return;
  const std::filesystem::path& folder = *line.noise.folder;
  core::requireFolder(folder);
  if (!std::filesystem::exists(folder) || line.noise.format == NoiseFormat::png) return;
  std::vector<std::string> names;
  for (const std::filesystem::path& file : line.noise.files) names.push_back(noiseExportName(file));
  if (names.empty()) {
    for (const NoiseTexture texture : clouds::kNoiseTextures) names.push_back(nameOf(texture));
  }
  for (const std::string& name : names) core::OutputFile(folder / (name + ".dds"));
}

TextureData madeByGpu(render::gl::Context& context, NoiseTexture texture, std::uint32_t seed) {
  constexpr int kSlices = 4;  // a fraction of a second each on a software renderer
  render::NoiseMaker maker(context, texture, seed);
  while (!maker.done()) maker.make(kSlices);
  return maker.read();
}

// Both makers, compared; each texture's borders. True when all is well.
bool check(const CommandLine& line, std::uint32_t seed, Exports& exports) {
  // What a seam adds to the step between neighbours; noise of a few cells leaves it within a quarter of 1.
  constexpr double kRoughest = 1.5;
  const auto context = openContext(line.backend, {64, 64});
  bool good = true;
  Progress progress("noise", line.progress);
  for (const NoiseTexture texture : clouds::kNoiseTextures) {
    progress.show(nameOf(texture));
    const Stopwatch processor;
    const TextureData cpu = clouds::makeNoise(texture, seed);
    const double cpuSeconds = processor.seconds();
    const Stopwatch graphics;
    const TextureData gpu = madeByGpu(*context, texture, seed);
    const double gpuSeconds = graphics.seconds();
    const clouds::NoiseDifference apart = clouds::noiseDifference(cpu, gpu);
    const double seam = clouds::seamRoughness(cpu);
    const bool agrees = apart.largest <= 1 && seam <= kRoughest;
    progress.clear();
    print("%-8s %-20s processor %6.2f s  shader %6.2f s  largest difference %d  mean %.5f  seam %.2f  %s\n",
          nameOf(texture).c_str(), sizeOf(cpu).c_str(), cpuSeconds, gpuSeconds, apart.largest, apart.mean,
          seam, agrees ? "ok" : "WRONG");
    good = good && agrees;
    exports.add(cpu, nameOf(texture));
  }
  return good;
}

void readFiles(const CommandLine& line, Exports& exports) {
  for (const std::filesystem::path& file : line.noise.files) {
    const std::string name = core::inputName(file);
    const auto bytes = core::readInput(file, kMostFileBytes);
    const TextureData texture = core::decodeDds(bytes, name);
    const std::optional<noise::NoiseRecipe> recipe = noise::recipeOf(bytes);
    print("%s: %s, seam %.2f%s\n", core::printable(name).c_str(), sizeOf(texture).c_str(),
          clouds::seamRoughness(texture), recipe ? (", " + noise::recipeText(*recipe)).c_str() : "");
    exports.add(texture, noiseExportName(file));
  }
}

void fromStore(const CommandLine& line, std::uint32_t seed, Exports& exports) {
  const NoiseStore store(cacheFolder());
  Progress progress("noise", line.progress);
  for (const NoiseTexture texture : clouds::kNoiseTextures) {
    const Stopwatch watch;
    StoredNoise stored = store.find(texture, seed);
    if (!stored.fromCache) {
      // Made for the cache alone it would be lost.
      if (!line.noise.folder && !cacheFolder().empty()) core::requireFolder(cacheFolder());
      progress.show(nameOf(texture));
      stored = store.get(texture, seed);
      progress.clear();
    }
    print("%-8s %-20s %s in %.2f s\n", nameOf(texture).c_str(), sizeOf(stored.texture).c_str(),
          stored.fromCache ? "from the cache" : "made", watch.seconds());
    if (!stored.message.empty()) warn(stored.message);
    exports.add(stored.texture, nameOf(texture));
  }
}

}  // namespace

int noise(const CommandLine& line) {
  if (line.noise.tool) {
    line.noise.file.empty() ? runNoiseTool(line) : drawNoiseTool(line);
    return 0;
  }
  if (line.noise.texture) return generateNoise(line);
  const auto seed = static_cast<std::uint32_t>(line.seed.value_or(0));
  requireExports(line);
  Exports exports(line.noise);
  if (line.noise.check) return check(line, seed, exports) ? 0 : 1;
  if (!line.noise.files.empty())
    readFiles(line, exports);
  else
    fromStore(line, seed, exports);
  return 0;
}

}  // namespace skydrop::app
