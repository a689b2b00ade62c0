#include "skydrop/core/json.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/core/file.h"

namespace skydrop::core {
namespace {

using nlohmann::json;
using Handler = nlohmann::json_sax<json>;

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

// Walks a text and leaves behind how far the parser has read.
class ReadingPlace {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  ReadingPlace(const char* at, const char** read) : at_(at), read_(read) {}

  reference operator*() const { return *at_; }
  ReadingPlace& operator++() {
    *read_ = ++at_;
    return *this;
  }
  ReadingPlace operator++(int) { return std::exchange(*this, std::next(*this)); }
  bool operator==(const ReadingPlace& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  const char** read_;
};

// "line 3, column 14": of the last of the first `length` bytes.
std::string placeIn(std::string_view text, std::size_t length) {
  const std::string_view before = text.substr(0, length > 0 ? length - 1 : 0);
  const auto line = std::ranges::count(before, '\n') + 1;
  const std::size_t lineStart = before.rfind('\n') + 1;  // 0 on the first line
  return "line " + std::to_string(line) + ", column " + std::to_string(before.size() - lineStart + 1);
}

// The parser's words without its own names and place: "[json.exception.parse_error.101] parse error at line
// 1, column 2: syntax error while parsing ...".
std::string_view reasonOf(std::string_view what) {
  const std::size_t head = what.find("] ");
  if (head != std::string_view::npos) what.remove_prefix(head + 2);
  if (what.starts_with("parse error at")) what.remove_prefix(std::min(what.find(": ") + 2, what.size()));
  return what;
}

// Stands between the parser and a handler, and holds the text to the limits and rules.
class Guard final : public Handler {
 public:
  Guard(std::string_view text, std::string_view file, const JsonLimits& limits, Handler& handler)
      : text_(text), file_(file), limits_(limits), handler_(handler), read_(text.data()) {}

  void scan() {
    json::sax_parse(ReadingPlace(text_.data(), &read_), ReadingPlace(text_.data() + text_.size(), &read_),
                    this);
  }

  bool null() override { return count() && handler_.null(); }
  bool boolean(bool value) override { return count() && handler_.boolean(value); }
  bool number_integer(number_integer_t value) override { return count() && handler_.number_integer(value); }
  bool number_unsigned(number_unsigned_t value) override {
    return count() && handler_.number_unsigned(value);
  }
  bool number_float(number_float_t value, const string_t& text) override {
    return count() && handler_.number_float(value, text);
  }
  bool string(string_t& value) override { return count() && handler_.string(value); }
  bool binary(binary_t& value) override { return count() && handler_.binary(value); }

  bool start_object(std::size_t size) override {
    enter();
    names_.emplace_back();
    return handler_.start_object(size);
  }
  bool key(string_t& name) override {
    if (!names_.back().insert(name).second) fail("'" + name + "' is defined twice");
    return count() && handler_.key(name);
  }
  bool end_object() override {
    --depth_;
    names_.pop_back();
    return handler_.end_object();
  }
  bool start_array(std::size_t size) override {
    enter();
    return handler_.start_array(size);
  }
  bool end_array() override {
    --depth_;
    return handler_.end_array();
  }

  bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
    fail(reasonOf(error.what()));
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    throw DataError(file_, placeIn(text_, static_cast<std::size_t>(read_ - text_.data())), reason);
  }

  bool count() {
    if (++values_ > limits_.values) fail("more than " + std::to_string(limits_.values) + " values");
    return true;
  }

  void enter() {
    count();
    if (++depth_ > limits_.depth) fail("nested deeper than " + std::to_string(limits_.depth) + " levels");
  }

  std::string_view text_, file_;
  const JsonLimits& limits_;
  Handler& handler_;
  const char* read_;
  int depth_ = 0;
  std::size_t values_ = 0;
  std::vector<std::set<std::string>> names_;  // of the objects that are open
};

// Makes a tree of the parts.
class TreeBuilder final : public Handler {
 public:
  json take() { return std::move(root_); }

  bool null() override { return add(nullptr); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override { return add(value); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // not in JSON text
  bool start_object(std::size_t) override { return open(json::object()); }
  bool start_array(std::size_t) override { return open(json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& name) override {
    name_ = std::move(name);
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

 private:
  bool add(json value) {
    place(std::move(value));
    return true;
  }
  bool open(json value) {
    open_.push_back(place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }
  // A parent takes no further child while one of its children is open: the pointers stay good.
  json* place(json value) {
    if (open_.empty()) return &(root_ = std::move(value));
    json& parent = *open_.back();
    if (parent.is_array()) return &parent.emplace_back(std::move(value));
    return &(parent[name_] = std::move(value));
  }

  json root_;
  std::vector<json*> open_;
  std::string name_;
};

std::string shown(const json& value) { return value.dump(); }

}  // namespace

void scanJson(std::string_view text, std::string_view file, Handler& handler, const JsonLimits& limits) {
  if (text.size() > limits.bytes)
    throw DataError(file, "size", "more than " + std::to_string(limits.bytes) + " bytes");
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
    throw DataError(file, placeIn(text, 1), "is UTF-16; only UTF-8 is read");
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw DataError(file, placeIn(text, text.size()), "is empty");
  // The parser takes a zero byte for the end of the text.
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    throw DataError(file, placeIn(text, zero + 1), "a zero byte");
  Guard(text, file, limits, handler).scan();
}

json parseJson(std::string_view text, std::string_view file, const JsonLimits& limits) {
  TreeBuilder builder;
  scanJson(text, file, builder, limits);
  return builder.take();
}

json readJson(const std::filesystem::path& file, const JsonLimits& limits) {
  return parseJson(readTextFile(file, limits.bytes), file.string(), limits);
}

double jsonNumber(const json& value, std::string_view file, std::string_view place, double least,
                  double most) {
  if (!value.is_number()) throw DataError(file, place, shown(value) + " is not a number");
  const double number = value.get<double>();
  if (!std::isfinite(number) || number < least || number > most) {
    throw DataError(file, place,
                    shown(value) + " is out of range " + shown(json(least)) + " to " + shown(json(most)));
  }
  return number;
}

double jsonWhole(const json& value, std::string_view file, std::string_view place, double least,
                 double most) {
  const double number = jsonNumber(value, file, place, least, most);
  if (number != std::floor(number)) throw DataError(file, place, shown(value) + " is not a whole number");
  return number;
}

std::string jsonText(const json& value, std::string_view file, std::string_view place) {
  if (!value.is_string()) throw DataError(file, place, "is not a text");
  return value.get<std::string>();
}

}  // namespace skydrop::core
