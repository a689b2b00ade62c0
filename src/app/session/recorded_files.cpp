#include "app/session/recorded_files.h"

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::app {

FileRecords recordsOf(const std::vector<std::filesystem::path>& files,
                      const std::vector<std::uint64_t>& digests, const FileRecords* flown,
                      const std::string& log) {
  FileRecords records;
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(files[i], error);
    records.push_back({(error ? files[i] : absolute).string(), digests[i]});
    if (flown && (*flown)[i].digest != digests[i])
      throw core::DataError(
          core::inputName(files[i]), "",
          "is not what " + log + " was flown in: " + (*flown)[i].source + " had another content");
  }
  return records;
}

std::vector<std::filesystem::path> sourcesOf(const FileRecords& records) {
  std::vector<std::filesystem::path> files;
  for (const auto& record : records) files.emplace_back(record.source);
  return files;
}

}  // namespace skydrop::app
