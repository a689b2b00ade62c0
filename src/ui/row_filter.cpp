#include "ui/row_filter.h"

#include <algorithm>

#include "ui/field_label.h"

namespace skydrop::ui {
namespace {

std::string lowered(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

}  // namespace

RowFilter::RowFilter(std::string_view search, bool changedOnly) : changedOnly_(changedOnly) {
  std::string word;
  for (const char c : lowered(std::string(search)) + " ") {
    if (c != ' ' && c != '\t') {
      word += c;
    } else if (!word.empty()) {
      words_.push_back(word);
      word.clear();
    }
  }
}

bool RowFilter::matches(const core::Field& field, std::string_view sectionTitle) const {
  if (changedOnly_ && field.isDefault()) return false;
  if (words_.empty()) return true;
  const std::string text = lowered(humanName(field.name) + "\n" + std::string(sectionTitle) + "\n" +
                                   humanName(field.group) + "\n" + searchText(field));
  return std::ranges::all_of(words_,
                             [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

}  // namespace skydrop::ui
