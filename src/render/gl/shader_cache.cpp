#include "skydrop/render/gl/shader_cache.h"

#include <utility>

#include "skydrop/core/error.h"

namespace skydrop::render::gl {
namespace {

std::string keyOf(std::initializer_list<std::string_view> files, std::span<const std::string> defines) {
  std::string key;
  for (std::string_view file : files) key.append(file).push_back('\n');
  for (const std::string& define : defines) key.append(define).push_back('\n');
  return key;
}

}  // namespace

template <class Program, class Make>
Program& ShaderCache::madeOnce(Entry<Program>& entry, const std::string& key, Make make) {
  entry.lastUse = use_;
  if (entry.program) return *entry.program;
  if (const auto known = failed_.find(key); known != failed_.end()) throw known->second;
  if (deadline_ && std::exchange(madeUnderLimit_, true) && Clock::now() >= *deadline_) throw CompileLater();
  try {
    entry.program = make();
  } catch (const core::DataError& error) {
    failed_.insert_or_assign(key, error);
    throw;
  }
  entry.number = ++made_;
  return *entry.program;
}

Shader& ShaderCache::shader(const std::string& vertex, const std::string& fragment,
                            std::span<const std::string> defines, const std::string& geometry) {
  const std::string key = keyOf({vertex, fragment, geometry}, defines);
  return madeOnce(shaders_[key], key,
                  [&] { return std::make_unique<Shader>(*context_, vertex, fragment, geometry, defines); });
}

ComputeShader& ShaderCache::computeShader(const std::string& file, std::span<const std::string> defines) {
  const std::string key = keyOf({file}, defines);
  return madeOnce(computeShaders_[key], key,
                  [&] { return std::make_unique<ComputeShader>(*context_, file, defines); });
}

void ShaderCache::reloadIfChanged(const std::string& key, ShaderProgram& program, Reloaded& result) {
  if (!program.isStale()) return;
  try {
    program.reload();
    ++result.programs;
    stale_.erase(key);
  } catch (const core::DataError& error) {
    result.errors.emplace_back(error.what());
    stale_.insert_or_assign(key, error.what());
  }
}

ShaderCache::Reloaded ShaderCache::reloadChanged() {
  Reloaded result;
  failed_.clear();
  for (auto& [key, entry] : shaders_) {
    if (entry.program) reloadIfChanged(key, *entry.program, result);
  }
  for (auto& [key, entry] : computeShaders_) {
    if (entry.program) reloadIfChanged(key, *entry.program, result);
  }
  return result;
}

std::vector<const ShaderProgram*> ShaderCache::programs() const {
  std::vector<const ShaderProgram*> programs;
  const auto addFrom = [&programs](const auto& entries) {
    for (const auto& [key, entry] : entries)
      if (entry.program) programs.push_back(entry.program.get());
  };
  addFrom(shaders_);
  addFrom(computeShaders_);
  return programs;
}

void ShaderCache::deleteUnused() {
  const auto eraseFrom = [this](auto& entries) {
    std::erase_if(entries, [this](const auto& entry) {
      if (entry.second.lastUse == use_) return false;
      stale_.erase(entry.first);
      return true;
    });
  };
  eraseFrom(shaders_);
  eraseFrom(computeShaders_);
}

void ShaderCache::deleteMadeAfter(std::uint64_t count) {
  const auto eraseFrom = [&](auto& entries) {
    std::erase_if(entries, [&](const auto& entry) {
      if (entry.second.number <= count) return false;
      stale_.erase(entry.first);
      return true;
    });
  };
  eraseFrom(shaders_);
  eraseFrom(computeShaders_);
}

}  // namespace skydrop::render::gl
