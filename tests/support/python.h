#pragma once

#include <string>

#include "support/process.h"

namespace skydrop::test {

// A Python that has numpy; empty if there is none.
inline std::string pythonWithNumpy() {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (runProcess({python, "-c", "import numpy"}).exitCode == 0) return python;
  }
  return {};
}

}  // namespace skydrop::test
