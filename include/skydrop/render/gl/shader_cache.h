// Every program of a renderer, compiled once for each set of entry points and defines, and compiled again
// when a file changes.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/core/error.h"
#include "skydrop/render/gl/shader.h"

namespace skydrop::render::gl {

class ShaderCache {
 public:
  explicit ShaderCache(Context& context) : context_(&context) {}

  // The program of these files and defines; compiled at the first call. The reference stays valid as long as
  // the cache, or until deleteUnused() finds it unused. Throws core::DataError as Shader does: what failed is
  // not tried again before reloadChanged().
  Shader& shader(const std::string& vertex, const std::string& fragment,
                 std::span<const std::string> defines = {}, const std::string& geometry = {});
  ComputeShader& computeShader(const std::string& file, std::span<const std::string> defines = {});

  struct Reloaded {
    int programs = 0;                 // recompiled
    std::vector<std::string> errors;  // one line each; those programs stay as they were
  };
  // Looks at the files' times. A file that fails is not tried again until it is written again.
  Reloaded reloadChanged();

  // One of the lines about programs that run as they were, because their files do not compile since; empty:
  // none.
  std::string_view standingError() const {
    return stale_.empty() ? std::string_view() : std::string_view(stale_.begin()->second);
  }

  // Every program that there is, until the next call that may compile or delete one.
  std::vector<const ShaderProgram*> programs() const;
  std::size_t size() const { return shaders_.size() + computeShaders_.size(); }

  // Thrown by shader() and computeShader() in place of compiling a program beyond the limit: whoever set it
  // asks again in a later frame.
  struct CompileLater {};
  using Clock = std::chrono::steady_clock;
  // From now on one program is compiled, whatever the time, and further ones until the deadline; nullopt: no
  // limit.
  void limitCompiling(std::optional<Clock::time_point> deadline) {
    deadline_ = deadline;
    madeUnderLimit_ = false;
  }

  // Deletes every program that was not asked for since beginUse() was called last (or ever, if it was not);
  // references to those become invalid.
  void beginUse() { ++use_; }
  void deleteUnused();

  // Programs made so far, and the way back to that: deletes those that were made after the first `count`.
  // References to those become invalid; who asks for one again has it compiled again.
  std::uint64_t madeSoFar() const { return made_; }
  void deleteMadeAfter(std::uint64_t count);

 private:
  template <class Program>
  struct Entry {
    std::unique_ptr<Program> program;
    std::uint64_t lastUse = 0;
    std::uint64_t number = 0;  // of the programs that were made, from 1 on; 0: not made
  };

  // The program of the entry, made there by `make` the first time.
  template <class Program, class Make>
  Program& madeOnce(Entry<Program>& entry, const std::string& key, Make make);
  void reloadIfChanged(const std::string& key, ShaderProgram& program, Reloaded& result);

  Context* context_;
  std::map<std::string, Entry<Shader>> shaders_;
  std::map<std::string, Entry<ComputeShader>> computeShaders_;
  std::uint64_t use_ = 0, made_ = 0;
  std::optional<Clock::time_point> deadline_;      // nullopt: as many as are asked for
  bool madeUnderLimit_ = false;                    // one or more, since the limit was set
  std::map<std::string, core::DataError> failed_;  // never compiled
  std::map<std::string, std::string> stale_;       // compiled once, not since: the line that says why
};

}  // namespace skydrop::render::gl
