// Which rows of the menu a search shows. Pure text, no Dear ImGui.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/settings_table.h"

namespace skydrop::ui {

class RowFilter {
 public:
  // Every word must occur in the row's label, path, section title or tooltip (other names stand there, its
  // note does not count); capitals of A to Z do not count. No word: all rows. `changedOnly`: of those, the
  // ones that are not at their default.
  RowFilter(std::string_view search, bool changedOnly);

  bool matches(const core::Field& field, std::string_view sectionTitle) const;
  bool isActive() const { return changedOnly_ || !words_.empty(); }

 private:
  std::vector<std::string> words_;
  bool changedOnly_;
};

}  // namespace skydrop::ui
