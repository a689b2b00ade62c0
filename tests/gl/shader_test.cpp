#include "skydrop/render/gl/shader.h"

#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <glm/mat4x4.hpp>

#include "skydrop/core/error.h"
#include "skydrop/render/gl/buffer.h"
#include "skydrop/render/gl/shader_cache.h"
#include "support/gl_test.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::render::gl {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class ShaderGLTest : public test::GLTest {
 protected:
  test::TemporaryFolder folder_;
  const std::string vertex_ = folder_.write("plain.vert", "void main() { gl_Position = vec4(0); }\n");

  // The error that compiling these files throws.
  std::string errorOf(const std::string& fragment) {
    return test::refusalOf<core::DataError>([&] { Shader(context(), vertex_, fragment); });
  }

  // What a compute shader writes into out[].
  template <std::size_t N>
  std::array<float, N> run(ComputeShader& shader) {
    Buffer out(context(), N * sizeof(float), Buffer::Use::fixed, "out");
    out.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    shader.dispatch(1, 1, 1);
    api().MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    std::array<float, N> values{};
    out.read(0, std::as_writable_bytes(std::span(values)));
    return values;
  }

  void touchLater(const std::string& file) {
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(2));
  }
};

constexpr const char* kOut =
    "layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer Out { float o[]; };\n";

TEST_F(ShaderGLTest, compileErrorNamesFileAndLine) {
  // The fault stands on line 3 of the fragment shader itself.
  const std::string file = folder_.write("broken.frag", "out vec4 c;\nvoid main() {\n  c = undeclared;\n}\n");
  EXPECT_THAT(errorOf(file), AllOf(HasSubstr("broken.frag: line 3:"), HasSubstr("undeclared")));
}

TEST_F(ShaderGLTest, compileErrorInsideAnIncludeNamesTheIncludedFile) {
  // The fault stands on line 2 of the second include; the lines around it must not shift the place.
  folder_.write("good.glsl", "float twice(float x) {\n  return 2.0 * x;\n}\n");
  folder_.write("bad.glsl", "// a comment\nfloat thrice(float x) { return 3.0 * y; }\n");
  const std::string file = folder_.write(
      "main.frag",
      "#include \"good.glsl\"\n#include \"bad.glsl\"\nout vec4 c;\nvoid main() { c = vec4(thrice(1.0)); }\n");
  EXPECT_THAT(errorOf(file), HasSubstr("bad.glsl: line 2:"));
}

TEST_F(ShaderGLTest, compileErrorAfterAnIncludeNamesTheIncludingFile) {
  // The fault stands behind a splice: the place is counted in the file the user sees.
  folder_.write("good.glsl", "float twice(float x) {\n  return 2.0 * x;\n}\n");
  const std::string file =
      folder_.write("main.frag", "#include \"good.glsl\"\nout vec4 c;\nvoid main() { c = twice; }\n");
  EXPECT_THAT(errorOf(file), HasSubstr("main.frag: line 3:"));
}

TEST_F(ShaderGLTest, linkErrorNamesTheFiles) {
  // Two stages that do not fit: the names of both are in the message.
  const std::string file =
      folder_.write("unfed.frag", "in vec3 missing;\nout vec4 c;\nvoid main() { c = vec4(missing, 1); }\n");
  EXPECT_THAT(errorOf(file), AllOf(HasSubstr("plain.vert"), HasSubstr("unfed.frag"), HasSubstr("link")));
}

TEST_F(ShaderGLTest, missingFileAndMissingIncludeAreNamed) {
  // Neither passes in silence; the include is reported at the line that asks for it.
  EXPECT_THAT(errorOf((folder_.path() / "absent.frag").string()), HasSubstr("absent.frag"));
  const std::string file = folder_.write("main.frag", "\n#include \"absent.glsl\"\nvoid main() {}\n");
  EXPECT_THAT(errorOf(file), AllOf(HasSubstr("main.frag: line 2:"), HasSubstr("absent.glsl")));
}

TEST_F(ShaderGLTest, failedProgramsLeaveNothingBehind) {
  // Whatever fails, the resource tracker is where it was.
  errorOf(folder_.write("broken.frag", "nonsense"));
  errorOf(
      folder_.write("unfed.frag", "in vec3 missing;\nout vec4 c;\nvoid main() { c = vec4(missing, 1); }\n"));
  EXPECT_EQ(context().resources().liveObjects(), 0);
}

TEST_F(ShaderGLTest, eachFileIsIncludedOnce) {
  // A file that two includes ask for would be defined twice.
  folder_.write("base.glsl", "float one() { return 1.0; }\n");
  folder_.write("a.glsl", "#include \"base.glsl\"\nfloat a() { return one(); }\n");
  folder_.write("b.glsl", "  #  include \"base.glsl\"\nfloat b() { return 2.0 * one(); }\n");
  ComputeShader shader(
      context(), folder_.write("main.comp", std::string("#include \"a.glsl\"\n#include \"b.glsl\"\n") + kOut +
                                                "void main() { o[0] = a() + b(); }\n"));
  EXPECT_EQ(run<1>(shader)[0], 3.0f);
}

