// JSON that others wrote. Every JSON file of the program goes through here, so that all are read alike:
// bounded in size, depth and count before anything is built of them, no name twice in an object, nothing
// after the value, UTF-8 only (a byte order mark is skipped). What is refused is a DataError of the file with
// line and column. Any thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace skydrop::core {

// Beyond any file of ours, and little enough that what recurses or allocates by the text's shape
// (destructors, dump(), checks) stays harmless.
struct JsonLimits {
  std::size_t bytes = std::size_t{1} << 20;
  int depth = 32;                // objects and lists within one another; at most a few hundred
  std::size_t values = 100'000;  // names, texts, numbers, objects and lists, all together
};

// `file` is named in what is refused. A zero byte is refused wherever it stands: text of a container that is
// padded with them must be cut to its length before.
nlohmann::json parseJson(std::string_view text, std::string_view file, const JsonLimits& limits = {});
nlohmann::json readJson(const std::filesystem::path& file, const JsonLimits& limits = {});

// Hands the parts of a text to `handler` one by one, for files that are too large to be kept as a tree. Only
// what keeps the limits and rules above arrives there; parse_error() is never called.
void scanJson(std::string_view text, std::string_view file, nlohmann::json_sax<nlohmann::json>& handler,
              const JsonLimits& limits);

// A value as what it has to be, or a DataError that names file and place. Numbers lie from `least` to `most`.
double jsonNumber(const nlohmann::json& value, std::string_view file, std::string_view place, double least,
                  double most);
double jsonWhole(const nlohmann::json& value, std::string_view file, std::string_view place, double least,
                 double most);
std::string jsonText(const nlohmann::json& value, std::string_view file, std::string_view place);

}  // namespace skydrop::core
