#include "skydrop/core/nearest_names.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace skydrop::core {
namespace {

// Costs of one part against another, and of parts that have no partner. Only their order is meant.
constexpr double kUnlike = 1;
constexpr double kBeginsAlike = 0.1, kHasWord = 0.2, kFewLetters = 0.25, kWordAlike = 0.3;
constexpr double kPartMoreThanAsked = 0.04;
constexpr double kLastPartWeight = 2;
// Parts that differ in more of their letters than this are not alike.
constexpr double kMostChanged = 0.5;
// Of the whole names, letter by letter: decides between names whose parts are equally alike.
constexpr double kLetters = 0.1;
// Longer texts are not misspelt names; likeness costs the product of the lengths.
constexpr std::size_t kLongestName = 128;

std::string lowered(std::string_view text) {
  std::string lower(text.substr(0, kLongestName));
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else if (c != ' ') {
      parts.back() += c;
    }
  }
  return parts;
}

// Share of the letters that have to be changed, 0 to 1.
double shareChanged(std::string_view a, std::string_view b) {
  if (a.empty() && b.empty()) return 0;
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({row[j + 1] + 1, row[j] + 1, substituted}));
    }
  }
  return static_cast<double>(row.back()) / static_cast<double>(std::max(a.size(), b.size()));
}

// "seaFloorDepth": sea, floor, depth.
std::vector<std::string> wordsOf(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') words.emplace_back();
    words.back() += c;
  }
  for (std::string& word : words) word = lowered(word);
  return words;
}

// `wanted` in small letters.
double partCost(const std::string& wanted, const std::string& knownPart) {
  const std::string known = lowered(knownPart);
  if (wanted == known) return 0;
  if (wanted.empty() || known.empty()) return kUnlike;
  const double shorter = static_cast<double>(std::min(wanted.size(), known.size())) /
                         static_cast<double>(std::max(wanted.size(), known.size()));
  const bool isLong = wanted.size() > 1 && known.size() > 1;  // a letter alone begins too much
  if (isLong && (known.starts_with(wanted) || wanted.starts_with(known)))
    return kBeginsAlike + (kHasWord - kBeginsAlike) * (1 - shorter);
  if (wanted.size() > 2 && known.find(wanted) != std::string::npos)
    return kHasWord + (kFewLetters - kHasWord) * (1 - shorter);
  const auto changedCost = [](double changed, double least) {
    return changed > kMostChanged ? kUnlike : least + (kUnlike - least) * changed;
  };
  double cost = changedCost(shareChanged(wanted, known), kFewLetters);
  for (const std::string& word : wordsOf(knownPart))
    cost = std::min(cost, changedCost(shareChanged(wanted, word), kWordAlike));
  return cost;
}

// The parts of `wanted` find partners among those of `known`, in order.
double pathCost(const std::vector<std::string>& wanted, const std::vector<std::string>& known) {
  std::vector<double> row(known.size() + 1);  // costs of what of `wanted` has been dealt with
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = kPartMoreThanAsked * static_cast<double>(j);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double weight = i + 1 == wanted.size() ? kLastPartWeight : 1;
    double diagonal = std::exchange(row[0], row[0] + weight * kUnlike);
    for (std::size_t j = 0; j < known.size(); ++j) {
      const double paired = diagonal + weight * partCost(wanted[i], known[j]);
      diagonal = std::exchange(
          row[j + 1], std::min({paired, row[j + 1] + weight * kUnlike, row[j] + kPartMoreThanAsked}));
    }
  }
  return row.back();
}

double cost(const std::string& wanted, const KnownName& known) {
  const std::vector<std::string> parts = split(wanted, '.');
  std::vector<std::string> knownParts = split(known.name, '.');
  double least = pathCost(parts, knownParts) + kLetters * shareChanged(wanted, lowered(known.name));
  if (known.aliases.empty()) return least;
  for (const std::string& alias : split(lowered(known.aliases), ',')) {
    knownParts.back() = alias;
    least = std::min(least, pathCost(parts, knownParts) + kLetters * shareChanged(wanted, alias));
  }
  return least;
}

}  // namespace

std::vector<std::string> nearestNames(std::string_view wanted, std::span<const KnownName> known,
                                      std::size_t most) {
  const std::string lower = lowered(wanted);
  std::vector<std::pair<double, std::string_view>> ranked;
  for (const KnownName& name : known) {
    ranked.emplace_back(cost(lower, name), name.shownAs.empty() ? name.name : name.shownAs);
  }
  std::ranges::stable_sort(ranked, {}, [](const auto& entry) { return entry.first; });
  std::vector<std::string> names;
  for (const auto& [ignored, name] : ranked) {
    if (names.size() == most) break;
    if (std::ranges::find(names, name) == names.end()) names.emplace_back(name);
  }
  return names;
}

std::string nearestText(std::string_view wanted, std::span<const KnownName> known) {
  const std::vector<std::string> names = nearestNames(wanted, known);
  if (names.empty()) return "";
  std::string text = names.size() == 1 ? "; the nearest is " : "; the nearest are ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += "'" + names[i] + "'";
  }
  return text;
}

std::string nearestText(std::string_view wanted, std::span<const std::string_view> known) {
  std::vector<KnownName> names;
  for (const std::string_view name : known) names.push_back({name});
  return nearestText(wanted, names);
}

}  // namespace skydrop::core
