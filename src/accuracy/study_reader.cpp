#include "accuracy/study_reader.h"

#include <algorithm>

#include "skydrop/core/error.h"
#include "skydrop/core/json.h"

namespace skydrop::accuracy {
namespace {

std::string joined(std::string_view place, std::string_view name) {
  return place.empty() ? std::string(name) : std::string(place) + "." + std::string(name);
}

}  // namespace

void StudyReader::refuse(std::string_view place, std::string_view reason) const {
  throw core::DataError(file_, place, reason);
}

void StudyReader::requireObject(const nlohmann::json& json, std::string_view place,
                                std::initializer_list<std::string_view> members) const {
  if (!json.is_object()) refuse(place, "is not an object");
  for (const auto& [name, value] : json.items()) {
    if (std::ranges::find(members, name) == members.end()) refuse(joined(place, name), "unknown member");
  }
}

const nlohmann::json& StudyReader::list(const nlohmann::json& of, const std::string& name,
                                        std::string_view place, std::size_t most) const {
  const auto found = of.find(name);
  if (found == of.end() || !found->is_array() || found->empty())
    refuse(joined(place, name), "is not a list with something in it");
  if (found->size() > most)
    refuse(joined(place, name), "has more than " + std::to_string(most) + " elements");
  return *found;
}

std::string StudyReader::text(const nlohmann::json& of, const std::string& name,
                              std::string_view place) const {
  const std::string text = core::jsonText(of.value(name, nlohmann::json()), file_, joined(place, name));
  if (text.empty()) refuse(joined(place, name), "is empty");
  return text;
}

std::string StudyReader::textOr(const nlohmann::json& of, const std::string& name, std::string_view place,
                                std::string_view otherwise) const {
  return of.contains(name) ? text(of, name, place) : std::string(otherwise);
}

double StudyReader::number(const nlohmann::json& value, std::string_view place, double least,
                           double most) const {
  return core::jsonNumber(value, file_, place, least, most);
}

std::string StudyReader::valueText(const nlohmann::json& value, std::string_view place) const {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number() || value.is_boolean()) return value.dump();
  refuse(place, "is no number, flag or name");
}

Assignments StudyReader::assignments(const nlohmann::json& of, const std::string& name,
                                     std::string_view place) const {
  Assignments all;
  const auto found = of.find(name);
  if (found == of.end()) return all;
  if (!found->is_object()) refuse(joined(place, name), "is not an object");
  for (const auto& [path, value] : found->items())
    all.push_back(path + "=" + valueText(value, joined(place, name) + "." + path));
  return all;
}

}  // namespace skydrop::accuracy
