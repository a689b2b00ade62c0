#include "skydrop/render/gl/shader.h"

#include <algorithm>
#include <cctype>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <utility>

#include "render/gl/created.h"
#include "render/gl/owned_functions.h"
#include "skydrop/core/error.h"

namespace skydrop::render::gl {
namespace {

GLuint createProgram(Context& context) { return created(context.owned().CreateProgram(), "program"); }

// A shader object lives only while its program is built, so it is no member of the resource tracker.
class CompiledStage {
 public:
  CompiledStage(Context& context, const ShaderStage& stage)
      : gl_(context.owned()), id_(created(gl_.CreateShader(stage.type), "shader")) {
    const GLchar* text = stage.source.text().c_str();
    gl_.ShaderSource(id_, 1, &text, nullptr);
    gl_.CompileShader(id_);
    GLint ok = GL_FALSE;
    gl_.GetShaderiv(id_, GL_COMPILE_STATUS, &ok);
    if (ok) return;
    GLint length = 0;
    gl_.GetShaderiv(id_, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    gl_.GetShaderInfoLog(id_, length, &length, log.data());
    log.resize(static_cast<std::size_t>(std::max(length, 0)));
    gl_.DeleteShader(id_);
    const ShaderSource::Message error = stage.source.firstError(log);
    throw core::DataError(error.place.file, "line " + std::to_string(error.place.line), error.text);
  }
  ~CompiledStage() { gl_.DeleteShader(id_); }
  CompiledStage(const CompiledStage&) = delete;
  CompiledStage& operator=(const CompiledStage&) = delete;

  GLuint id() const { return id_; }

 private:
  const OwnedFunctions& gl_;
  GLuint id_;
};

std::filesystem::file_time_type writeTime(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::last_write_time(path, ignored);
}

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

bool containsWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const bool startsWord = at == 0 || !isWordCharacter(text[at - 1]);
    const std::size_t end = at + word.size();
    if (startsWord && (end == text.size() || !isWordCharacter(text[end]))) return true;
  }
  return false;
}

}  // namespace

Program::Program(Context& context, std::span<const ShaderStage> stages, std::string_view label)
    : Object(context, ObjectKind::program, createProgram(context)) {
  const OwnedFunctions& gl = context.owned();
  {
    std::vector<std::unique_ptr<CompiledStage>> compiled;
    for (const ShaderStage& stage : stages)
      compiled.push_back(std::make_unique<CompiledStage>(context, stage));
    for (const auto& stage : compiled) gl.AttachShader(id(), stage->id());
    gl.LinkProgram(id());
    for (const auto& stage : compiled) gl.DetachShader(id(), stage->id());
  }
  GLint ok = GL_FALSE;
  context.api().GetProgramiv(id(), GL_LINK_STATUS, &ok);
  if (!ok) {
    GLint length = 0;
    context.api().GetProgramiv(id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    gl.GetProgramInfoLog(id(), length, &length, log.data());
    log.resize(static_cast<std::size_t>(std::max(length, 0)));
    throw core::DataError(label, "link", log);
  }
  setLabel(label);
}

ShaderProgram::ShaderProgram(Context& context, std::vector<File> files, std::span<const std::string> defines)
    : files_(std::move(files)), defines_(defines.begin(), defines.end()) {
  std::erase_if(files_, [](const File& file) { return file.name.empty(); });
  for (const File& file : files_) name_ += (name_.empty() ? "" : " + ") + file.name;
  build(context);
}

void ShaderProgram::build(Context& context) {
  // Times are kept whatever comes of it, so that a broken file is tried once and not each frame.
  for (ShaderSource::File& file : watched_) file.written = writeTime(file.path);
  std::vector<ShaderStage> stages;
  std::string text;
  std::vector<ShaderSource::File> watched;
  for (const File& file : files_) {
    const ShaderStage& stage = stages.emplace_back(ShaderStage{file.type, ShaderSource(file.name, defines_)});
    text += stage.source.text();
    watched.insert(watched.end(), stage.source.files().begin(), stage.source.files().end());
  }
  watched_ = std::move(watched);
  program_ = Program(context, stages, name_);
  text_ = std::move(text);
  locations_.clear();
}

void ShaderProgram::reload() { build(program_.context()); }

bool ShaderProgram::isStale() const {
  return std::any_of(watched_.begin(), watched_.end(),
                     [](const ShaderSource::File& file) { return writeTime(file.path) != file.written; });
}

void ShaderProgram::use() const { program_.context().api().UseProgram(program_.id()); }

GLint ShaderProgram::location(std::string_view name) {
  if (const auto known = locations_.find(name); known != locations_.end()) return known->second;
  const std::string terminated(name);
  const GLint found = context().api().GetUniformLocation(id(), terminated.c_str());
  const std::string_view identifier = name.substr(0, name.find_first_of("[."));
  if (found < 0 && !containsWord(text_, identifier)) context().resources().unknownUniform(name_, name);
  locations_.emplace(terminated, found);
  return found;
}

void ShaderProgram::setBool(std::string_view name, bool value) { setInt(name, value ? 1 : 0); }

void ShaderProgram::setInt(std::string_view name, int value) {
  context().api().ProgramUniform1i(id(), location(name), value);
}

void ShaderProgram::setUint(std::string_view name, unsigned value) {
  context().api().ProgramUniform1ui(id(), location(name), value);
}

void ShaderProgram::setFloat(std::string_view name, float value) {
  context().api().ProgramUniform1f(id(), location(name), value);
}

void ShaderProgram::setVec2(std::string_view name, const glm::vec2& value) {
  context().api().ProgramUniform2fv(id(), location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::setVec3(std::string_view name, const glm::vec3& value) {
  context().api().ProgramUniform3fv(id(), location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::setVec4(std::string_view name, const glm::vec4& value) {
  context().api().ProgramUniform4fv(id(), location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::setIvec2(std::string_view name, const glm::ivec2& value) {
  context().api().ProgramUniform2iv(id(), location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::setIvec3(std::string_view name, const glm::ivec3& value) {
  context().api().ProgramUniform3iv(id(), location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::setMatrix(std::string_view name, const glm::mat3& value) {
  context().api().ProgramUniformMatrix3fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void ShaderProgram::setMatrix(std::string_view name, const glm::mat4& value) {
  context().api().ProgramUniformMatrix4fv(id(), location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void ShaderProgram::setFloats(std::string_view name, std::span<const float> values) {
  context().api().ProgramUniform1fv(id(), location(name), static_cast<GLsizei>(values.size()), values.data());
}

void ShaderProgram::setVec4s(std::string_view name, std::span<const glm::vec4> values) {
  if (values.empty()) return;
  context().api().ProgramUniform4fv(id(), location(name), static_cast<GLsizei>(values.size()),
                                    glm::value_ptr(values.front()));
}

Shader::Shader(Context& context, std::string vertex, std::string fragment, std::string geometry,
               std::span<const std::string> defines)
    : ShaderProgram(context,
                    {{GL_VERTEX_SHADER, std::move(vertex)},
                     {GL_GEOMETRY_SHADER, std::move(geometry)},
                     {GL_FRAGMENT_SHADER, std::move(fragment)}},
                    defines) {}

ComputeShader::ComputeShader(Context& context, std::string file, std::span<const std::string> defines)
    : ShaderProgram(context, {{GL_COMPUTE_SHADER, std::move(file)}}, defines) {}

void ComputeShader::dispatch(GLuint groupsX, GLuint groupsY, GLuint groupsZ) const {
  use();
  context().dispatch(groupsX, groupsY, groupsZ);
}

}  // namespace skydrop::render::gl
