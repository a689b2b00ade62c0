// Faults of what the program stands on, for tests of the whole program: loaded before its libraries
// (LD_PRELOAD), this takes the place of some of their functions. A fault is on while a file of its name is in
// the folder $SKYDROP_FAULTS:
//   sound        the device that plays is gone; another opens
//   noSound      no device opens any more
//   reset        the driver has lost the graphics device
//   memory       the driver is out of memory, said once for each time that the file appears
//   zero         the window has no pixels, as a minimised one
//   clock        the clock on the wall is three years ahead: it jumps forth, and back when the file goes
#include <dlfcn.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

bool isOn(const char* fault) {
  static const char* const folder = std::getenv("SKYDROP_FAULTS");
  if (!folder) return false;
  char path[4096];
  std::snprintf(path, sizeof path, "%s/%s", folder, fault);
  return access(path, F_OK) == 0;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

constexpr int kConnected = 0x313;                               // ALC_CONNECTED
constexpr unsigned kUnknownReset = 0x8255, kNoMemory = 0x0505;  // OpenGL
constexpr long kYears = 100'000'000;                            // s

using GlEnumOfNothing = unsigned (*)();
GlEnumOfNothing realReset, realError;

unsigned resetStatus() { return isOn("reset") ? kUnknownReset : realReset(); }
unsigned error() {
  static std::atomic<bool> wasOn{false};
  const bool on = isOn("memory");
  if (on && !wasOn.exchange(true)) return kNoMemory;
  if (!on) wasOn = false;
  return realError();
}

using Procedure = void (*)();
Procedure replaced(const char* name, Procedure real) {
  if (std::strcmp(name, "glGetGraphicsResetStatus") == 0) {
    realReset = reinterpret_cast<GlEnumOfNothing>(real);
    return reinterpret_cast<Procedure>(resetStatus);
  }
  if (std::strcmp(name, "glGetError") == 0) {
    realError = reinterpret_cast<GlEnumOfNothing>(real);
    return reinterpret_cast<Procedure>(error);
  }
  return real;
}

const void* lostDevice = nullptr;  // the one that played when `sound` came

}  // namespace

extern "C" {

void alcGetIntegerv(void* device, int what, int count, int* values) {
  next<void(void*, int, int, int*)>("alcGetIntegerv")(device, what, count, values);
  if (what != kConnected) return;
  if (isOn("sound") && !lostDevice) lostDevice = device;
  if (device == lostDevice || isOn("noSound")) *values = 0;
}

void* alcOpenDevice(const char* name) {
  if (isOn("noSound")) return nullptr;
  void* const device = next<void*(const char*)>("alcOpenDevice")(name);
  if (device == lostDevice) lostDevice = &lostDevice;  // its memory may come back
  return device;
}

Procedure glfwGetProcAddress(const char* name) {
  return replaced(name, next<Procedure(const char*)>("glfwGetProcAddress")(name));
}

Procedure eglGetProcAddress(const char* name) {
  return replaced(name, next<Procedure(const char*)>("eglGetProcAddress")(name));
}

void glfwGetFramebufferSize(void* window, int* width, int* height) {
  next<void(void*, int*, int*)>("glfwGetFramebufferSize")(window, width, height);
  if (isOn("zero")) *width = *height = 0;
}

void glfwGetWindowSize(void* window, int* width, int* height) {
  next<void(void*, int*, int*)>("glfwGetWindowSize")(window, width, height);
  if (isOn("zero")) *width = *height = 0;
}

int clock_gettime(clockid_t clock, struct timespec* now) {
  static int (*const real)(clockid_t, struct timespec*) =
      next<int(clockid_t, struct timespec*)>("clock_gettime");
  const int result = real(clock, now);
  if (clock == CLOCK_REALTIME && isOn("clock")) now->tv_sec += kYears;
  return result;
}

}  // extern "C"
