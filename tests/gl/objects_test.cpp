#include <array>
#include <functional>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "render/gl/owned_functions.h"
#include "skydrop/core/error.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/gl/query.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/texture.h"
#include "skydrop/render/gl/vertex_array.h"
#include "support/gl_test.h"
#include "support/refusal.h"

namespace skydrop::render::gl {
namespace {

using test::GLTest;

template <class T>
void expectMoves(Context& context, T made) {
  static_assert(!std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T>);
  static_assert(std::is_nothrow_move_constructible_v<T> && std::is_nothrow_move_assignable_v<T>);
  const GLuint id = made.id();
  const std::uint64_t bytes = made.bytes();
  EXPECT_NE(id, 0u);
  T moved(std::move(made));
  EXPECT_EQ(moved.id(), id);
  EXPECT_EQ(moved.bytes(), bytes);
  EXPECT_EQ(made.id(), 0u);  // NOLINT: moved-from is what is tested
  EXPECT_EQ(made.bytes(), 0u);
  EXPECT_FALSE(made);
  const std::int64_t before = context.resources().liveObjects();
  made = std::move(moved);
  EXPECT_EQ(made.id(), id);
  EXPECT_EQ(context.resources().liveObjects(), before);
  made = T();
  EXPECT_LT(context.resources().liveObjects(), before);
  EXPECT_EQ(context.resources().liveObjects(), 0);
  EXPECT_EQ(context.resources().bytes(), 0u);
}

TEST_F(GLTest, objectsMoveAndLeaveNothingBehind) {
  // A moved-from object is empty, an assigned-over one is deleted, and the resource tracker returns to zero.
  expectMoves(context(), Buffer(context(), 64, Buffer::Use::fixed, "buffer"));
  expectMoves(context(), Texture::make2D(context(), GL_RGBA8, 4, 4, "texture"));
  expectMoves(context(), VertexArray(context(), "vertex array"));
  expectMoves(context(), Sampler(context(), GL_NEAREST, GL_NEAREST, GL_REPEAT, "sampler"));
  expectMoves(context(), Query(context(), GL_TIME_ELAPSED));
  expectMoves(context(), FrameBuffer(context(), 8, 8, {}, "frame buffer"));
}

// A driver that gives no more objects, while it lives.
class NoMoreObjects {
 public:
  explicit NoMoreObjects(Context& context)
      : functions_(const_cast<OwnedFunctions&>(context.owned())), old_(functions_) {
    functions_.CreateBuffers = functions_.CreateFramebuffers = functions_.CreateSamplers =
        functions_.CreateVertexArrays = [](GLsizei, GLuint* names) { *names = 0; };
    functions_.CreateTextures = functions_.CreateQueries = [](GLenum, GLsizei, GLuint* names) { *names = 0; };
    functions_.CreateProgram = []() -> GLuint { return 0; };
    functions_.CreateShader = [](GLenum) -> GLuint { return 0; };
  }
  ~NoMoreObjects() { functions_ = old_; }
  NoMoreObjects(const NoMoreObjects&) = delete;
  NoMoreObjects& operator=(const NoMoreObjects&) = delete;

