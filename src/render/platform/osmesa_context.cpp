// OSMesa, loaded at run time into its own scope: linked together with libGL it would duplicate every gl
// symbol, and newer Mesa has no such library at all. The declarations are our own because <GL/osmesa.h>
// includes <GL/gl.h>, whose prototypes collide with glcorearb.h.
#include "render/platform/headless_context.h"
#include "skydrop/core/error.h"

#if defined(__unix__)

#include <dlfcn.h>

#include <array>
#include <cstdint>

namespace skydrop::render::gl {
namespace {

struct OsMesaContextTag;
using OsMesaHandle = OsMesaContextTag*;

// Attribute names of OSMesaCreateContextAttribs.
constexpr int kFormat = 0x22, kProfile = 0x33, kCoreProfile = 0x34, kMajorVersion = 0x36,
              kMinorVersion = 0x37;

struct Library {
  OsMesaHandle (*createContextAttribs)(const int* attributes, OsMesaHandle shared) = nullptr;
  void (*destroyContext)(OsMesaHandle) = nullptr;
  GLboolean (*makeCurrent)(OsMesaHandle, void* buffer, GLenum type, GLsizei width, GLsizei height) = nullptr;
  void (*(*getProcAddress)(const char*))() = nullptr;
};

// Stays loaded until the process ends: Mesa leaves thread-local state behind that outlives a dlclose.
const Library& library() {
  static const Library loaded = [] {
    void* handle = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
      handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (handle) break;
    }
    if (!handle)
      throw core::GraphicsUnavailable("osmesa: libOSMesa.so.8 cannot be loaded (package libosmesa6)");
    Library found;
    auto symbol = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, name));
      if (!function) throw core::GraphicsUnavailable(std::string("osmesa: the library has no ") + name);
    };
    symbol(found.createContextAttribs, "OSMesaCreateContextAttribs");
    symbol(found.destroyContext, "OSMesaDestroyContext");
    symbol(found.makeCurrent, "OSMesaMakeCurrent");
    symbol(found.getProcAddress, "OSMesaGetProcAddress");
    return found;
  }();
  return loaded;
}

class OsMesaContext final : public Context {
 public:
  explicit OsMesaContext(OsMesaHandle handle) : Context(Backend::osmesa), handle_(handle) {
    try {
      initialise();
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~OsMesaContext() override { destroy(); }

 protected:
  Procedure procAddress(const char* name) override { return library().getProcAddress(name); }
  bool bindToThread() override {
    return library().makeCurrent(handle_, screen_.data(), GL_UNSIGNED_BYTE, kScreenSide, kScreenSide);
  }
  void releaseFromThread() override { library().makeCurrent(nullptr, nullptr, 0, 0, 0); }

 private:
  // OSMesa insists on a default frame buffer; nothing draws into it.
  static constexpr int kScreenSide = 4;

  void destroy() {
    shutDown();
    library().destroyContext(handle_);
  }

  OsMesaHandle handle_;
  std::array<std::uint8_t, kScreenSide * kScreenSide * 4> screen_{};
};

}  // namespace

std::unique_ptr<Context> openOsMesa() {
  const int attributes[] = {kFormat, GL_RGBA, kProfile, kCoreProfile, kMajorVersion, 4, kMinorVersion, 5, 0};
  const OsMesaHandle handle = library().createContextAttribs(attributes, nullptr);
  if (!handle)
    throw core::GraphicsUnavailable("osmesa: OpenGL 4.5 core is needed, and this library has less");
  return std::make_unique<OsMesaContext>(handle);
}

}  // namespace skydrop::render::gl

#else

namespace skydrop::render::gl {
std::unique_ptr<Context> openOsMesa() {
  throw core::GraphicsUnavailable("osmesa: this build of skydrop has no OSMesa back-end");
}
}  // namespace skydrop::render::gl

#endif
