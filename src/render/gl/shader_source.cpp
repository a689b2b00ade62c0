#include "skydrop/render/gl/shader_source.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::render::gl {
namespace {

constexpr std::size_t kMostBytes = std::size_t{4} << 20;

// Takes an unsigned number from the front of a line.
std::optional<int> takeNumber(std::string_view& line) {
  int number = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  if (error != std::errc() || number < 0) return std::nullopt;
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return number;
}

bool take(std::string_view& line, std::string_view word) {
  if (!line.starts_with(word)) return false;
  line.remove_prefix(word.size());
  return true;
}

void skipBlanks(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
}

// The name between the quotes of an #include line, or empty.
std::string_view includedName(std::string_view line) {
  skipBlanks(line);
  if (!take(line, "#")) return {};
  skipBlanks(line);
  if (!take(line, "include")) return {};
  skipBlanks(line);
  if (!take(line, "\"")) return {};
  const std::size_t end = line.find('"');
  return end == std::string_view::npos ? std::string_view{} : line.substr(0, end);
}

struct LogLine {
  int line = 0;
  std::string_view text;
};

// One line of a compiler's log: Mesa "0:12(5): error: ...", NVIDIA "0(12) : error C1008: ...", AMD and Intel
// "ERROR: 0:12: ...".
std::optional<LogLine> parseLogLine(std::string_view line) {
  take(line, "ERROR:");
  skipBlanks(line);
  if (!takeNumber(line)) return std::nullopt;  // the string's number, always 0
  std::optional<int> number;
  if (take(line, ":")) {
    number = takeNumber(line);
    if (number && take(line, "(") && !(takeNumber(line) && take(line, ")"))) return std::nullopt;
  } else if (take(line, "(")) {
    number = takeNumber(line);
    if (!take(line, ")")) return std::nullopt;
  }
  skipBlanks(line);
  if (!number || !take(line, ":")) return std::nullopt;
  skipBlanks(line);
  return LogLine{*number, line};
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
  const std::string content = core::readTextFile(path, kMostBytes);
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
    if (!std::filesystem::exists(target, ignored)) target = path.parent_path() / included;
    if (!std::filesystem::exists(target, ignored)) {
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
  for (std::string_view rest = log; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::optional<LogLine> parsed = parseLogLine(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!parsed || parsed->text.starts_with("warning")) continue;
    return {place(parsed->line), std::string(parsed->text)};
  }
  return {place(0), std::string(log)};
}

}  // namespace skydrop::render::gl
