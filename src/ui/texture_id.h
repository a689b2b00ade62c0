// An OpenGL texture as Dear ImGui names it.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <type_traits>

namespace skydrop::ui {

// ImTextureID is a pointer in some versions of Dear ImGui and an integer in others.
template <class Id = ImTextureID>
Id textureId(std::uint32_t name) {
  if constexpr (std::is_pointer_v<Id>)
    return reinterpret_cast<Id>(static_cast<std::uintptr_t>(name));
  else
    return static_cast<Id>(name);
}

}  // namespace skydrop::ui
