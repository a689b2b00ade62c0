// A JSON file (core/settings_file.h) of the player's folder, written by the program, by the player's editor
// and by other versions of the program. So it is never written over as a whole: it is read again and changed
// where the program has something to say, and what it does not know stays. Main thread.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::app {

class KeptFile {
 public:
  KeptFile();  // nowhere: nothing is read or written
  explicit KeptFile(std::filesystem::path file);

  const std::filesystem::path& path() const { return file_; }
  // What was read or written last and was whole; `settings` is in it.
  const nlohmann::json& content() const { return *content_; }

  // At the start. A file that is broken as a whole (no JSON, another schema) is renamed to the first of
  // NAME.bad, NAME.bad2, ... that is free, and the line to say so comes back; one that may not be read stays
  // where it is. No file is as good as an empty one.
  std::optional<std::string> load();
  // After somebody wrote it. Throws core::DataError where it is broken: the content stays, and so does the
  // file.
  void reload();

  // Reads the file again, lets `change` say what is new, and writes it if that is anything. A file that was
  // broken meanwhile is set aside for the last whole content; the line to say so comes back. Throws
  // core::DataError, also where the file may not be read: what it holds is not written over.
  using Change = std::function<void(nlohmann::json& content)>;
  std::optional<std::string> save(const Change& change);

  // "FILE: aircraft.wings: unknown setting; not used": nothing where there are no complaints.
  std::optional<std::string> complaintLine(const std::vector<std::string>& complaints) const;

 private:
  std::filesystem::path file_;
  std::shared_ptr<const nlohmann::json> content_;
};

// Puts a value at a path of settings ("aircraft.mass"), or takes it away with the groups that are empty then.
void setAt(nlohmann::json& settings, std::string_view path, const nlohmann::json& value);
void eraseAt(nlohmann::json& settings, std::string_view path);

}  // namespace skydrop::app
