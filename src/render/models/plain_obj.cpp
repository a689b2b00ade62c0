#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "render/models/plain_model.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/render/models/model_import.h"

namespace skydrop::render {
namespace {

using core::DataError;
using Words = std::vector<std::string_view>;

constexpr std::size_t kLongestLine = 4096;
constexpr std::size_t kMostMaterials = 256;

// Hands out the lines of a text file as words; comments and empty lines are left out.
class LineReader {
 public:
  LineReader(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {
    if (text.find('\0') != std::string_view::npos) throw DataError(file_, "", "is not text");
  }

  bool next() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find_first_of("\n\r"), text_.size());
      const std::string_view line = text_.substr(0, end);
      // A line may end in both.
      const bool isPair = text_.substr(end, 2) == "\r\n";
      text_.remove_prefix(std::min(end + (isPair ? 2 : 1), text_.size()));
      ++line_;
      if (line.size() > kLongestLine) fail("is longer than 4096 characters");
      split(line);
      if (words_.empty() || words_[0].starts_with('#')) continue;
      if (line.ends_with('\\')) fail("continued lines are not read");
      return true;
    }
    line_ = 0;
    return false;
  }

  const Words& words() const { return words_; }
  // The words from the second on, as they stand in the line.
  std::string rest() const {
    if (words_.size() < 2) return {};
    return {words_[1].data(), words_.back().data() + words_.back().size()};
  }
  std::string place() const { return line_ > 0 ? "line " + std::to_string(line_) : ""; }
  [[noreturn]] void fail(std::string_view reason) const { throw DataError(file_, place(), reason); }

 private:
  void split(std::string_view line) {
    words_.clear();
    for (std::size_t at = 0; at < line.size();) {
      at = line.find_first_not_of(" \t\v\f", at);
      if (at == std::string_view::npos) break;
      const std::size_t end = std::min(line.find_first_of(" \t\v\f", at), line.size());
      words_.push_back(line.substr(at, end - at));
      at = end;
    }
  }

  std::string file_;
  std::string_view text_;
  int line_ = 0;
  Words words_;
};

