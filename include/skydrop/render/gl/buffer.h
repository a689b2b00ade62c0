// Move-only owners of GL buffer objects. On the context's thread; a buffer must go before its context. Sizes
// and offsets in bytes. What is outside a buffer's range is a programming error and asserted.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>

#include "skydrop/render/gl/object.h"

namespace skydrop::render::gl {

// A buffer of fixed size (glNamedBufferStorage: immutable storage), counted by the context's resource
// tracker.
class Buffer : public Object {
 public:
  // write: the CPU replaces parts with write(). fixed: content is given at creation or made by the GPU.
  enum class Use { fixed, write };

  Buffer() = default;  // no object: may be assigned to and destroyed, nothing else
  // `label` names it in the driver's debug messages. Content is undefined until written. What the driver
  // cannot give is reported by its debug messages (Context::debugErrors).
  Buffer(Context& context, std::size_t size, Use use, std::string_view label);
  Buffer(Context& context, std::span<const std::byte> content, Use use, std::string_view label);

  template <class T>
  static Buffer of(Context& context, std::span<const T> content, Use use, std::string_view label) {
    static_assert(std::is_trivially_copyable_v<T>);
    return Buffer(context, std::as_bytes(content), use, label);
  }

  std::size_t size() const { return static_cast<std::size_t>(bytes()); }

  // Use::write only; offset + content must lie within the buffer.
  void write(std::size_t offset, std::span<const std::byte> content);
  template <class T>
  void writeValue(std::size_t offset, const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    write(offset, std::as_bytes(std::span<const T, 1>(&value, 1)));
  }
  // From the offset on, as much as `content` holds. Waits for the GPU: for tests and readback, not for every
  // frame.
  void read(std::size_t offset, std::span<std::byte> content) const;

  void bind(GLenum target) const;  // GL_DRAW_INDIRECT_BUFFER, GL_DISPATCH_INDIRECT_BUFFER ...
  void bindBase(GLenum target, GLuint index) const;  // GL_UNIFORM_BUFFER, GL_SHADER_STORAGE_BUFFER
};

}  // namespace skydrop::render::gl
