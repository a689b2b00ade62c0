// Work that may crash, hang or eat memory, because it runs in a library on data of others: done by a child
// process with limits on time and memory, which hands its result back as bytes. What becomes of the child is
// one line here.
//
// The child is a program of ours that is started anew (posix_spawn and not fork alone: the parent has
// threads). It finds its limits in its arguments' company: it calls limitThisProcess() before anything else,
// writes its result with writeContainedResult() and ends with 0. POSIX; on Windows there is none
// (isContainmentPossible()).
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::core {

struct ContainedLimits {
  double wallSeconds = 60;  // after which the child is killed
  int cpuSeconds = 20;      // of the child
  // Of the child's address space. Not held under a sanitizer, whose shadow takes terabytes of it.
  std::size_t memoryBytes = std::size_t{3} << 30;
};

// More than any result of ours; a child that hands over more is refused.
inline constexpr std::size_t kMostContainedBytes = std::size_t{1} << 30;

bool isContainmentPossible();

// The file of the running program as the system has it, whatever its name and folder: it may have been
// renamed, replaced or removed since it was started. Empty where the system does not tell.
std::filesystem::path runningProgram();

// Runs the program with these words (words[0] is its name for itself) and returns what it handed over. Its
// standard streams lead nowhere. Throws DataError that names `file` where it cannot be started, is ended by a
// signal or a limit, ends with another code than 0, or hands over nothing, too much, or half of it. Any
// thread; waits.
std::string runContained(const std::filesystem::path& program, const std::vector<std::string>& words,
                         const ContainedLimits& limits, std::string_view file);

// The child's side. The process ends with its parent.
void limitThisProcess(const ContainedLimits& limits);
void writeContainedResult(std::string_view result);  // throws DataError

}  // namespace skydrop::core
