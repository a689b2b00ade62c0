// skydrop noise --generate: a texture or a volume of gradient noise to a file.
#include <optional>
#include <string>
#include <vector>

#include "app/cli/noise_picture.h"
#include "app/cli/verbs.h"
#include "app/console/progress.h"
#include "app/console/standard_output.h"
#include "app/measure/stopwatch.h"
#include "skydrop/core/message.h"
#include "skydrop/noise/noise_generator.h"
#include "skydrop/noise/noise_recipe.h"

namespace skydrop::app {
namespace {

// Every file that will be written, opened or refused before the work.
std::vector<core::OutputFile> openFiles(const NoiseRequest& request) {
  const noise::NoiseSize& size = request.texture->size;
  std::vector<core::OutputFile> files;
  if (request.format != NoiseFormat::png || !size.isVolume()) {
    files.push_back(openOutput(request.file).value());
    return files;
  }
  core::TextureData shape;
  shape.depth = size.slices;
  for (int layer = 0; layer < size.slices; ++layer)
    files.push_back(openOutput(layerFile(request.file, shape, layer)).value());
  return files;
}

core::TextureData make(const CommandLine& line) {
  const NoiseTextureRequest& request = *line.noise.texture;
  Progress progress("noise", line.progress);
  noise::MakeOptions options{.format = request.texels, .postProcess = request.recipe.postProcess};
  options.progress = [&](double share) {
    if (progress.isDue()) progress.show(std::to_string(static_cast<int>(100 * share)) + " %");
  };
  return noise::makeNoise(request.recipe.settings, request.size, options);
}

}  // namespace

int generateNoise(const CommandLine& line) {
  const NoiseRequest& request = line.noise;
  std::vector<core::OutputFile> files = openFiles(request);
  const Stopwatch watch;
  const core::TextureData texture = make(line);
  const double seconds = watch.seconds();
  if (request.format == NoiseFormat::png) {
    for (std::size_t layer = 0; layer < files.size(); ++layer)
      files[layer].write(core::encodePng(pictureOf(texture, static_cast<int>(layer))));
  } else {
    std::vector<std::byte> bytes = core::encodeDds(
        texture, request.format == NoiseFormat::dds ? core::DdsHeader::legacy : core::DdsHeader::dx10);
    noise::putRecipe(bytes, request.texture->recipe);
    files.front().write(bytes);
  }
  print("%s: %dx%d%s %s, %s; made in %.2f s\n", core::printable(request.file).c_str(), texture.width,
        texture.height, texture.isVolume() ? ("x" + std::to_string(texture.depth)).c_str() : "",
        std::string(core::texelFormatName(texture.format)).c_str(),
        noise::recipeText(request.texture->recipe).c_str(), seconds);
  return 0;
}

}  // namespace skydrop::app
