// Programs from shader files. `Shader` draws (vertex, fragment, optional geometry stage), `ComputeShader`
// dispatches; both have one interface for uniforms.
//
// Errors: a file that cannot be read, or does not compile or link, throws core::DataError that names file,
// line and the compiler's reason. Uniforms: a name that the compiler optimised away, or that this variant
// leaves out, is legal and ignored; a name that occurs nowhere in the source is counted by the resource
// tracker as unknown. Values are lost when reload() succeeds: passes set them each frame, and texture units
// are fixed by layout(binding).
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/fwd.hpp>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/render/gl/object.h"
#include "skydrop/render/gl/shader_source.h"

namespace skydrop::render::gl {

struct ShaderStage {
  GLenum type = 0;  // GL_VERTEX_SHADER ...
  ShaderSource source;
};

// A linked program without anything around it.
class Program : public Object {
 public:
  Program() = default;
  Program(Context& context, std::span<const ShaderStage> stages, std::string_view label);
};

class ShaderProgram {
 public:
  GLuint id() const { return program_.id(); }
  explicit operator bool() const { return static_cast<bool>(program_); }
  const std::string& name() const { return name_; }

  void use() const;

  void setBool(std::string_view name, bool value);
  void setInt(std::string_view name, int value);
  void setUint(std::string_view name, unsigned value);
  void setFloat(std::string_view name, float value);
  void setVec2(std::string_view name, const glm::vec2& value);
  void setVec3(std::string_view name, const glm::vec3& value);
  void setVec4(std::string_view name, const glm::vec4& value);
  void setIvec2(std::string_view name, const glm::ivec2& value);
  void setIvec3(std::string_view name, const glm::ivec3& value);
  void setMatrix(std::string_view name, const glm::mat3& value);
  void setMatrix(std::string_view name, const glm::mat4& value);
  void setFloats(std::string_view name, std::span<const float> values);     // float name[]
  void setVec4s(std::string_view name, std::span<const glm::vec4> values);  // vec4 name[]

  // Recompiles from the files. If that fails the program stays as it was and the error is thrown.
  void reload();
  // Whether a file of this program was written since it was last compiled (or tried).
  bool isStale() const;

  // What it is compiled from.
  struct File {
    GLenum type = 0;   // of the stage
    std::string name;  // the entry file
  };
  std::span<const File> files() const { return files_; }
  std::span<const std::string> defines() const { return defines_; }

 protected:
  ShaderProgram() = default;
  ShaderProgram(Context& context, std::vector<File> files, std::span<const std::string> defines);

  Context& context() const { return program_.context(); }

 private:
  void build(Context& context);
  GLint location(std::string_view name);

  std::vector<File> files_;
  std::vector<std::string> defines_;
  std::string name_;  // "fullscreen.vert + sky/sky.frag"
  Program program_;
  std::string text_;  // of all stages: which names exist
  std::map<std::string, GLint, std::less<>> locations_;
  std::vector<ShaderSource::File> watched_;
};

class Shader : public ShaderProgram {
 public:
  Shader() = default;
  Shader(Context& context, std::string vertex, std::string fragment, std::string geometry = {},
         std::span<const std::string> defines = {});
};

class ComputeShader : public ShaderProgram {
 public:
  ComputeShader() = default;
  ComputeShader(Context& context, std::string file, std::span<const std::string> defines = {});

  // use() and a dispatch of so many work groups.
  void dispatch(GLuint groupsX, GLuint groupsY, GLuint groupsZ = 1) const;
};

}  // namespace skydrop::render::gl
