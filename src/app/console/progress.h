// How far long work has come, on standard error: one line that is written over on a terminal, a line a second
// where it is asked for and there is none. Main thread.
#pragma once

#include <cstdio>
#include <functional>
#include <string>

namespace skydrop::app {

class Progress {
 public:
  enum class Style { none, overwritten, lines };
  using Clock = std::function<double()>;  // seconds

  // `verb` opens every line.
  Progress(std::string verb, Style style, std::FILE* to, Clock clock);
  // On standard error: overwritten on a terminal, else lines if `asked`.
  Progress(std::string verb, bool asked);
  // Takes the line off the terminal.
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Whether it is time for a new line: the first one at once.
  bool isDue() const;
  // Shows it whether or not it is time. "120 of 600 s"
  void show(const std::string& state);
  // Before something else is written to the terminal.
  void clear();

 private:
  std::string verb_;
  Style style_;
  std::FILE* to_;
  Clock clock_;
  double nextS_ = 0;
  bool shown_ = false;
};

}  // namespace skydrop::app
