#include <thread>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "app/session/open_context.h"
#include "app/types/version.h"
#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/image.h"
#include "skydrop/core/message.h"
#include "skydrop/render/gl/limits.h"

namespace skydrop::app {

namespace {

constexpr std::size_t kMostTextBytes = std::size_t{1} << 20;

int describePicture(const std::filesystem::path& file) {
  const std::vector<core::PictureText> texts = core::readPngTexts(core::readFile(file), file.string());
  if (texts.empty()) throw core::DataError(file.string(), "texts", "the file says nothing about its picture");
  for (const core::PictureText& text : texts)
    print("%s %s\n", core::printable(text.keyword).c_str(),
          core::printable(text.text, kMostTextBytes).c_str());
  return 0;
}

}  // namespace

int info(const CommandLine& line) {
  if (line.picture) return describePicture(*line.picture);
  print("skydrop %s\n", kVersion);
  print("data %s\n", core::dataFolder().string().c_str());
  print("processor threads %u\n", std::thread::hardware_concurrency());
  const auto context = openContext(line.backend, {64, 64});
  print("backend %s\n", std::string(render::gl::backendName(context->backend())).c_str());
  print("OpenGL %s\n", context->version().c_str());
  print("renderer %s (%s)%s\n", context->renderer().c_str(), context->vendor().c_str(),
        context->isSoftware() ? ", software" : "");
  for (const auto& [name, limit] : render::gl::describeLimits(*context)) {
    print("%s %lld\n", name.c_str(), static_cast<long long>(limit));
  }
  return 0;
}

}  // namespace skydrop::app
