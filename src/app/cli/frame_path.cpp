#include "app/cli/frame_path.h"

#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

// Where the file's name begins in a path.
std::size_t nameAt(const std::string& path) { return path.rfind('/') + 1; }

}  // namespace

bool countsFrames(const std::string& pattern) {
  bool counts = false;
  for (std::size_t i = pattern.find('%', nameAt(pattern)); i < pattern.size(); i = pattern.find('%', i + 2)) {
    const char what = i + 1 < pattern.size() ? pattern[i + 1] : 0;
    if (what != 'd' && what != '%') {
      throw core::UsageError("--out: '" + pattern +
                             "': in a name % is followed by d (the frame's number) or % (a percent sign)");
    }
    counts = counts || what == 'd';
  }
  return counts;
}

std::string framePath(const std::string& pattern, int frame) {
  const std::size_t name = nameAt(pattern);
  std::string path = pattern.substr(0, name);
  for (std::size_t i = name; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      path += pattern[i];
    } else if (pattern[++i] == 'd') {
      path += std::to_string(frame);
    } else {
      path += '%';
    }
  }
  return path;
}

}  // namespace skydrop::app
