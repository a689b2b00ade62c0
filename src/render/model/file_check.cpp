#include "render/model/file_check.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/render/model_import.h"

namespace skydrop::render {

using core::DataError;

ModelFormat modelFormat(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".obj") return ModelFormat::obj;
  if (extension == ".gltf") return ModelFormat::gltf;
  if (extension == ".glb") return ModelFormat::glb;
  throw DataError(path.string(), "", "is not a model: only .obj, .gltf and .glb are read");
}

std::filesystem::path besideModel(const std::filesystem::path& model, std::string_view reference) {
  const std::filesystem::path relative = std::filesystem::path(reference).lexically_normal();
  const bool hasScheme = reference.find(':') != std::string_view::npos;
  if (reference.empty() || hasScheme || relative.is_absolute() || *relative.begin() == "..") {
    throw DataError(model.string(), std::string(reference), "a file outside the model's folder");
  }
  return model.parent_path() / relative;
}

namespace {

class ObjChecker {
 public:
  explicit ObjChecker(std::string_view file) : file_(file) {}

  void check(std::string_view text) {
    if (text.find('\0') != std::string_view::npos) throw DataError(file_, "", "is not text");
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      checkLine(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    line_ = 0;
    if (faces_ == 0) fail("holds no face");
  }

 private:
  static constexpr std::size_t kLongestLine = 4096;
  static constexpr int kMostCorners = 64;  // of a face

  [[noreturn]] void fail(std::string_view reason) const {
    throw DataError(file_, line_ > 0 ? "line " + std::to_string(line_) : "", reason);
  }

  void checkLine(std::string_view line) {
    if (line.size() > kLongestLine) fail("is longer than 4096 characters");
    const std::vector<std::string_view> words = split(line);
    if (words.empty() || words[0].starts_with('#')) return;
    if (words.back() == "\\") fail("continued lines are not read");
    if (words[0] == "v") {
      checkNumbers(words, 3, 7);
      count(positions_);
    } else if (words[0] == "vn") {
      checkNumbers(words, 3, 3);
      count(normals_);
    } else if (words[0] == "vt") {
      checkNumbers(words, 1, 3);
      count(textures_);
    } else if (words[0] == "f") {
      checkFace(words);
    } else if (words[0] != "o" && words[0] != "g" && words[0] != "s" && words[0] != "usemtl" &&
               words[0] != "mtllib") {
      fail("'" + std::string(words[0].substr(0, 32)) + "' is not read");
    }
  }

  static std::vector<std::string_view> split(std::string_view line) {
    std::vector<std::string_view> words;
    for (std::size_t at = 0; at < line.size();) {
      at = line.find_first_not_of(" \t\r", at);
      if (at == std::string_view::npos) break;
      const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
      words.push_back(line.substr(at, end - at));
      at = end;
    }
    return words;
  }

  void count(std::size_t& elements) const {
    if (++elements > kMaxModelVertices) fail("more than " + std::to_string(kMaxModelVertices) + " elements");
  }

  void checkNumbers(const std::vector<std::string_view>& words, std::size_t least, std::size_t most) const {
    if (words.size() - 1 < least || words.size() - 1 > most) fail("has the wrong count of numbers");
    for (std::size_t i = 1; i < words.size(); ++i) {
      double value = 0;
      const char* end = words[i].data() + words[i].size();
      const auto parsed = std::from_chars(words[i].data(), end, value);
      if (parsed.ec != std::errc{} || parsed.ptr != end || !std::isfinite(value)) {
        fail("'" + std::string(words[i].substr(0, 32)) + "' is not a finite number");
      }
    }
  }

  // Corners are v, v/t, v//n or v/t/n; negative indices count from the last element so far.
  void checkFace(const std::vector<std::string_view>& words) {
    if (words.size() < 4 || words.size() > kMostCorners + 1) fail("a face needs 3 to 64 corners");
    if ((faceIndices_ += words.size() - 1) > kMaxModelIndices) fail("too many faces");
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::size_t sizes[3] = {positions_, textures_, normals_};
      std::string_view corner = words[i];
      for (int k = 0; k < 3; ++k) {
        const std::size_t slash = std::min(corner.find('/'), corner.size());
        checkIndex(corner.substr(0, slash), sizes[k], k == 1);
        if (slash == corner.size()) break;
        if (k == 2) fail("a corner has at most three indices");
        corner.remove_prefix(slash + 1);
      }
    }
    ++faces_;
  }

  void checkIndex(std::string_view word, std::size_t size, bool mayBeEmpty) const {
    if (word.empty() && mayBeEmpty) return;
    std::int64_t index = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), index);
    const bool isNumber = parsed.ec == std::errc{} && parsed.ptr == word.data() + word.size();
    const auto limit = static_cast<std::int64_t>(size);
    if (!isNumber || index == 0 || index > limit || index < -limit) {
      fail("index '" + std::string(word.substr(0, 32)) + "' is out of range");
    }
  }

  std::string file_;
  int line_ = 0;
  std::size_t positions_ = 0, normals_ = 0, textures_ = 0, faces_ = 0, faceIndices_ = 0;
};

}  // namespace

void checkObj(std::string_view file, std::string_view text) { ObjChecker(file).check(text); }

}  // namespace skydrop::render
