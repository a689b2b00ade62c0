// Members of a study's JSON, read one by one so that every refusal names its place.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/accuracy/study.h"

namespace skydrop::accuracy {

class StudyReader {
 public:
  explicit StudyReader(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void refuse(std::string_view place, std::string_view reason) const;
  // An object with no other members than these.
  void requireObject(const nlohmann::json& json, std::string_view place,
                     std::initializer_list<std::string_view> members) const;
  // An array that is not empty and has at most so many elements.
  const nlohmann::json& list(const nlohmann::json& of, const std::string& name, std::string_view place,
                             std::size_t most) const;
  std::string text(const nlohmann::json& of, const std::string& name, std::string_view place) const;
  std::string textOr(const nlohmann::json& of, const std::string& name, std::string_view place,
                     std::string_view otherwise) const;
  double number(const nlohmann::json& value, std::string_view place, double least, double most) const;
  // {"path": value} with numbers, flags and names as values.
  Assignments assignments(const nlohmann::json& of, const std::string& name, std::string_view place) const;
  // "0.5", "true", "low".
  std::string valueText(const nlohmann::json& value, std::string_view place) const;

 private:
  std::string file_;
};

}  // namespace skydrop::accuracy
