// Models of others are read by a child process; what becomes of it is one line.
#include "app/session/model_reading.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>
#include <vector>

#include "skydrop/core/assets.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/render/models/model_bytes.h"
#include "support/instrumented.h"
#include "support/mutants.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/refusal.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

namespace fs = std::filesystem;

const fs::path kModels = fs::path(test::sourceDir()) / "tests/corpus/models";

std::string hostileChild() { return test::binaryDir() + "/tests/hostile_child"; }

std::string answerOf(const std::string& does, double wallSeconds = 30) {
  return core::runContained(hostileChild(), {"child", does}, {.wallSeconds = wallSeconds, .cpuSeconds = 1},
                            "a.glb");
}

std::string refusalOfChild(const std::string& does, double wallSeconds = 30) {
  return test::refusalOf<core::DataError>([&] { answerOf(does, wallSeconds); });
}

TEST(ContainedProcess, theAnswerComesBack) { EXPECT_EQ(answerOf("answers"), "an answer"); }

TEST(ContainedProcess, whateverEndsTheChildIsOneLine) {
  for (const auto& [does, reason] :
       std::vector<std::pair<std::string, std::string>>{{"crashes", "a library that reads it failed"},
                                                        {"aborts", "a library that reads it failed"},
                                                        {"throws", "a library that reads it failed"},
                                                        {"fails", "a library that reads it failed (code 7)"},
                                                        {"works", "takes more than 1 s of processor time"},
                                                        {"says nothing", "handed over 0 bytes"},
                                                        {"says too much", "handed over 2147483648 bytes"},
                                                        {"stops halfway", "handed over half a result"},
                                                        {"writes rubbish", "handed over half a result"}}) {
    const std::string line = refusalOfChild(does);
    EXPECT_TRUE(test::isOneLineAbout(line, "a.glb")) << does << ": " << line;
    EXPECT_NE(line.find(reason), std::string::npos) << does << ": " << line;
  }
}

TEST(ContainedProcess, oneThatHangsIsEndedInTime) {
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(refusalOfChild("hangs", 0.3), "a.glb: reading it takes more than 0.3 s");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(ContainedProcess, memoryIsBounded) {
  if (test::kInstrumented)
    GTEST_SKIP() << "a sanitizer's shadow memory goes with no limit of the address space";
  EXPECT_NE(refusalOfChild("eats").find("a library that reads it failed"), std::string::npos);
}

TEST(ContainedProcess, aProgramThatCannotBeStartedIsOneLine) {
  EXPECT_NE(test::refusalOf<core::DataError>([] {
              core::runContained("/nowhere", {"x"}, {}, "a.glb");
            }).find("a.glb: the program that reads it cannot be started: "),
            std::string::npos);
}

TEST(ContainedProcess, severalThreadsHaveAChildEach) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([] {
      for (int k = 0; k < 5; ++k) EXPECT_EQ(answerOf("answers"), "an answer");
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(ModelReading, theShippedModelsAreKnownAndOthersAreNot) {
  for (const char* name : {"airplane.glb", "package.glb", "parachute.glb"}) {
    std::vector<std::byte> content = core::readFile(core::assetPath(std::string("models/") + name));
    EXPECT_TRUE(isShippedModel(content))
        << name << ": kShipped of model_reading.cpp needs 0x" << std::hex << modelDigest(content);
    content[content.size() / 2] ^= std::byte{1};
    EXPECT_FALSE(isShippedModel(content)) << name;
  }
}

TEST(ModelReading, aModelComesBackFromTheChildAsItIsReadHere) {
  const fs::path program = test::programFile();
  std::vector<fs::path> files = {core::assetPath("models/airplane.glb"),
                                 core::assetPath("models/parachute.glb")};
  for (const char* name : {"goodSquare.obj", "goodMirrored.glb", "goodPercentEncoded.gltf"})
    files.push_back(kModels / name);
  for (const fs::path& file : files) {
    EXPECT_EQ(render::bytesOf(readModelApart(file, program)), render::bytesOf(render::importModel(file)))
        << file;
  }
}

TEST(ModelReading, aRefusalComesBackAsItIsMadeHere) {
  const fs::path program = test::programFile();
  for (const char* name : {"badDraco.glb", "badIndexZero.obj", "badShortBuffer.gltf", "there: is none.glb"}) {
    const std::string here = test::refusalOf<core::DataError>([&] { render::importModel(kModels / name); });
    EXPECT_NE(here, "");
    EXPECT_EQ(test::refusalOf<core::DataError>([&] { readModelApart(kModels / name, program); }), here);
  }
}

TEST(ModelReading, theProgramIsFoundUnderAnOddPath) {
  // With spaces, a percent sign, a line end and a name that is not UTF-8; and once it has been replaced.
  const test::TemporaryFolder folder;
  const fs::path odd = folder.path() / "a b%d\n\xff.exe (deleted)";
  fs::create_hard_link(hostileChild(), odd);
  EXPECT_EQ(core::runContained(odd, {"x", "answers"}, {}, "a.glb"), "an answer");
  EXPECT_EQ(core::runningProgram(), "/proc/self/exe");
}

// What the parent gets is judged as anything else: damaged, it is a model of sound parts, or refused.
TEST(ModelReading, damagedAnswersAreRefusedOrSound) {
  const std::string good = render::bytesOf(render::importModel(kModels / "goodMirrored.glb"));
  int refused = 0;
  test::forEachMutant(good, test::repetitions(4000), [&](const std::string& mutant) {
    try {
      const render::ModelData model = render::modelOf(mutant, "a.glb");
      for (const render::ModelMesh& mesh : model.meshes) {
        for (const std::uint32_t index : mesh.data.indices) ASSERT_LT(index, mesh.data.vertices.size());
        for (const render::MeshVertex& vertex : mesh.data.vertices)
          ASSERT_TRUE(std::isfinite(vertex.position.x));
      }
    } catch (const core::DataError& error) {
      ASSERT_TRUE(test::isOneLineAbout(error.what(), "a.glb")) << error.what();
      ++refused;
    }
  });
  EXPECT_GT(refused, test::repetitions(1000));
}

}  // namespace
}  // namespace skydrop::app
