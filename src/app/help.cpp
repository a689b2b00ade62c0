#include "app/help.h"

namespace skydrop::app {

std::vector<ui::HelpRow> helpRows() {
  return {};
}

}  // namespace skydrop::app