 private:
  OwnedFunctions& functions_;
  OwnedFunctions old_;
};

TEST_F(GLTest, anObjectThatTheDriverDoesNotGiveIsOneLineAndLeavesNothingBehind) {
  // Of each kind; what is there goes on, and is made again once the driver gives objects.
  Buffer kept(context(), 64, Buffer::Use::fixed, "kept");
  const std::int64_t before = context().resources().liveObjects();
  const auto makeEach = [&] {
    return std::vector<std::pair<std::string, std::function<void()>>>{
        {"buffer", [&] { Buffer(context(), 64, Buffer::Use::fixed, "buffer"); }},
        {"texture", [&] { Texture::make2D(context(), GL_RGBA8, 4, 4, "texture"); }},
        {"vertex array", [&] { VertexArray(context(), "vertex array"); }},
        {"sampler", [&] { Sampler(context(), GL_NEAREST, GL_NEAREST, GL_REPEAT, "sampler"); }},
        {"query", [&] { Query(context(), GL_TIME_ELAPSED); }},
        {"frame buffer", [&] { FrameBuffer(context(), 8, 8, {}, "frame buffer"); }}};
  };
  {
    const NoMoreObjects none(context());
    for (const auto& [kind, make] : makeEach()) {
      EXPECT_EQ(
          test::refusalOf<core::DataError>(make),
          "OpenGL: " + kind + ": cannot be created: the driver is out of memory or has lost the device");
    }
    EXPECT_EQ(context().resources().liveObjects(), before);
    EXPECT_THROW(kept = Buffer(context(), 64, Buffer::Use::fixed, "another"), core::DataError);
    EXPECT_NE(kept.id(), 0u) << "the last good one stays";
  }
  for (const auto& [kind, make] : makeEach()) EXPECT_EQ(test::refusalOf<core::DataError>(make), "") << kind;
  EXPECT_EQ(context().resources().liveObjects(), before);
}

TEST_F(GLTest, emptyObjectsCostNothing) {
  // Default-constructed objects hold no name and may be destroyed without a context.
  const Buffer buffer;
  const Texture texture;
  const FrameBuffer target;
  const Shader shader;
  EXPECT_EQ(buffer.id() + texture.id() + target.id() + shader.id(), 0u);
  EXPECT_EQ(context().resources().liveObjects(), 0);
}

TEST_F(GLTest, bufferKeepsWhatIsWritten) {
  // Content given at creation, parts replaced later, all read back.
  std::array<int, 8> values{};
  std::iota(values.begin(), values.end(), 0);
  Buffer buffer = Buffer::of(context(), std::span<const int>(values), Buffer::Use::write, "values");
  EXPECT_EQ(buffer.size(), sizeof(values));
  buffer.writeValue(4 * sizeof(int), 40);
  values[4] = 40;
  std::array<int, 8> read{};
  buffer.read(0, std::as_writable_bytes(std::span(read)));
  EXPECT_EQ(read, values);
}

TEST_F(GLTest, textureBytesCountEveryLevelAndLayer) {
  // 8x4 with four levels: 32 + 8 + 2 + 1 texels; five layers; four bytes each.
  EXPECT_EQ(mipLevels(8, 4), 4);
  const Texture texture = Texture::make2DArray(context(), GL_RGBA8, 8, 4, 5, "array", 4);
  EXPECT_EQ(texture.bytes(), (32u + 8 + 2 + 1) * 5 * 4);
  EXPECT_EQ(context().resources().bytes(), texture.bytes());
  // A 3D texture shrinks in depth as well: 8^3 + 4^3 texels of 2 bytes.
  const Texture volume = Texture::make3D(context(), GL_R16F, 8, 8, 8, "volume", 2);
  EXPECT_EQ(volume.bytes(), (512u + 64) * 2);
}

TEST_F(GLTest, textureLayersAreUploadedApart) {
  // Writing layer 1 of three leaves the others as they were.
  Texture texture = Texture::make2DArray(context(), GL_R16, 2, 2, 3, "array");
  const std::array<std::uint16_t, 12> zeros{};
  texture.upload(GL_RED, GL_UNSIGNED_SHORT, std::as_bytes(std::span(zeros)));
  const std::array<std::uint16_t, 4> layer{1, 2, 3, 65535};
  texture.uploadLayer(1, GL_RED, GL_UNSIGNED_SHORT, std::as_bytes(std::span(layer)));
  std::array<std::uint16_t, 12> read{};
  texture.read(GL_RED, GL_UNSIGNED_SHORT, std::as_writable_bytes(std::span(read)));
  EXPECT_EQ(read, (std::array<std::uint16_t, 12>{0, 0, 0, 0, 1, 2, 3, 65535, 0, 0, 0, 0}));
}

TEST_F(GLTest, frameBufferBindsClearsResizesAndRestores) {
  // bind() may clear or keep, unBind() brings back target and viewport, resize() changes both textures.
  FrameBuffer outer(context(), 4, 4, {}, "outer");
  FrameBuffer inner(context(), 6, 2, {GL_RGBA8, GL_DEPTH_COMPONENT32F}, "inner");
  outer.bind();
  inner.setClearColor(1, 0, 0, 1);
  inner.bind(FrameBuffer::Clear::yes);
  inner.unBind();
  GLint target = 0;
  std::array<GLint, 4> viewport{};
  api().GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  api().GetIntegerv(GL_VIEWPORT, viewport.data());
  EXPECT_EQ(static_cast<GLuint>(target), outer.id());
  EXPECT_EQ(viewport, (std::array<GLint, 4>{0, 0, 4, 4}));
  outer.unBind();

  EXPECT_EQ(test::readFloats(inner).front(), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(test::readDepth(inner).back(), 0.0f);  // reversed depth: the far end
  inner.setClearColor(0, 1, 0, 1);
  inner.bind(FrameBuffer::Clear::no);
  inner.unBind();
  EXPECT_EQ(test::readFloats(inner).front(), glm::vec4(1, 0, 0, 1));

  const std::uint64_t before = context().resources().bytes();
  inner.resize(12, 2);
  EXPECT_EQ(context().resources().bytes(), before + 6 * 2 * 8);
  inner.bind();
  inner.unBind();
  EXPECT_EQ(test::readFloats(inner).size(), 24u);
  EXPECT_EQ(test::readFloats(inner).back(), glm::vec4(0, 1, 0, 1));

  // Drawn to another buffer it fills it, whatever the sizes and whatever scissor box was left behind.
  api().Enable(GL_SCISSOR_TEST);
  api().Scissor(0, 0, 1, 1);
  inner.drawTo(outer);
  EXPECT_EQ(test::readFloats(outer).back(), glm::vec4(0, 1, 0, 1));
}

TEST_F(GLTest, frameBufferCanBorrowItsTextures) {
  // Two targets over one depth texture: what one clears the other sees, and the texture stays its owner's.
  FrameBuffer owner(context(), 4, 4, {}, "owner");
  Texture color = Texture::make2D(context(), GL_RGBA16F, 4, 4, "other colour");
  FrameBuffer borrower(context(), &color, &owner.depthTexture(), "borrower");
  borrower.setClearDepth(0.5f);
  borrower.bind();
  borrower.unBind();
  EXPECT_EQ(test::readDepth(owner).front(), 0.5f);
  EXPECT_EQ(context().resources().live(ObjectKind::texture), 3);
}

}  // namespace
}  // namespace skydrop::render::gl
