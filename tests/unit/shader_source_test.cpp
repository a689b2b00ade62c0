#include "skydrop/render/gl/shader_source.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace skydrop::render::gl {
namespace {

TEST(ShaderSource, errorsOfEveryDriverAreRead) {
  // The forms of Mesa, NVIDIA, and AMD or Intel; warnings before the error are passed over.
  const test::TemporaryFolder folder;
  folder.write("part.glsl", "one\ntwo\n");
  const ShaderSource source(folder.write("main.frag", "first\n#include \"part.glsl\"\nlast\n"), {});
  // Line 1 is #version, 2 "first", 3 and 4 the included file, 5 "last".
  for (const char* log : {"0:4(7): error: what", "0(4) : error: what", "ERROR: 0:4: error: what",
                          "0:2(1): warning: nothing\n0:4(7): error: what\n0:5(1): error: more\n"}) {
    const ShaderSource::Message message = source.firstError(log);
    EXPECT_EQ(message.place.file, "part.glsl") << log;
    EXPECT_EQ(message.place.line, 2) << log;
    EXPECT_EQ(message.text, "error: what") << log;
  }
  EXPECT_EQ(source.place(5).line, 3);
}

TEST(ShaderSource, logsThatAreNotUnderstoodAreKeptWhole) {
  // Whatever a driver says, it is not lost; numbers out of range name the entry file's start.
  const test::TemporaryFolder folder;
  const ShaderSource source(folder.write("main.frag", "void main() {}\n"), {});
  for (const char* log : {"internal error", "", "0:(", "0:99999999999999(1): error: x", "(((", "0(1"}) {
    EXPECT_EQ(source.firstError(log).text, log);
    EXPECT_EQ(source.firstError(log).place.line, 1);
  }
  EXPECT_EQ(source.firstError("0:9999(1): error: far").place.line, 1);
}

TEST(ShaderSource, definesStandBeforeTheFile) {
  // A name alone becomes 1, a name with a value keeps it; neither shifts the lines of the file.
  const test::TemporaryFolder folder;
  const std::vector<std::string> defines = {"HAZE", "STEPS 64"};
  const ShaderSource source(folder.write("main.frag", "a\nb\n"), defines);
  EXPECT_EQ(source.text(), "#version 450 core\n#define HAZE 1\n#define STEPS 64\na\nb\n");
  EXPECT_EQ(source.place(5).line, 2);
}

}  // namespace
}  // namespace skydrop::render::gl
