// A shader's text as the compiler gets it: `#version 450 core`, the variant's defines, then the entry file
// with every `#include "file"` replaced by that file, each file once.
//
// Names are relative to the folder shaders/, or to the including file where no such file exists there;
// absolute names stand for themselves (tests). An include counts as done even inside an #if that is not
// taken, so includes stand outside of conditions. A map from each line to its file and line replaces #line:
// compilers report their line number right, but Mesa names a wrong file for the first error after a #line.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::render::gl {

class ShaderSource {
 public:
  ShaderSource() = default;
  // Defines are "NAME" (which becomes 1) or "NAME VALUE". Throws core::DataError for a file that cannot be
  // read or an include that is not found, naming the file and line that ask for it.
  ShaderSource(std::string_view entry, std::span<const std::string> defines);

  const std::string& name() const { return names_.front(); }  // the entry file, as it was asked for
  const std::string& text() const { return text_; }

  // The files it was read from, each with the time it had been written at just before it was read.
  struct File {
    std::filesystem::path path;
    std::filesystem::file_time_type written;
  };
  const std::vector<File>& files() const { return files_; }

  struct Place {
    std::string file;
    int line = 0;  // from 1
  };
  // Where a line of text() (from 1) came from; lines that no file has written belong to the entry's line 1.
  Place place(int line) const;

  struct Message {
    Place place;
    std::string text;
  };
  // The first error of a compiler's log, in the words of Mesa, NVIDIA, AMD or Intel.
  Message firstError(std::string_view log) const;

 private:
  struct Line {
    int file = 0;
    int number = 1;
  };
  void append(const std::filesystem::path& path, const std::string& name);
  void appendLine(std::string_view line, Line origin);

  std::string text_;
  std::vector<Line> lines_;
  std::vector<std::string> names_;
  std::vector<File> files_;
};

}  // namespace skydrop::render::gl
