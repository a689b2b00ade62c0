// An OpenGL 4.5 core context and everything that belongs to it: function table, resource tracker, collected
// debug messages. Three back-ends behind one class: EGL without a surface, OSMesa (loaded at run time), a
// window.
//
// Thread: a context is used on the thread that made it current. Several contexts may live in one process,
// also of different back-ends, but only one is current on a thread. Errors: what keeps a 4.5 core context
// from coming up is thrown as core::GraphicsUnavailable, in one line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "skydrop/render/gl/backend.h"
#include "skydrop/render/gl/functions.h"
#include "skydrop/render/gl/gpu_resource_tracker.h"

namespace skydrop::render::gl {

class Buffer;
struct OwnedFunctions;

struct DebugMessage {
  std::string text;
  bool isError = false;
};

class Context {
 public:
  virtual ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  Backend backend() const { return backend_; }
  void makeCurrent();
  bool isCurrent() const;

  const Functions& api() const { return functions_; }
  GpuResourceTracker& resources() { return resources_; }
  const GpuResourceTracker& resources() const { return resources_; }

  const std::string& vendor() const { return vendor_; }
  const std::string& renderer() const { return renderer_; }
  const std::string& version() const { return version_; }
  // A software renderer: timer queries mean nothing there (PassTimer).
  bool isSoftware() const { return isSoftware_; }
  std::int64_t limit(GLenum name) const;

  // The state every pass may rely on when its draw() begins: depth test GEQUAL (reversed-Z) with writes,
  // no blending, no culling, no scissor, filled polygons, clip space 0..1 with the origin at the lower left.
  void setDefaultState();

  // Draws and dispatches, counted in the resource tracker. Arguments as in OpenGL; indices are counted in
  // elements.
  void drawArrays(GLenum mode, GLint first, GLsizei count);
  void drawElements(GLenum mode, GLsizei count, GLenum indexType, std::size_t firstIndex = 0,
                    GLint baseVertex = 0);
  void drawElementsInstanced(GLenum mode, GLsizei count, GLenum indexType, std::size_t firstIndex,
                             GLsizei instances, GLint baseVertex = 0, GLuint baseInstance = 0);
  // So many draws, as one: their commands (DrawElementsIndirectCommand) lie in a buffer from a byte on, one
  // after the other, strideBytes apart.
  void drawElementsIndirect(GLenum mode, GLenum indexType, const Buffer& commands, std::size_t offset,
                            GLsizei draws, GLsizei strideBytes);
  void dispatch(GLuint groupsX, GLuint groupsY, GLuint groupsZ);
  void dispatchIndirect(std::size_t byteOffset);

  // Messages of the driver since the last clear. Errors are those of type error or undefined behaviour, of
  // severity high or medium; compile errors are not among them, because they are thrown where they happen.
  // The first 64 are kept, all are counted.
  const std::vector<DebugMessage>& debugMessages() const { return debugMessages_; }
  std::uint64_t debugErrors() const { return debugErrors_; }
  void clearDebugMessages();

  const OwnedFunctions& owned() const { return *owned_; }  // for the sources of render/gl

  // Makes a context current for a scope and restores the one before it.
  class Scope {
   public:
    explicit Scope(Context& context);
    ~Scope();
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Context* before_;
  };

 protected:
  explicit Context(Backend backend);

  using Procedure = void (*)();
  virtual Procedure procAddress(const char* name) = 0;
  virtual bool bindToThread() = 0;
  virtual void releaseFromThread() = 0;

  // Called once by a derived constructor: makes current, fills the table, checks the version, starts the
  // collection of debug messages.
  void initialise();
  // Called by a derived destructor before its native context goes.
  void shutDown();

 private:
  static void APIENTRY onDebugMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                                      const GLchar* text, const void* self);

  Backend backend_;
  Functions functions_;
  std::unique_ptr<OwnedFunctions> owned_;
  GpuResourceTracker resources_;
  std::string vendor_, renderer_, version_;
  bool isSoftware_ = false;
  std::vector<DebugMessage> debugMessages_;
  std::uint64_t debugErrors_ = 0;
};

// A context that draws into frame buffer objects only. Calls nothing of GLFW. window is not accepted here.
std::unique_ptr<Context> openHeadless(Backend backend);

}  // namespace skydrop::render::gl
