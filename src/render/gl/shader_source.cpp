#include "skydrop/render/gl/shader_source.h"

#include <algorithm>
#include <regex>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::render::gl {
namespace {

// The name between the quotes of an #include line, or empty.
std::string_view includedName(std::string_view line) {
  const auto skipBlanks = [&line] {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  };
  skipBlanks();
  if (!line.starts_with('#')) return {};
  line.remove_prefix(1);
  skipBlanks();
  if (!line.starts_with("include")) return {};
  line.remove_prefix(7);
  skipBlanks();
  if (!line.starts_with('"')) return {};
  line.remove_prefix(1);
  const std::size_t end = line.find('"');
  return end == std::string_view::npos ? std::string_view{} : line.substr(0, end);
}

}  // namespace

ShaderSource::ShaderSource(std::string_view entry, std::span<const std::string> defines) {
  appendLine("#version 450 core", {});
  for (const std::string& define : defines) {
    const bool hasValue = define.find(' ') != std::string::npos;
    appendLine("#define " + define + (hasValue ? "" : " 1"), {});
  }
  append(core::shaderPath(entry), std::string(entry));
}

void ShaderSource::appendLine(std::string_view line, Line origin) {
  text_.append(line).push_back('\n');
  lines_.push_back(origin);
}

void ShaderSource::append(const std::filesystem::path& path, const std::string& name) {
  std::error_code ignored;
  files_.push_back({path, std::filesystem::last_write_time(path, ignored)});
  const std::string content = core::readTextFile(path);
  const int file = static_cast<int>(names_.size());
  names_.push_back(name);
  int number = 0;
  for (std::size_t at = 0; at < content.size();) {
    const std::size_t end = std::min(content.find('\n', at), content.size());
    std::string_view line(content.data() + at, end - at);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at = end + 1;
    ++number;
    const std::string_view included = includedName(line);
    if (included.empty()) {
      appendLine(line, {file, number});
      continue;
    }
    std::filesystem::path target = core::shaderPath(included);
    if (!std::filesystem::exists(target)) target = path.parent_path() / included;
    if (!std::filesystem::exists(target)) {
      throw core::DataError(name, "line " + std::to_string(number), "no file " + std::string(included));
    }
    target = target.lexically_normal();
    const bool isNew =
        std::none_of(files_.begin(), files_.end(), [&](const File& f) { return f.path == target; });
    if (isNew) append(target, std::string(included));
  }
}

ShaderSource::Place ShaderSource::place(int line) const {
  Line origin;
  if (line >= 1 && static_cast<std::size_t>(line) <= lines_.size())
    origin = lines_[static_cast<std::size_t>(line - 1)];
  return {names_[static_cast<std::size_t>(origin.file)], origin.number};
}

ShaderSource::Message ShaderSource::firstError(std::string_view log) const {
  // Mesa "0:12(5): error: ...", NVIDIA "0(12) : error C1008: ...", AMD and Intel "ERROR: 0:12: ...".
  static const std::regex pattern(R"((?:ERROR:\s*)?\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*(.*))");
  Message first;
  for (std::size_t at = 0; at < log.size();) {
    const std::size_t end = std::min(log.find('\n', at), log.size());
    const std::string line(log.substr(at, end - at));
    at = end + 1;
    std::smatch match;
    if (!std::regex_search(line, match, pattern)) continue;
    const Message message{place(std::stoi(match[1].matched ? match[1] : match[2])), match[3]};
    if (message.text.find("warning") != std::string::npos) continue;
    return message;
  }
  first.place = place(0);
  first.text = std::string(log);
  return first;
}

}  // namespace skydrop::render::gl
