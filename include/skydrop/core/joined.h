#pragma once

#include <string>

namespace skydrop::core {

// "a, b": of a range of texts.
template <class Texts>
std::string joined(const Texts& texts) {
  std::string all;
  for (const auto& text : texts) {
    if (!all.empty()) all += ", ";
    all += text;
  }
  return all;
}

}  // namespace skydrop::core
