// What the GPU holds and what a frame asked of it. "Only the effects that a scene calls for" is proved here:
// no effect, no object, no byte, no draw.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::render::gl {

enum class ObjectKind { buffer, texture, vertexArray, program, frameBuffer, sampler, query };
inline constexpr int kObjectKindCount = 7;

struct PassCounts {
  std::uint64_t draws = 0;
  std::uint64_t dispatches = 0;
  bool operator==(const PassCounts&) const = default;
};

// What the objects of one owner hold.
struct OwnedResources {
  std::int64_t objects = 0;
  std::uint64_t bytes = 0;
  bool operator==(const OwnedResources&) const = default;
};

// One per context, on the context's thread. Bytes are what the formats ask for: what a driver adds is not
// seen.
class GpuResourceTracker {
 public:
  // Of an object: who it is counted for, however long it lives. 0 is nobody.
  using Owner = std::size_t;

  // Who pays for objects that are made from now on, until another is named; "" is nobody.
  void setOwner(std::string_view name);
  // What is alive of this owner.
  OwnedResources ownedBy(std::string_view name) const;

  Owner created(ObjectKind kind) {
    ++live_[index(kind)];
    ++owners_[owner_].held.objects;
    return owner_;
  }
  void deleted(ObjectKind kind, std::uint64_t bytes, Owner owner) {
    --live_[index(kind)];
    bytes_ -= bytes;
    --owners_[owner].held.objects;
    owners_[owner].held.bytes -= bytes;
  }
  void allocated(std::uint64_t bytes, Owner owner) {
    bytes_ += bytes;
    owners_[owner].held.bytes += bytes;
  }

  std::int64_t live(ObjectKind kind) const { return live_[index(kind)]; }
  std::int64_t liveObjects() const;
  std::uint64_t bytes() const { return bytes_; }

  // Draws and dispatches until endPass() belong to the named pass; outside of any they belong to "".
  void beginPass(std::string_view name) { pass_ = name; }
  void endPass() { pass_.clear(); }
  void drew() { ++counts_[pass_].draws; }
  void dispatched() { ++counts_[pass_].dispatches; }
  const std::map<std::string, PassCounts>& passes() const { return counts_; }
  PassCounts total() const;
  void clearPasses() { counts_.clear(); }

  // A uniform that was set under a name that occurs nowhere in the program's source: a typing error, because
  // a name that a variant compiles out is still in the text. Tests demand zero.
  void unknownUniform(std::string_view program, std::string_view uniform);
  std::uint64_t unknownUniforms() const { return unknownUniforms_; }
  const std::string& lastUnknownUniform() const { return lastUnknownUniform_; }

 private:
  struct OwnerEntry {
    std::string name;
    OwnedResources held;
  };

  static std::size_t index(ObjectKind kind) { return static_cast<std::size_t>(kind); }

  std::array<std::int64_t, kObjectKindCount> live_{};
  std::uint64_t bytes_ = 0;
  std::vector<OwnerEntry> owners_{1};  // the first is nobody; as many as there are names
  Owner owner_ = 0;
  std::string pass_;
  std::map<std::string, PassCounts> counts_;
  std::uint64_t unknownUniforms_ = 0;
  std::string lastUnknownUniform_;
};

}  // namespace skydrop::render::gl
