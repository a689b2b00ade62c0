// EGL without a surface: Mesa's surfaceless platform first, then every device that EGL_EXT_platform_device
// lists (NVIDIA's driver without Mesa has only these).
#include "render/platform/headless_context.h"
#include "skydrop/core/error.h"

#if defined(SKYDROP_HAS_EGL)

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace skydrop::render::gl {
namespace {

bool hasExtension(const char* list, const char* name) {
  if (!list) return false;
  const std::string padded = std::string(" ") + list + " ";
  return padded.find(std::string(" ") + name + " ") != std::string::npos;
}

struct Native {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

// EGL_NO_CONTEXT and a reason in `why` if this display has no 4.5 core context to give. A display that was
// initialised stays so until the process ends: eglTerminate would take it from every other context.
Native createOn(EGLDisplay display, std::string& why) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    why = "no display";
    return {};
  }
  if (!eglBindAPI(EGL_OPENGL_API)) {
    why = "no desktop OpenGL";
    return {};
  }
  const EGLint configAttributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                     EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (!eglChooseConfig(display, configAttributes, &config, 1, &count) || count == 0)
    config = EGL_NO_CONFIG_KHR;
  const EGLint contextAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      4,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                      EGL_LOSE_CONTEXT_ON_RESET,
                                      EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, contextAttributes);
  if (context == EGL_NO_CONTEXT) {  // perhaps it does not tell of resets
    const EGLint plain[] = {EGL_CONTEXT_MAJOR_VERSION,
                            4,
                            EGL_CONTEXT_MINOR_VERSION,
                            5,
                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, plain);
  }
  if (context == EGL_NO_CONTEXT) {
    why = "no OpenGL 4.5 core context";
    return {};
  }
  return {display, context};
}

Native createAnywhere(std::string& why) {
  why = "no EGL platform without a surface";
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (hasExtension(extensions, "EGL_MESA_platform_surfaceless")) {
    const Native native =
        createOn(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), why);
    if (native.context != EGL_NO_CONTEXT) return native;
  }
  const auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  if (queryDevices && hasExtension(extensions, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!queryDevices(static_cast<EGLint>(devices.size()), devices.data(), &count)) count = 0;
    for (EGLint i = 0; i < count; ++i) {
      const Native native = createOn(
          eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(i)], nullptr), why);
      if (native.context != EGL_NO_CONTEXT) return native;
    }
  }
  return {};
}

class EglContext final : public Context {
 public:
  explicit EglContext(Native native) : Context(Backend::egl), native_(native) {
    try {
      initialise();
    } catch (...) {
      destroy();
      throw;
    }
  }
  ~EglContext() override { destroy(); }

 protected:
  Procedure procAddress(const char* name) override { return eglGetProcAddress(name); }
  bool bindToThread() override {
    return eglBindAPI(EGL_OPENGL_API) &&
           eglMakeCurrent(native_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, native_.context);
  }
  void releaseFromThread() override {
    eglMakeCurrent(native_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }

 private:
  void destroy() {
    shutDown();
    eglDestroyContext(native_.display, native_.context);
  }

  Native native_;
};

}  // namespace

std::unique_ptr<Context> openEgl() {
  std::string why;
  const Native native = createAnywhere(why);
  if (native.context == EGL_NO_CONTEXT)
    throw core::GraphicsUnavailable("egl: OpenGL 4.5 core is needed: " + why);
  return std::make_unique<EglContext>(native);
}

}  // namespace skydrop::render::gl

#else

namespace skydrop::render::gl {
std::unique_ptr<Context> openEgl() {
  throw core::GraphicsUnavailable("egl: this build of skydrop has no EGL back-end");
}
}  // namespace skydrop::render::gl

#endif
