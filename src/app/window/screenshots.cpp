#include "app/window/screenshots.h"

#include <ctime>
#include <string>
#include <utility>

#include "skydrop/core/file.h"

namespace skydrop::app {
namespace {

std::string timeStamp() {
  const std::time_t now = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y%m%d-%H%M%S", std::localtime(&now));
  return text;
}

}  // namespace

Screenshots::Screenshots(std::filesystem::path folder) : folder_(std::move(folder)) {}

std::filesystem::path Screenshots::save(const core::Image& image, std::span<const core::PictureText> texts) {
  const std::filesystem::path file =
      folder_ / ("skydrop-" + timeStamp() + "-" + std::to_string(count_ + 1) + ".png");
  core::makeFolder(folder_);
  core::writePng(file, image, texts);
  ++count_;
  return file;
}

}  // namespace skydrop::app
