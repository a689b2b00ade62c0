// What is wrong while the game goes on: one line for each part of the program, until that part is repaired.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace skydrop::app {

class Faults {
 public:
  // True if it is news: the part was sound, or had another fault.
  bool set(std::string_view part, std::string line) {
    const auto known = find(part);
    if (known != standing_.end() && known->line == line) return false;
    if (known != standing_.end()) standing_.erase(known);
    standing_.push_back({std::string(part), std::move(line)});
    return true;
  }
  // The part is sound again.
  void clear(std::string_view part) {
    if (const auto known = find(part); known != standing_.end()) standing_.erase(known);
  }
  // The latest that stands; empty: none.
  std::string_view shown() const {
    return standing_.empty() ? std::string_view() : std::string_view(standing_.back().line);
  }

 private:
  struct Fault {
    std::string part, line;
  };
  std::vector<Fault>::iterator find(std::string_view part) {
    return std::ranges::find(standing_, part, &Fault::part);
  }

  std::vector<Fault> standing_;  // the oldest first
};

}  // namespace skydrop::app
