// What all GL objects share: a move-only value that owns one name (id) of one context. An object that was
// default-constructed or moved from is empty: id 0, no context. The context must outlive its objects; an
// object may be destroyed while another context is current. glDelete* is called by this class and nowhere
// else.
#pragma once

#include <cstdint>
#include <string_view>

#include "skydrop/render/gl/context.h"

namespace skydrop::render::gl {

class Object {
 public:
  Object() = default;
  Object(Object&& other) noexcept { swap(other); }
  Object& operator=(Object&& other) noexcept {
    Object emptied(static_cast<Object&&>(other));
    swap(emptied);
    return *this;
  }
  ~Object() { destroy(); }

  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }
  // What the resource tracker counts for this object, in bytes.
  std::uint64_t bytes() const { return bytes_; }
  // Only of an object that is not empty.
  Context& context() const { return *context_; }

 protected:
  Object(Context& context, ObjectKind kind, GLuint id);
  void setBytes(std::uint64_t bytes);
  // Named in debug messages and in tools that record frames.
  void setLabel(std::string_view label);

 private:
  void swap(Object& other) noexcept;
  void destroy() noexcept;

  Context* context_ = nullptr;
  GLuint id_ = 0;
  ObjectKind kind_ = ObjectKind::buffer;
  GpuResourceTracker::Owner owner_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace skydrop::render::gl
