#include "skydrop/render/gl/context.h"

#include "render/gl/device_check.h"
#include "render/gl/owned_functions.h"
#include "skydrop/core/error.h"
#include "skydrop/render/gl/buffer.h"
#include "support/gl_test.h"
#include "support/refusal.h"

namespace skydrop::render::gl {
namespace {

using test::GLTest;

TEST_F(GLTest, contextOffersCoreFourFive) {
  // Whatever the back-end, the context is 4.5 core or there is none.
  EXPECT_EQ(context().backend(), test::backendFromEnvironment());
  EXPECT_GE(context().limit(GL_MAJOR_VERSION) * 10 + context().limit(GL_MINOR_VERSION), 45);
  EXPECT_TRUE(context().limit(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT);
  EXPECT_FALSE(context().renderer().empty());
  EXPECT_GE(context().limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS), 1024);
}

TEST_F(GLTest, contextCollectsTheDriversErrors) {
  // An error of the driver is counted with its words; nothing is printed and forgotten.
  ASSERT_EQ(context().debugErrors(), 0u);
  api().Enable(0xdead);
  EXPECT_EQ(context().debugErrors(), 1u);
  ASSERT_FALSE(context().debugMessages().empty());
  EXPECT_FALSE(context().debugMessages().back().text.empty());
  api().GetError();
  forgiveDebugErrors();
}

// A driver that answers two questions as it is told, while this lives.
GLenum saidReset = GL_NO_ERROR, saidError = GL_NO_ERROR;
class FailingDriver {
 public:
  explicit FailingDriver(Context& context)
      : functions_(const_cast<Functions&>(context.api())),
        owned_(const_cast<OwnedFunctions&>(context.owned())),
        error_(functions_.GetError),
        reset_(owned_.GetGraphicsResetStatus) {
    owned_.GetGraphicsResetStatus = []() -> GLenum { return saidReset; };
    functions_.GetError = []() -> GLenum { return saidError; };
  }
  ~FailingDriver() {
    functions_.GetError = error_;
    owned_.GetGraphicsResetStatus = reset_;
    saidReset = saidError = GL_NO_ERROR;
  }
  FailingDriver(const FailingDriver&) = delete;
  FailingDriver& operator=(const FailingDriver&) = delete;

 private:
  Functions& functions_;
  OwnedFunctions& owned_;
  PFNGLGETERRORPROC error_;
  PFNGLGETGRAPHICSRESETSTATUSPROC reset_;
};

TEST_F(GLTest, contextTellsALostDeviceFromAFullOne) {
  // Of every kind of reset, and of a context that says so with every error, for ever; what is no error of
  // memory is left to the debug messages.
  EXPECT_NO_THROW(requireDevice(context()));
  const FailingDriver driver(context());
  for (const GLenum reset : {GL_GUILTY_CONTEXT_RESET, GL_INNOCENT_CONTEXT_RESET, GL_UNKNOWN_CONTEXT_RESET}) {
    saidReset = reset;
    EXPECT_EQ(test::refusalOf<core::GraphicsUnavailable>([&] { requireDevice(context()); }),
              "OpenGL: the driver has lost the graphics device");
  }
  saidReset = GL_NO_ERROR;
  saidError = GL_CONTEXT_LOST;
  EXPECT_THROW(requireDevice(context()), core::GraphicsUnavailable);
  saidError = GL_OUT_OF_MEMORY;
  EXPECT_EQ(test::refusalOf<core::DataError>([&] { requireDevice(context()); }),
            "OpenGL: frame: the driver has run out of memory");
  saidError = GL_INVALID_ENUM;
  EXPECT_NO_THROW(requireDevice(context()));
}

TEST_F(GLTest, contextCountsDrawsAndDispatchesByPass) {
  // The resources books each draw on the pass that is open, and no other.
  GpuResourceTracker& resources = context().resources();
  resources.clearPasses();
  resources.beginPass("terrain");
  resources.drew();
  resources.drew();
  resources.endPass();
  resources.beginPass("clouds");
  resources.dispatched();
  resources.endPass();
  EXPECT_EQ(resources.passes().at("terrain"), (PassCounts{2, 0}));
  EXPECT_EQ(resources.passes().at("clouds"), (PassCounts{0, 1}));
  EXPECT_EQ(resources.total(), (PassCounts{2, 1}));
}

TEST_F(GLTest, twoContextsOfOneBackendDoNotMixTheirObjects) {
  // An object is deleted in its own context, whichever is current.
  std::string why;
  const auto other = test::openForTest(context().backend(), why);
  ASSERT_TRUE(other) << why;
  EXPECT_TRUE(other->isCurrent());
  {
    Buffer theirs(*other, 16, Buffer::Use::write, "theirs");
    context().makeCurrent();
    Buffer ours(context(), 32, Buffer::Use::write, "ours");
    EXPECT_EQ(other->resources().bytes(), 16u);
    EXPECT_EQ(context().resources().bytes(), 32u);
    theirs = Buffer();
    EXPECT_TRUE(context().isCurrent());
    EXPECT_EQ(other->resources().liveObjects(), 0);
    EXPECT_EQ(context().resources().liveObjects(), 1);
    const int value = 7;
    ours.writeValue(0, value);
    int read = 0;
    ours.read(0, std::as_writable_bytes(std::span<int, 1>(&read, 1)));
    EXPECT_EQ(read, value);
  }
  EXPECT_EQ(other->debugErrors(), 0u);
}

}  // namespace
}  // namespace skydrop::render::gl
