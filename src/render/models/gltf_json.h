// Checked access to the JSON of a glTF file: every member has the type and the range that is asked for, or
// the file is refused with the place of the member.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/render/models/model_import.h"

namespace skydrop::render {

// "nodes[3]"
inline std::string at(const std::string& name, std::size_t i) { return name + "[" + std::to_string(i) + "]"; }

class GltfJson {
 protected:
  using json = nlohmann::json;

  static constexpr std::size_t kLongestName = 256;

  // `file` as messages name it.
  explicit GltfJson(std::string file) : file_(std::move(file)) {}

  const std::string& file() const { return file_; }

  // Throws core::DataError.
  [[noreturn]] void fail(std::string_view place, std::string_view reason) const {
    throw core::DataError(file_, place, reason);
  }

  static const json* member(const json& object, const char* name) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(name);
    return found == object.end() ? nullptr : &*found;
  }

  const json& list(const json& object, const char* name, const std::string& place) const {
    static const json empty = json::array();
    const json* found = member(object, name);
    if (!found) return empty;
    if (!found->is_array() || found->size() > kMostGltfObjects)
      fail(place + name, "is not a list, or too long");
    return *found;
  }

  // A list of objects.
  const json& objects(const json& root, const char* name) const {
    const json& all = list(root, name, "");
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].is_object()) fail(at(name, i), "is not an object");
    }
    return all;
  }

  // A whole number; `fallback` where it is not given.
  std::uint64_t whole(const json& object, const char* name, const std::string& place,
                      std::optional<std::uint64_t> fallback = std::nullopt) const {
    const json* value = member(object, name);
    if (!value && fallback) return *fallback;
    if (!value || !value->is_number_unsigned()) fail(place + "." + name, "is not a whole number");
    return value->get<std::uint64_t>();
  }

  // An index into a list of `size`; nullopt where it is not given.
  std::optional<std::uint64_t> index(const json& object, const char* name, const std::string& place,
                                     std::uint64_t size) const {
    if (!object.is_object()) fail(place, "is not an object");
    if (!member(object, name)) return std::nullopt;
    const std::uint64_t value = whole(object, name, place);
    if (value >= size) fail(place + "." + name, std::to_string(value) + " is out of range");
    return value;
  }

  // Empty where it is not given.
  std::string text(const json& object, const char* name, const std::string& place,
                   std::size_t longest) const {
    const json* value = member(object, name);
    if (!value) return {};
    if (!value->is_string()) fail(place + "." + name, "is not a text");
    const std::string& text = value->get_ref<const std::string&>();
    if (text.size() > longest)
      fail(place + "." + name, "is longer than " + std::to_string(longest) + " bytes");
    if (text.find('\0') != std::string::npos) fail(place + "." + name, "holds a zero byte");
    return text;
  }

  // Empty where it is not given.
  std::vector<double> numbers(const json& node, const char* name, std::size_t count,
                              const std::string& place) const {
    const json* given = member(node, name);
    if (!given) return {};
    bool good = given->is_array() && given->size() == count;
    for (std::size_t k = 0; good && k < count; ++k) good = (*given)[k].is_number();
    if (!good) fail(place + "." + name, "is not a list of " + std::to_string(count) + " numbers");
    const std::vector<double> values = given->get<std::vector<double>>();
    for (const double value : values) {
      if (!(std::abs(value) <= kMaxModelCoordinate)) fail(place + "." + name, "a number is beyond 1e6");
    }
    return values;
  }

 private:
  static constexpr std::uint64_t kMostGltfObjects = 4096;  // of any list in the file

  std::string file_;
};

}  // namespace skydrop::render
