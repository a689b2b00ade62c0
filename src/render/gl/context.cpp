#include "skydrop/render/gl/context.h"

#include <cassert>
#include <initializer_list>

#include "render/gl/owned_functions.h"
#include "skydrop/core/error.h"
#include "skydrop/render/gl/buffer.h"

namespace skydrop::render::gl {
namespace {

constexpr std::size_t kKeptDebugMessages = 64;

// The context that is current on this thread. GL has the same notion; this copy makes switching exact,
// because EGL and OSMesa share Mesa's dispatch table and each believes that its own context is still current.
thread_local Context* currentContext = nullptr;

bool isSoftwareRenderer(std::string_view renderer) {
  for (std::string_view name :
       {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer", "GDI Generic"}) {
    if (renderer.find(name) != std::string_view::npos) return true;
  }
  return false;
}

std::size_t indexBytes(GLenum indexType) {
  return indexType == GL_UNSIGNED_INT ? 4 : indexType == GL_UNSIGNED_SHORT ? 2 : 1;
}

const void* offsetPointer(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

std::string_view backendName(Backend backend) {
  switch (backend) {
    case Backend::egl:
      return "egl";
    case Backend::osmesa:
      return "osmesa";
    case Backend::window:
      return "window";
  }
  return "";
}

Context::Context(Backend backend) : backend_(backend), owned_(std::make_unique<OwnedFunctions>()) {}

Context::~Context() { assert(resources_.liveObjects() == 0 && "an object outlives its context"); }

bool Context::isCurrent() const { return currentContext == this; }

void Context::makeCurrent() {
  if (currentContext == this) return;
  if (currentContext) currentContext->releaseFromThread();
  currentContext = nullptr;
  if (!bindToThread()) {
    throw core::GraphicsUnavailable(std::string(backendName(backend_)) +
                                    ": the context cannot be made current");
  }
  currentContext = this;
}

void Context::shutDown() {
  if (currentContext == this) {
    releaseFromThread();
    currentContext = nullptr;
  }
}

void Context::initialise() {
  const std::string name(backendName(backend_));
  makeCurrent();
  auto load = [&](const char* function) {
    Procedure pointer = procAddress(function);
    if (!pointer)
      throw core::GraphicsUnavailable(name + ": OpenGL 4.5 core is needed, and there is no " + function);
    return pointer;
  };
  // The version decides before the table does: an old driver then says what is wrong rather than what is
  // missing.
  functions_.GetString = reinterpret_cast<PFNGLGETSTRINGPROC>(load("glGetString"));
  functions_.GetIntegerv = reinterpret_cast<PFNGLGETINTEGERVPROC>(load("glGetIntegerv"));
  auto text = [&](GLenum what) {
    const GLubyte* string = functions_.GetString(what);
    return string ? std::string(reinterpret_cast<const char*>(string)) : std::string();
  };
  vendor_ = text(GL_VENDOR);
  renderer_ = text(GL_RENDERER);
  version_ = text(GL_VERSION);
  GLint major = 0, minor = 0;
  functions_.GetIntegerv(GL_MAJOR_VERSION, &major);
  functions_.GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 45) {
    throw core::GraphicsUnavailable(name + ": OpenGL 4.5 core is needed, the driver offers " + version_);
  }
#define SKYDROP_GL_LOAD(TYPE, function) \
  functions_.function = reinterpret_cast<PFNGL##TYPE##PROC>(load("gl" #function));
  SKYDROP_GL_FUNCTIONS(SKYDROP_GL_LOAD)
#undef SKYDROP_GL_LOAD
#define SKYDROP_GL_LOAD(TYPE, function) \
  owned_->function = reinterpret_cast<PFNGL##TYPE##PROC>(load("gl" #function));
  SKYDROP_GL_OWNED_FUNCTIONS(SKYDROP_GL_LOAD)
#undef SKYDROP_GL_LOAD
  isSoftware_ = isSoftwareRenderer(renderer_);

  functions_.Enable(GL_DEBUG_OUTPUT);
  functions_.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  functions_.DebugMessageCallback(&Context::onDebugMessage, this);
  functions_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  functions_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  setDefaultState();
}

std::int64_t Context::limit(GLenum name) const {
  GLint64 value = 0;
  functions_.GetInteger64v(name, &value);
  return value;
}

void Context::setDefaultState() {
  const Functions& gl = functions_;
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.FrontFace(GL_CCW);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_STENCIL_TEST);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void Context::drawArrays(GLenum mode, GLint first, GLsizei count) {
  resources_.drew();
  owned_->DrawArrays(mode, first, count);
}

void Context::drawElements(GLenum mode, GLsizei count, GLenum indexType, std::size_t firstIndex,
                           GLint baseVertex) {
  resources_.drew();
  owned_->DrawElementsBaseVertex(mode, count, indexType, offsetPointer(firstIndex * indexBytes(indexType)),
                                 baseVertex);
}

void Context::drawElementsInstanced(GLenum mode, GLsizei count, GLenum indexType, std::size_t firstIndex,
                                    GLsizei instances, GLint baseVertex, GLuint baseInstance) {
  resources_.drew();
  owned_->DrawElementsInstancedBaseVertexBaseInstance(mode, count, indexType,
                                                      offsetPointer(firstIndex * indexBytes(indexType)),
                                                      instances, baseVertex, baseInstance);
}

void Context::drawElementsIndirect(GLenum mode, GLenum indexType, const Buffer& commands, std::size_t offset,
                                   GLsizei draws, GLsizei strideBytes) {
  resources_.drew();
  commands.bind(GL_DRAW_INDIRECT_BUFFER);
  owned_->MultiDrawElementsIndirect(mode, indexType, offsetPointer(offset), draws, strideBytes);
}

void Context::dispatch(GLuint groupsX, GLuint groupsY, GLuint groupsZ) {
  resources_.dispatched();
  owned_->DispatchCompute(groupsX, groupsY, groupsZ);
}

void Context::dispatchIndirect(std::size_t byteOffset) {
  resources_.dispatched();
  owned_->DispatchComputeIndirect(static_cast<GLintptr>(byteOffset));
}

void Context::clearDebugMessages() {
  debugMessages_.clear();
  debugErrors_ = 0;
}

void APIENTRY Context::onDebugMessage(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                                      const GLchar* text, const void* self) {
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER || severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  Context& context = *const_cast<Context*>(static_cast<const Context*>(self));
  const bool serious = severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM;
  const bool isError = serious && (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR);
  if (isError) ++context.debugErrors_;
  if (context.debugMessages_.size() < kKeptDebugMessages) {
    context.debugMessages_.push_back(
        {length < 0 ? std::string(text) : std::string(text, text + length), isError});
  }
}

Context::Scope::Scope(Context& context) : before_(currentContext) { context.makeCurrent(); }

Context::Scope::~Scope() {
  if (before_) before_->makeCurrent();
}

}  // namespace skydrop::render::gl