std::string_view asText(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Faces before the first usemtl; under this name assimp keeps its plain material.
const std::string kNoMaterial = "DefaultMaterial";

std::string plainMaterial(int index) { return "m" + std::to_string(index); }

// A name that stays one word in a line of OBJ.
std::string plainName(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) <= ' ' || c == '\\' || c == '#' || c == '\x7f') c = '_';
  }
  return name.substr(0, 64);
}

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path)
      : path_(path),
        folder_(path),
        content_(core::readFile(path, kMaxModelFileBytes)),
        lines_(path.string(), asText(content_)) {}

  PlainModel read() {
    while (lines_.next()) readLine();
    if (faces_ == 0) lines_.fail("holds no face");
    if (!plain_.materialFile.empty()) text_.insert(0, std::string("mtllib ") + kPlainMaterials + "\n");
    const auto* bytes = reinterpret_cast<const std::byte*>(text_.data());
    plain_.bytes.assign(bytes, bytes + text_.size());
    return std::move(plain_);
  }

 private:
  void readLine() {
    const std::string_view kind = lines_.words()[0];
    if (kind == "v") {
      readPosition();
    } else if (kind == "vn") {
      readNormal();
    } else if (kind == "vt") {
      readTextureCoordinate();
    } else if (kind == "f") {
      readFace();
    } else if (kind == "o" || kind == "g") {
      group_ = plainName(lines_.rest());
    } else if (kind == "usemtl") {
      useMaterial();
    } else if (kind == "mtllib") {
      readMaterials();
    } else if (kind != "s") {  // smoothing groups: normals are smooth over the whole mesh
      lines_.fail("'" + std::string(kind) + "' is not read");
    }
  }

  double number(std::string_view word, double limit) const {
    const std::string_view given = word;
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    double value = 0;
    const char* end = word.data() + word.size();
    const auto parsed = std::from_chars(word.data(), end, value);
    const bool isTiny = parsed.ec == std::errc::result_out_of_range &&
                        (word.find("e-") != word.npos || word.find("E-") != word.npos);
    if (parsed.ptr != end || (parsed.ec != std::errc{} && !isTiny) || !std::isfinite(value)) {
      lines_.fail("'" + std::string(given) + "' is not a finite number");
    }
    if (std::abs(value) > limit) lines_.fail("'" + std::string(given) + "' is beyond 1e6");
    return isTiny ? 0 : value;
  }

  std::vector<double> numbers(std::size_t least, std::size_t most, double limit) const {
    const Words& words = lines_.words();
    if (words.size() - 1 < least || words.size() - 1 > most) lines_.fail("has the wrong count of numbers");
    std::vector<double> values;
    for (std::size_t i = 1; i < words.size(); ++i) {
      values.push_back(number(words[i], limit));
    }
    return values;
  }

  void write(std::string_view kind, std::initializer_list<double> values) {
    text_ += kind;
    for (const double value : values) {
      char digits[32];
      const auto end = std::to_chars(digits, digits + sizeof digits, static_cast<float>(value),
                                     std::chars_format::scientific);
      text_.append(" ").append(digits, end.ptr);
    }
    text_ += '\n';
  }

  void count(std::size_t elements) const {
    if (elements > kMaxModelVertices) {
      lines_.fail("more than " + std::to_string(kMaxModelVertices) + " elements");
    }
  }

  // x y z, and a weight or a colour that no triangle needs.
  void readPosition() {
    const std::vector<double> p = numbers(3, 6, kMaxModelCoordinate);
    if (p.size() == 5) lines_.fail("has the wrong count of numbers");
    if (p.size() == 4 && p[3] != 1) lines_.fail("a weight other than 1 is not read");
    write("v", {p[0], p[1], p[2]});
    count(++positions_);
  }

  void readNormal() {
    const std::vector<double> n = numbers(3, 3, kMaxModelCoordinate);
    write("vn", {n[0], n[1], n[2]});
    const double length = std::hypot(n[0], n[1], n[2]);
    isUnit_.push_back(length > 1 - kNormalTolerance && length < 1 + kNormalTolerance);
    count(isUnit_.size());
  }

  void readTextureCoordinate() {
    const std::vector<double> t = numbers(1, 3, kMaxModelCoordinate);
    write("vt", {t[0], t.size() > 1 ? t[1] : 0});
    count(++textures_);
  }

  // Corners are v, v/t, v//n or v/t/n, all of a face of the same kind; negative indices count from the last
  // element so far.
  void readFace() {
    const Words& words = lines_.words();
    constexpr std::size_t kMostCorners = 64;
    if (words.size() < 4 || words.size() > kMostCorners + 1) lines_.fail("a face needs 3 to 64 corners");
    corners_ += words.size() - 1;
    triangles_ += words.size() - 3;
    // assimp makes a vertex of every corner.
    if (corners_ > kMaxModelVertices || 3 * triangles_ > kMaxModelIndices)
      lines_.fail("the model is too large");
    startFace();
    text_ += 'f';
    bool hasTexture = false, hasNormal = false;
    for (std::size_t i = 1; i < words.size(); ++i) {
      const std::string_view corner = words[i];
      const std::size_t first = std::min(corner.find('/'), corner.size());
      const std::size_t second = std::min(corner.find('/', first + 1), corner.size());
      const std::string_view v = corner.substr(0, first);
      const std::string_view t =
          corner.substr(std::min(first + 1, corner.size()), second - std::min(first + 1, second));
      const std::string_view n = corner.substr(std::min(second + 1, corner.size()));
      if (i > 1 && (hasTexture != !t.empty() || hasNormal != !n.empty())) {
        lines_.fail("the corners of a face have different kinds of indices");
      }
      hasTexture = !t.empty(), hasNormal = !n.empty();
      if (corner.ends_with('/') || n.find('/') != std::string_view::npos) {
        lines_.fail("'" + std::string(corner) + "' is not v, v/t, v//n or v/t/n");
      }
      text_ += ' ' + std::to_string(index(v, positions_));
      if (hasTexture) text_ += '/' + std::to_string(index(t, textures_));
      if (hasNormal) {
        const std::size_t normal = index(n, isUnit_.size());
        if (!isUnit_[normal - 1]) lines_.fail("normal '" + std::string(n) + "' is not of length 1");
        text_ += (hasTexture ? "/" : "//") + std::to_string(normal);
      }
    }
    text_ += '\n';
    ++faces_;
  }

  // From 1 on.
  std::size_t index(std::string_view word, std::size_t size) const {
    std::int64_t value = 0;
    const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool isNumber = parsed.ec == std::errc{} && parsed.ptr == word.data() + word.size();
    const auto limit = static_cast<std::int64_t>(size);
    if (!isNumber || value == 0 || value > limit || value < -limit) {
      lines_.fail("index '" + std::string(word) + "' is out of range");
    }
    return static_cast<std::size_t>(value > 0 ? value : limit + value + 1);
  }

  // Groups and materials are written where a face needs them, so that none stays empty.
  void startFace() {
    const bool isNewGroup = group_ != writtenGroup_;
    if (isNewGroup && ++groups_ >= kMaxModelNodes) lines_.fail("too many groups");
    if (isNewGroup) text_ += "g " + group_ + "\n";
    const bool isNewMaterial = material_ != writtenMaterial_;
    if (isNewMaterial) text_ += "usemtl " + (material_ < 0 ? kNoMaterial : plainMaterial(material_)) + "\n";
    if ((isNewGroup || isNewMaterial) && ++meshes_ > kMaxModelMeshes)
      lines_.fail("too many changes of material");
    writtenGroup_ = group_;
    writtenMaterial_ = material_;
  }

  // Without any material file all materials are plain ones.
  void useMaterial() {
    const std::string name = lines_.rest();
    const auto known = materials_.find(name);
    if (known == materials_.end() && hasMaterialFile_) lines_.fail("material '" + name + "' is not defined");
    material_ = known != materials_.end() ? known->second : addMaterial(name);
    if (known == materials_.end()) undefined_.insert(material_);
  }

  int addMaterial(const std::string& name) {
    const int index = static_cast<int>(plain_.materialNames.size());
    if (plain_.materialNames.size() == kMostMaterials) lines_.fail("too many materials");
    materials_[name] = index;
    plain_.materialNames.push_back(name);
    plain_.materialFile += "newmtl " + plainMaterial(index) + "\n";
    return index;
  }

  void define(const LineReader& file) {
    const auto known = materials_.find(file.rest());
    if (known == materials_.end()) {
      addMaterial(file.rest());
    } else if (undefined_.erase(known->second) > 0) {
      plain_.materialFile += "newmtl " + plainMaterial(known->second) + "\n";
    } else {
      file.fail("material '" + file.rest() + "' is defined twice");
    }
  }

  // Of a material file names and textures are read; what else describes a surface, the game does not draw.
  void readMaterials() {
    const std::string reference = lines_.rest();
    if (reference.empty()) lines_.fail("names no material file");
    hasMaterialFile_ = true;
    const std::vector<std::byte> content = folder_.read(lines_.place(), reference);
    LineReader file((path_.parent_path() / reference).string(), asText(content));
    bool isInMaterial = false, hasDiffuse = false, hasSpecular = false;
    while (file.next()) {
      const std::string_view kind = file.words()[0];
      if (kind == "newmtl") {
        define(file);
        isInMaterial = true, hasDiffuse = hasSpecular = false;
      } else if (kind == "map_Kd" || kind == "map_Ks") {
        bool& has = kind == "map_Kd" ? hasDiffuse : hasSpecular;
        if (!isInMaterial) file.fail("a texture before the first material");
        if (has) file.fail("a second texture of the same kind");
        if (file.rest().starts_with('-')) file.fail("options of a texture are not read");
        has = true;
        const std::string place = reference + ", " + file.place();
        plain_.materialFile +=
            std::string(kind) + " " + std::to_string(folder_.texture(plain_, place, file.rest())) + "\n";
      }
    }
  }

  std::filesystem::path path_;
  ModelFolder folder_;
  std::vector<std::byte> content_;
  LineReader lines_;
  std::string text_;
  PlainModel plain_;
  std::size_t positions_ = 0, textures_ = 0, faces_ = 0, corners_ = 0, triangles_ = 0;
  std::vector<bool> isUnit_;  // of each normal
  std::string group_ = "defaultobject", writtenGroup_;
  std::size_t groups_ = 0, meshes_ = 0;
  int material_ = -1, writtenMaterial_ = -2;  // -1: none is named yet
  std::map<std::string, int> materials_;
  std::set<int> undefined_;  // used before they are defined
  bool hasMaterialFile_ = false;
};

}  // namespace

PlainModel readPlainObj(const std::filesystem::path& path) { return ObjReader(path).read(); }

}  // namespace skydrop::render
