#include "skydrop/core/error.h"

namespace skydrop::core {
namespace {

std::string oneLine(std::string_view file, std::string_view place, std::string_view reason) {
  std::string line(file);
  if (!place.empty()) line.append(": ").append(place);
  line.append(": ").append(reason);
  for (char& c : line) {
    if (c == '\n' || c == '\r') c = ' ';
  }
  return line;
}

}  // namespace

DataError::DataError(std::string_view file, std::string_view place, std::string_view reason)
    : std::runtime_error(oneLine(file, place, reason)) {}

}  // namespace skydrop::core
