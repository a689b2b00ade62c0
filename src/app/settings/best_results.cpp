#include "app/settings/best_results.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace skydrop::app {
namespace {

using nlohmann::json;

constexpr const char* kMember = "best";
constexpr std::size_t kMostRead = 1000;  // of a file that somebody else wrote

bool isResult(const BestResult& r) {
  const auto isWithin = [](double value, double most) {
    return std::isfinite(value) && value >= 0 && value <= most;
  };
  const auto isPrintable = [](char c) { return c >= ' ' && c <= '~'; };
  return r.points >= 1 && r.points <= 100000 && isWithin(r.distanceM, 1000) && isWithin(r.seconds, 86400) &&
         !r.scene.empty() && r.scene.size() <= 64 && std::ranges::all_of(r.scene, isPrintable);
}

// What a member says, or nothing where it is not what it should be.
std::optional<BestResult> resultOf(const json& entry) {
  if (!entry.is_object()) return {};
  const auto number = [&](const char* name) -> std::optional<double> {
    const auto member = entry.find(name);
    if (member == entry.end() || !member->is_number()) return {};
    return member->get<double>();
  };
  const auto points = number("points"), distance = number("distance"), seconds = number("seconds");
  const auto scene = entry.find("scene");
  if (!points || !distance || !seconds || scene == entry.end() || !scene->is_string()) return {};
  if (!(*points >= 1 && *points <= 100000) || *points != std::floor(*points)) return {};
  BestResult result{static_cast<std::int64_t>(*points), *distance, *seconds, scene->get<std::string>()};
  if (!isResult(result)) return {};
  return result;
}

void sortAndCut(std::vector<BestResult>& best) {
  std::ranges::stable_sort(best, std::greater(), &BestResult::points);
  if (best.size() > BestResults::kKept) best.resize(BestResults::kKept);
}

}  // namespace

std::filesystem::path bestResultsFile(const std::filesystem::path& folder) {
  return folder / "deliveries.json";
}

std::vector<BestResult> readBest(const json& content, std::vector<std::string>& complaints) {
  std::vector<BestResult> best;
  const auto list = content.find(kMember);
  if (list == content.end()) return best;
  if (!list->is_array()) {
    complaints.emplace_back("best: is no list");
    return best;
  }
  for (std::size_t i = 0; i < std::min(list->size(), kMostRead); ++i) {
    if (auto result = resultOf((*list)[i]))
      best.push_back(*std::move(result));
    else
      complaints.push_back("best." + std::to_string(i) + ": is no result");
  }
  if (list->size() > kMostRead) complaints.push_back("best: more than " + std::to_string(kMostRead));
  sortAndCut(best);
  return best;
}

BestResults::BestResults(const std::filesystem::path& folder) : file_(bestResultsFile(folder)) {}

std::optional<std::string> BestResults::load() {
  if (auto broken = file_.load()) return broken;
  std::vector<std::string> complaints;
  best_ = readBest(file_.content(), complaints);
  return file_.complaintLine(complaints);
}

std::size_t BestResults::add(const BestResult& result) {
  if (!isResult(result)) return 0;
  const auto worse =
      std::ranges::find_if(best_, [&](const BestResult& b) { return b.points < result.points; });
  const auto place = static_cast<std::size_t>(worse - best_.begin());
  if (place >= kKept) return 0;
  best_.insert(worse, result);
  if (best_.size() > kKept) best_.resize(kKept);
  changed_ = true;
  return place + 1;
}

void BestResults::merge(const std::vector<BestResult>& others) {
  for (const BestResult& other : others) {
    if (std::ranges::find(best_, other) == best_.end()) best_.push_back(other);
  }
  sortAndCut(best_);
}

std::optional<std::string> BestResults::save() {
  if (!changed_) return std::nullopt;
  const auto line = file_.save([this](json& content) {
    std::vector<std::string> ignored;
    merge(readBest(content, ignored));
    json list = json::array();
    for (const BestResult& r : best_)
      list.push_back(
          {{"points", r.points}, {"distance", r.distanceM}, {"seconds", r.seconds}, {"scene", r.scene}});
    content[kMember] = std::move(list);
  });
  changed_ = false;
  return line;
}

}  // namespace skydrop::app
