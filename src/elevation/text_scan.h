// Numbers and lines of a text that is too large to be copied.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace skydrop::elevation {

// Reads a text from its beginning; knows the line for messages, counted from 1.
class TextScan {
 public:
  explicit TextScan(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {
    if (text.starts_with("\xef\xbb\xbf")) at_ += 3;
  }

  // Past blanks, and past line ends where `lines` says so; also past commas, tabs and semicolons.
  void skip(bool lines) {
    for (; at_ != end_; ++at_) {
      if (*at_ == '\n') {
        if (!lines) return;
        ++line_;
      } else if (*at_ != ' ' && *at_ != '\t' && *at_ != '\r' && *at_ != ',' && *at_ != ';') {
        return;
      }
    }
  }

  bool atEnd() const { return at_ == end_; }
  bool atLineEnd() const { return at_ == end_ || *at_ == '\n'; }
  const char* peek() const { return at_; }  // not at the end
  std::size_t line() const { return line_; }

  // The number that stands here (after skip), or nothing, and then it stays. NaN and infinities are numbers.
  std::optional<double> number() {
    double value = 0;
    const char* from = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    const auto [past, error] = std::from_chars(from, end_, value);
    const bool isWhole = past == end_ || *past == ' ' || *past == '\t' || *past == '\r' || *past == '\n' ||
                         *past == ',' || *past == ';';
    if (error == std::errc::invalid_argument || !isWhole) return std::nullopt;
    at_ = past;
    return error == std::errc() ? value : 0.0;  // beyond a double: it is no height, and must not end the line
  }

  // The word that stands here, which ends at a blank or at the line's end.
  std::string_view word() {
    const char* from = at_;
    while (at_ != end_ && *at_ != ' ' && *at_ != '\t' && *at_ != '\r' && *at_ != '\n') ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }

  void skipLine() {
    while (at_ != end_ && *at_ != '\n') ++at_;
  }

 private:
  const char* at_;
  const char* end_;
  std::size_t line_ = 1;
};

}  // namespace skydrop::elevation
