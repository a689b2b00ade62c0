// Where the player's screenshots go, and under which names.
#pragma once

#include <filesystem>
#include <span>

#include "skydrop/core/image.h"

namespace skydrop::app {

class Screenshots {
 public:
  // The folder is made by the first one.
  explicit Screenshots(std::filesystem::path folder);

  // Writes skydrop-DATE-TIME-NUMBER.png with `texts` in it and returns its whole name. Throws
  // core::DataError.
  std::filesystem::path save(const core::Image& image, std::span<const core::PictureText> texts);
  int count() const { return count_; }

 private:
  std::filesystem::path folder_;
  int count_ = 0;
};

}  // namespace skydrop::app
