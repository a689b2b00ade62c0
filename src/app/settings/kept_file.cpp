#include "app/settings/kept_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "skydrop/core/error.h"
#include "skydrop/core/message.h"
#include "skydrop/core/output_file.h"
#include "skydrop/core/settings_file.h"

namespace skydrop::app {
namespace {

constexpr std::size_t kMostComplaints = 3;  // in one line

nlohmann::json emptyContent() { return {{"settings", nlohmann::json::object()}}; }

bool isThere(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

bool mayBeRead(const std::filesystem::path& file) {
  return ::faccessat(AT_FDCWD, file.c_str(), R_OK, AT_EACCESS) == 0;
}

std::pair<std::string, std::string_view> firstName(std::string_view path) {
  const std::size_t dot = path.find('.');
  if (dot == std::string_view::npos) return {std::string(path), {}};
  return {std::string(path.substr(0, dot)), path.substr(dot + 1)};
}

// The member of an object, or of a list by its number; null where there is none.
nlohmann::json* memberOf(nlohmann::json& node, const std::string& name) {
  if (node.is_object() && node.contains(name)) return &node[name];
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  if (!node.is_array() || error != std::errc() || end != name.data() + name.size()) return nullptr;
  return index < node.size() ? &node[index] : nullptr;
}

}  // namespace

KeptFile::KeptFile() : content_(std::make_shared<const nlohmann::json>(emptyContent())) {}

KeptFile::KeptFile(std::filesystem::path file) : KeptFile() { file_ = std::move(file); }

std::optional<std::string> KeptFile::load() {
  if (file_.empty() || !isThere(file_)) return std::nullopt;
  try {
    reload();
    return std::nullopt;
  } catch (const core::DataError& refusal) {
    const std::string line = std::string(refusal.what()) + "; defaults are used";
    if (!mayBeRead(file_)) return line;
    try {
      return line + ", the file is kept as " + core::setAside(file_).string();
    } catch (const core::DataError&) {
      return line;
    }
  }
}

void KeptFile::reload() {
  content_ =
      std::make_shared<const nlohmann::json>(core::readSettingsFile(file_, {}, core::UnknownMembers::keep));
}

std::optional<std::string> KeptFile::save(const Change& change) {
  if (file_.empty()) return std::nullopt;
  std::optional<std::string> line;
  nlohmann::json before = emptyContent();
  try {
    if (isThere(file_)) before = core::readSettingsFile(file_, {}, core::UnknownMembers::keep);
  } catch (const core::DataError& refusal) {
    if (!mayBeRead(file_)) throw;
    before = *content_;
    line = refusal.what();
  }
  nlohmann::json after = before;
  change(after);
  if (after == before) {
    if (!line) content_ = std::make_shared<const nlohmann::json>(after);
    return line;
  }
  if (line)
    *line +=
        "; the file is kept as " + core::setAside(file_).string() + " and replaced by what was read last";
  nlohmann::json written = after;
  if (written["settings"].empty()) written.erase("settings");
  core::writeSettingsFile(file_, written);
  content_ = std::make_shared<const nlohmann::json>(std::move(after));
  return line;
}

std::optional<std::string> KeptFile::complaintLine(const std::vector<std::string>& complaints) const {
  if (complaints.empty()) return std::nullopt;
  std::string line = file_.string() + ": ";
  for (std::size_t i = 0; i < std::min(complaints.size(), kMostComplaints); ++i) line += complaints[i] + "; ";
  if (complaints.size() > kMostComplaints) {
    line += "and " + std::to_string(complaints.size() - kMostComplaints) + " more; ";
  }
  return core::printable(line + "not used, but kept");
}

void setAt(nlohmann::json& settings, std::string_view path, const nlohmann::json& value) {
  const auto [name, rest] = firstName(path);
  if (!settings.is_object() && !memberOf(settings, name)) settings = nlohmann::json::object();
  nlohmann::json* member = memberOf(settings, name);
  if (!member) member = &settings[name];
  if (rest.empty()) {
    *member = value;
  } else {
    setAt(*member, rest, value);
  }
}

void eraseAt(nlohmann::json& settings, std::string_view path) {
  const auto [name, rest] = firstName(path);
  nlohmann::json* member = memberOf(settings, name);
  if (!member) return;
  if (!rest.empty()) eraseAt(*member, rest);
  const bool isLeft = !rest.empty() && !(member->is_object() && member->empty());
  if (!isLeft && settings.is_object()) settings.erase(name);
}

}  // namespace skydrop::app
