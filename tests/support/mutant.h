// Damaged copies of a text, for readers: truncations, flipped, inserted and repeated bytes.
#pragma once

#include <random>
#include <string>
#include <string_view>

namespace skydrop::test {

// Of a text that is not empty. Half of the bytes that come in are of those that mean something to the reader.
inline std::string mutantOf(const std::string& original, std::mt19937& random, std::string_view interesting) {
  std::string text = original;
  const auto place = [&] { return random() % text.size(); };
  const char c =
      random() % 2 ? interesting[random() % interesting.size()] : static_cast<char>(random() % 256);
  switch (random() % 4) {
    case 0:
      text.resize(place());
      break;
    case 1:
      text[place()] = c;
      break;
    case 2: {
      const std::size_t at = place();
      text.insert(at, 1 + random() % 3, c);
      break;
    }
    case 3: {
      const std::size_t from = place(), length = random() % 40;
      const std::string part = text.substr(from, length);
      text.insert(from, part);
    }
  }
  return text;
}

}  // namespace skydrop::test