TEST_F(ShaderGLTest, uniformsOfEveryTypeArrive) {
  // One interface for both kinds of program; what is set is what the shader reads.
  ComputeShader shader(context(), folder_.write("main.comp", std::string(kOut) + R"(
uniform bool b; uniform int i; uniform uint u; uniform float f; uniform vec2 v2; uniform vec3 v3; uniform vec4 v4;
uniform ivec2 i2; uniform mat3 m3; uniform mat4 m4; uniform float fs[2]; uniform vec4 vs[2];
void main() {
  o[0] = float(b); o[1] = float(i); o[2] = float(u); o[3] = f; o[4] = v2.y; o[5] = v3.z; o[6] = v4.w;
  o[7] = float(i2.y); o[8] = m3[2][1]; o[9] = m4[3][1]; o[10] = fs[1]; o[11] = vs[1].z;
})"));
  glm::mat3 m3(0);
  m3[2][1] = 9;
  glm::mat4 m4(0);
  m4[3][1] = 10;
  shader.setBool("b", true);
  shader.setInt("i", -2);
  shader.setUint("u", 3);
  shader.setFloat("f", 4.5f);
  shader.setVec2("v2", {0, 5});
  shader.setVec3("v3", {0, 0, 6});
  shader.setVec4("v4", {0, 0, 0, 7});
  shader.setIvec2("i2", {0, 8});
  shader.setMatrix("m3", m3);
  shader.setMatrix("m4", m4);
  shader.setFloats("fs", std::array{0.0f, 11.0f});
  shader.setVec4s("vs", std::array{glm::vec4(0), glm::vec4(0, 0, 12, 0)});
  EXPECT_EQ((run<12>(shader)), (std::array<float, 12>{1, -2, 3, 4.5, 5, 6, 7, 8, 9, 10, 11, 12}));
}

TEST_F(ShaderGLTest, unknownUniformIsCountedAndOptimisedAwayIsNot) {
  // A name that stands in the source is legal even where a variant leaves it out; a misspelt one is an error.
  ComputeShader shader(context(), folder_.write("main.comp", std::string(kOut) + R"(
uniform float used; uniform float unused;
#ifdef FOG
uniform float fogDensity;
#endif
void main() { o[0] = used; })"));
  shader.setFloat("used", 1);
  shader.setFloat("unused", 1);
  shader.setFloat("fogDensity", 1);
  EXPECT_EQ(context().resources().unknownUniforms(), 0u);
  std::string why;
  const auto other = test::openForTest(context().backend(), why);
  ASSERT_TRUE(other);
  {
    ComputeShader theirs(*other, (folder_.path() / "main.comp").string());
    theirs.setFloat("usd", 1);
    EXPECT_EQ(other->resources().unknownUniforms(), 1u);
    EXPECT_THAT(other->resources().lastUnknownUniform(), HasSubstr("usd"));
  }
  context().makeCurrent();
}

TEST_F(ShaderGLTest, cacheCompilesEachVariantOnce) {
  // One program for each set of defines; asking again gives the same one.
  ShaderCache cache(context());
  const std::string file = folder_.write("main.comp", std::string(kOut) + R"(
void main() {
#if FOG
  o[0] = float(STEPS);
#else
  o[0] = -1.0;
#endif
})");
  const std::vector<std::string> defines{"FOG", "STEPS 64"};
  ComputeShader& plain = cache.computeShader(file);
  ComputeShader& fog = cache.computeShader(file, defines);
  EXPECT_EQ(&fog, &cache.computeShader(file, defines));
  EXPECT_EQ(&plain, &cache.computeShader(file));
  EXPECT_EQ(context().resources().live(ObjectKind::program), 2);
  EXPECT_EQ(run<1>(plain)[0], -1.0f);
  EXPECT_EQ(run<1>(fog)[0], 64.0f);
}

TEST_F(ShaderGLTest, whatFailedOnceIsNotCompiledInEachFrame) {
  // The same line again without looking at the file, until the cache is asked to look.
  ShaderCache cache(context());
  const std::string file = folder_.write("main.comp", std::string(kOut) + "void main() { o[0] = }\n");
  const auto ask = [&] { static_cast<void>(cache.computeShader(file)); };
  const std::string refusal = test::refusalOf<core::DataError>(ask);
  EXPECT_THAT(refusal, HasSubstr("main.comp: line"));
  folder_.write("main.comp", std::string(kOut) + "void main() { o[0] = 1.0; }\n");
  EXPECT_EQ(test::refusalOf<core::DataError>(ask), refusal);
  cache.reloadChanged();
  EXPECT_NO_THROW(ask());
}

TEST_F(ShaderGLTest, changedFilesAreReloadedAndBrokenOnesKeepTheLastProgram) {
  // The life of a shader while flying: good, broken (reported once, the old one runs on), mended.
  ShaderCache cache(context());
  folder_.write("value.glsl", "float value() { return 1.0; }\n");
  const std::string file = folder_.write(
      "main.comp", std::string("#include \"value.glsl\"\n") + kOut + "void main() { o[0] = value(); }\n");
  ComputeShader& shader = cache.computeShader(file);
  EXPECT_EQ(cache.reloadChanged().programs, 0);

  touchLater(folder_.write("value.glsl", "float value() { return 2.0 }\n"));
  const ShaderCache::Reloaded broken = cache.reloadChanged();
  EXPECT_EQ(broken.programs, 0);
  ASSERT_EQ(broken.errors.size(), 1u);
  EXPECT_THAT(broken.errors[0], HasSubstr("value.glsl: line 1:"));
  EXPECT_EQ(run<1>(shader)[0], 1.0f);
  EXPECT_TRUE(cache.reloadChanged().errors.empty());
  EXPECT_EQ(cache.standingError(), broken.errors[0]) << "it stands, though it is reported once";

  folder_.write("value.glsl", "float value() { return 3.0; }\n");
  EXPECT_EQ(cache.reloadChanged().programs, 1);
  EXPECT_EQ(cache.standingError(), "");
  EXPECT_EQ(run<1>(shader)[0], 3.0f);
  EXPECT_EQ(context().resources().live(ObjectKind::program), 1);
}

}  // namespace
}  // namespace skydrop::render::gl
