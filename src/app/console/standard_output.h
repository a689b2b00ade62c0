// The program's results on standard output: whole lines, written as they come, also into a pipe or a file.
// Every print() of the program is here, so that a full disk or a closed pipe is noticed at the line that it
// swallows. Main thread.
#pragma once

#include <filesystem>
#include <optional>

#include "skydrop/core/output_file.h"

namespace skydrop::app {

// At the start of the program: a standard stream that is closed must not become the first file that is
// opened, and a closed pipe is an error to report, not a signal.
void prepareStandardStreams();

// As printf. Throws core::ClosedPipe, or core::DataError where the line cannot be written.
#if defined(__GNUC__)
[[gnu::format(printf, 1, 2)]]
#endif
void print(const char* format, ...);

// At the end of the program: what some file systems say only when a file is closed. Throws core::DataError.
void finishStandardOutput();

// Opens an output that the command line names (core/output_file.h), before the work. Where it is standard
// output, that belongs to it alone from now on: print() goes to standard error. Throws core::DataError.
std::optional<core::OutputFile> openOutput(const std::optional<std::filesystem::path>& path);

}  // namespace skydrop::app
