#pragma once

#include <string_view>

namespace skydrop::render::gl {

// Where an OpenGL context comes from: EGL without a surface, OSMesa (software), or a window of GLFW.
enum class Backend { egl, osmesa, window };
// "egl", "osmesa", "window": as on the command line and in messages.
std::string_view backendName(Backend backend);

}  // namespace skydrop::render::gl
