// What the readers of both schemas of an input log share. They read in one pass, by events, and keep nothing
// but the log itself: a hostile file cannot make them grow beyond its own size.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "skydrop/core/json.h"
#include "skydrop/game/input_log.h"

namespace skydrop::game {

inline constexpr std::string_view kLogKind = "skydrop input log";

// Refuses every value; a reader takes those that belong. Throws core::DataError.
class LogEvents : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool null() override { wrong("null"); }
  bool boolean(bool) override { wrong("true or false"); }
  bool number_float(double, const std::string&) override { wrong("a number that is not whole"); }
  bool binary(binary_t&) override { wrong("binary data"); }
  bool number_integer(std::int64_t value) override {
    return integer(value < 0, static_cast<std::uint64_t>(value));
  }
  bool number_unsigned(std::uint64_t value) override { return integer(false, value); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;  // core::scanJson() says it
  }

 protected:
  explicit LogEvents(std::string_view file) : file_(file) {}

  // `value` is the bits of a negative one.
  virtual bool integer(bool negative, std::uint64_t value) = 0;
  // Where the reader is.
  virtual std::string place() const = 0;

  [[noreturn]] void fail(std::string_view where, std::string_view reason) const;
  [[noreturn]] void wrong(std::string_view what) const;
  void requireText(const std::string& value, std::size_t most = InputLog::kMaxText) const;

 private:
  std::string_view file_;
};

// The seven numbers of a row as a run. `stepsBefore`: of the rows before it.
InputLog::Run makeRun(const std::array<std::int64_t, 7>& row, std::uint64_t stepsBefore,
                      std::string_view file, const std::string& place);

// 1 to 16 hexadecimal digits.
std::optional<std::uint64_t> parseHash(std::string_view text);

InputLog decodeSchema1(std::string_view text, std::string_view file);
InputLog decodeSchema2(std::string_view text, std::string_view file);

}  // namespace skydrop::game
