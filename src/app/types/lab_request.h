// What `skydrop lab` was asked for.
#pragma once

#include <optional>
#include <string>

namespace skydrop::app {

struct LabRequest {
  bool list = false;                // print the pages
  bool all = false;                 // a picture of each, to the folder `out`
  std::optional<std::string> page;  // by name; of the window the first that is shown
  std::optional<std::string> out;   // FILE.png or -, of --all a folder; unset: the window
};

}  // namespace skydrop::app
