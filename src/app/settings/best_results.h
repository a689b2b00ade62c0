// The best deliveries of a player: deliveries.json in the player's folder, kept from flight to flight. A file
// may hold anything: what is no result is reported and left out, a file that is broken as a whole is set
// aside (kept_file.h). Main thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/settings/kept_file.h"

namespace skydrop::app {

// A delivery that hit.
struct BestResult {
  std::int64_t points = 0;  // 1 .. 100000
  double distanceM = 0;     // 0 .. 1000, from the centre
  double seconds = 0;       // 0 .. 86400, from when the target was there
  std::string scene;        // its name, 1 .. 64 printable characters

  bool operator==(const BestResult&) const = default;
};

class BestResults {
 public:
  static constexpr std::size_t kKept = 10;

  BestResults() = default;                                    // of nobody: nothing is read or written
  explicit BestResults(const std::filesystem::path& folder);  // the player's

  // At the start. The line to warn of comes back.
  std::optional<std::string> load();
  // Takes a hit over where it is among the best; returns its place from 1, or 0. Equal points stay behind
  // those that were first. What is no result (points, distance or seconds out of range) has none.
  std::size_t add(const BestResult& result);
  // Writes them where they changed, together with those that another program has written since. The line to
  // warn of comes back. Throws core::DataError.
  std::optional<std::string> save();

  const std::vector<BestResult>& all() const { return best_; }  // the best first, at most kKept

 private:
  void merge(const std::vector<BestResult>& others);

  KeptFile file_;
  std::vector<BestResult> best_;
  bool changed_ = false;
};

std::filesystem::path bestResultsFile(const std::filesystem::path& folder);

// The results in the member "best" of a file's content, the best first, at most kKept; a line about each part
// that is none.
std::vector<BestResult> readBest(const nlohmann::json& content, std::vector<std::string>& complaints);

}  // namespace skydrop::app
