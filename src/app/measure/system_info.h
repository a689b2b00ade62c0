#pragma once

#include <string>

namespace skydrop::app {

// The processor's name and its number of threads, for reports: "AMD EPYC, 2 threads".
std::string machineName();

// Since the program was started: since exec where the system tells (Linux, to 10 ms), else since its first
// use.
double secondsSinceStart();

}  // namespace skydrop::app
