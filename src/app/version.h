#pragma once

namespace skydrop::app {

inline constexpr const char* kVersion = SKYDROP_VERSION;

}  // namespace skydrop::app
