#pragma once

#include <string>

namespace skydrop::app {

// The processor's name and its number of threads, for reports: "AMD EPYC, 2 threads".
std::string machineName();

}  // namespace skydrop::app
