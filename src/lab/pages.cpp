#include <algorithm>
#include <cstdio>
#include <iterator>

#include "lab/chapters.h"
#include "skydrop/core/error.h"
#include "skydrop/core/nearest_names.h"

namespace skydrop::lab {
namespace {

std::vector<Page> allPages() {
  std::vector<Page> all;
  for (auto* chapter : {marchPages, distancePages, noisePages, cloudPages}) {
    std::vector<Page> some = chapter();
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

}  // namespace

std::span<const Page> pages() {
  static const std::vector<Page> all = allPages();
  return all;
}

const Page& pageNamed(std::string_view name) {
  const auto all = pages();
  const auto found = std::ranges::find(all, name, &Page::name);
  if (found != all.end()) return *found;
  std::vector<std::string_view> names;
  for (const Page& page : all) names.push_back(page.name);
  throw core::RangeError("unknown page '" + std::string(name) + "'" + core::nearestText(name, names));
}

std::string figuresText(const Figures& figures, bool asMarkdown) {
  std::vector<std::vector<std::string>> cells = {figures.columns};
  for (std::size_t r = 0; r < figures.rows.size(); ++r) {
    std::vector<std::string>& line = cells.emplace_back();
    if (!figures.labels.empty()) line.push_back(figures.labels[r]);
    for (const double value : figures.rows[r]) line.push_back(numberText(value));
  }
  std::vector<std::size_t> widths(figures.columns.size(), 0);
  for (const auto& row : cells) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (std::size_t r = 0; r < cells.size(); ++r) {
    std::string line;
    for (std::size_t i = 0; i < cells[r].size(); ++i) {
      if (asMarkdown)
        line += "| " + cells[r][i] + " ";
      else
        line += std::string(widths[i] - cells[r][i].size() + (i ? 2 : 0), ' ') + cells[r][i];
    }
    text += line + (asMarkdown ? "|\n" : "\n");
    if (r == 0 && asMarkdown) {
      for (std::size_t i = 0; i < widths.size(); ++i) text += "|---";
      text += "|\n";
    }
  }
  return text;
}

}  // namespace skydrop::lab
