#include "support/temporary_folder.h"

#include <atomic>
#include <random>

#include "skydrop/core/file.h"

namespace skydrop::test {

TemporaryFolder::TemporaryFolder() {
  // Suites run side by side: the name is random across processes and counted within one.
  static std::atomic<int> count = 0;
  std::random_device random;
  path_ = std::filesystem::temp_directory_path() /
          ("skydrop_test_" + std::to_string(random()) + "_" + std::to_string(count++));
  std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(std::string_view name, std::string_view content) const {
  const std::filesystem::path file = path_ / name;
  core::writeFileAtomically(file, content);
  return file.string();
}

}  // namespace skydrop::test
