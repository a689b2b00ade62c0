#include "skydrop/render/gl/shader_cache.h"

#include "skydrop/core/error.h"

namespace skydrop::render::gl {
namespace {

std::string keyOf(std::initializer_list<std::string_view> files, std::span<const std::string> defines) {
  std::string key;
  for (std::string_view file : files) key.append(file).push_back('\n');
  for (const std::string& define : defines) key.append(define).push_back('\n');
  return key;
}

void reloadIfStale(ShaderProgram& program, ShaderCache::Reloaded& result) {
  if (!program.isStale()) return;
  try {
    program.reload();
    ++result.programs;
  } catch (const core::DataError& error) {
    result.errors.emplace_back(error.what());
  }
}

}  // namespace

Shader& ShaderCache::shader(const std::string& vertex, const std::string& fragment,
                            std::span<const std::string> defines, const std::string& geometry) {
  std::unique_ptr<Shader>& slot = shaders_[keyOf({vertex, fragment, geometry}, defines)];
  if (!slot) slot = std::make_unique<Shader>(*context_, vertex, fragment, geometry, defines);
  return *slot;
}

ComputeShader& ShaderCache::computeShader(const std::string& file, std::span<const std::string> defines) {
  std::unique_ptr<ComputeShader>& slot = computeShaders_[keyOf({file}, defines)];
  if (!slot) slot = std::make_unique<ComputeShader>(*context_, file, defines);
  return *slot;
}

ShaderCache::Reloaded ShaderCache::reloadChanged() {
  Reloaded result;
  for (auto& [key, shader] : shaders_) {
    if (shader) reloadIfStale(*shader, result);
  }
  for (auto& [key, shader] : computeShaders_) {
    if (shader) reloadIfStale(*shader, result);
  }
  return result;
}

}  // namespace skydrop::render::gl
