// The checks that a machine with a graphics card is borrowed for, as one program: tests, golden scenes,
// passes at the sizes of real screens, accuracy. tests/device/check.sh starts it inside a bundle.
//   device_check OUT [--quick]     --quick: small pictures and few frames, to try the check itself
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <future>
#include <glm/trigonometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/measure/system_info.h"
#include "app/studies/measured_game.h"
#include "app/types/version.h"
#include "device/device_report.h"
#include "skydrop/core/file.h"
#include "skydrop/core/quantile.h"
#include "skydrop/render/frame/camera.h"
#include "support/paths.h"
#include "support/process.h"

namespace skydrop::device {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kAllS = 480;  // of the whole check
constexpr double kCloudsPromiseMs = 1.5;
constexpr double kSkyPromiseMs = 0.3;
constexpr double kAccuracyS = 120;
constexpr int kMostShares = 6;  // of a suite, side by side

class DeviceCheck {
 public:
  DeviceCheck(std::filesystem::path folder, bool quick) : folder_(std::move(folder)), quick_(quick) {}

  bool run() {
    describeMachine();
    for (const app::Size size : sizes()) passes(size);
    suite("gl_tests",
          quick_ ? "GLTest.*:TerrainGLTest.T02*"
                 : "-*EffectGLTest.*:EffectSetGLTest.*:ShaderVariantsGLTest.*:CostStudyGLTest.*",
          120);
    suite("golden_tests", quick_ ? "*GoldenFrame*empty" : "*GoldenFrame*", 90);
    keepPictures();
    accuracy();
    keep();
    return report_.isGood();
  }

 private:
  std::vector<app::Size> sizes() const {
    if (quick_) return {{160, 90}};
    return {{1920, 1080}, {3840, 2160}};
  }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
  void keep() {
    report_.seconds = seconds();
    write(report_, folder_);
  }
  // Whether there is time for a part; notes it where there is not.
  bool hasTimeFor(const std::string& part, double atMostS) {
    if (seconds() + atMostS <= kAllS) return true;
    report_.leftOut.push_back(part);
    return false;
  }
  void tell(const std::string& line) const { std::fprintf(stderr, "%4.0f s  %s\n", seconds(), line.c_str()); }

  void describeMachine() {
    const auto context = render::gl::openHeadless(render::gl::Backend::egl);
    report_.version = app::kVersion;
    report_.vendor = context->vendor();
    report_.renderer = context->renderer();
    report_.openGl = context->version();
    report_.isSoftware = context->isSoftware();
    report_.processor = app::machineName();
    tell(report_.renderer);
    keep();
  }

  // The scene from a place, with a frame's worth of everything that a flight does.
  Passes measured(const std::string& scene, const std::string& variant, app::Size size) {
    Passes row{.scene = scene, .variant = variant, .width = size.width, .height = size.height};
    row.frames = quick_ ? 3 : 60;
    try {
      std::vector<std::string> set = {"view.hud=false"};
      if (!variant.empty()) set.push_back(variant);
      app::MeasuredGame game({scene, size, set});
      app::Sight sight = game.sight();
      render::Camera camera;
      camera.setMode(render::CameraMode::free);
      camera.setPose(sight.snapshot.aircraft.position + glm::dvec3(0, 300, 0), glm::radians(40.0),
                     glm::radians(12.0), 0);
      sight.view = camera.view(sight.snapshot, {}, size.width, size.height);
      game.show(sight);
      std::vector<double> frames;
      for (int i = 0; i < row.frames; ++i) frames.push_back(game.frame());
      row.frameMs = core::quantileOf(frames, 0.5);
      row.frameP99Ms = core::quantileOf(frames, 0.99);
      game.setMeasuring(true);
      std::map<std::string, std::vector<double>> times;
      for (int i = 0; i < row.frames; ++i) {
        game.frame();
        const core::FrameStatistics statistics = game.statistics();
        row.clock = statistics.clock;
        row.gpuMiB = static_cast<double>(statistics.gl.bytes) / (1 << 20);
        for (const auto& [name, pass] : statistics.passes)
          if (pass.skipped.empty()) times[name].push_back(pass.ms);
      }
      for (auto& [name, values] : times) row.ms[name] = core::quantileOf(values, 0.5);
    } catch (const std::exception& error) {
      row.error = error.what();
    }
    return row;
  }

  void passes(app::Size size) {
    const std::vector<std::pair<std::string, std::string>> kinds = {{"terrain", ""},
                                                                    {"fair", "clouds.tier=low"},
                                                                    {"fair", "clouds.tier=medium"},
                                                                    {"fair", "clouds.tier=high"},
                                                                    {"fair", "clouds.tier=ultra"},
                                                                    {"overcast", ""},
                                                                    {"plane3", ""},
                                                                    {"dome", ""},
                                                                    {"valleyFog", ""},
                                                                    {"stress", ""}};
    for (const auto& [scene, variant] : kinds) {
      const std::string part =
          scene + ' ' + variant + " at " + std::to_string(size.width) + "x" + std::to_string(size.height);
      if (!hasTimeFor(part, 20)) continue;
      tell(part);
      report_.passes.push_back(measured(scene, variant, size));
      const Passes& row = report_.passes.back();
      if (variant == "clouds.tier=high" && size.width == 1920 && row.ms.contains("clouds"))
        report_.promises.push_back(
            {"clouds of the tier high at 1920 x 1080", kCloudsPromiseMs, row.ms.at("clouds")});
      if (scene == "terrain" && size.width == 1920 && row.ms.contains("sky"))
        report_.promises.push_back({"sky at 1920 x 1080", kSkyPromiseMs, row.ms.at("sky")});
      keep();
    }
  }

  // A binary of the test suite, in shares that run side by side (whatever is timed was timed before), each a
  // program of its own: a crash there is a failure here, and no more.
  void suite(const std::string& name, const std::string& filter, double atMostS) {
    if (!hasTimeFor(name, atMostS)) return;
    const int shares =
        quick_ ? 1 : std::clamp(static_cast<int>(std::thread::hardware_concurrency()) / 2, 1, kMostShares);
    tell(name + " in " + std::to_string(shares) + (shares == 1 ? " share" : " shares"));
    Suite suite{.name = name};
    const double begin = seconds();
    std::vector<std::future<test::ProcessResult>> running;
    for (int share = 0; share < shares; ++share) {
      const std::vector<std::string> words = {
          (std::filesystem::path(test::binaryDir()) / "tests" / name).string(), "--gtest_brief=1",
          "--gtest_filter=" + filter, "--gtest_output=json:" + resultsOf(name, share).string()};
      const std::vector<std::string> environment = {
          "SKYDROP_TEST_BACKEND=egl", "SKYDROP_TEST_DRIVER=any", "SKYDROP_GOLDEN_LIMITS=loose",
          "GTEST_TOTAL_SHARDS=" + std::to_string(shares), "GTEST_SHARD_INDEX=" + std::to_string(share)};
      running.push_back(
          std::async(std::launch::async, [=] { return test::runProcess(words, environment, atMostS); }));
    }
    std::string log;
    for (int share = 0; share < shares; ++share) {
      const test::ProcessResult ran = running[static_cast<std::size_t>(share)].get();
      log += ran.out + ran.err;
      try {
        read(suite, core::readTextFile(resultsOf(name, share)));
      } catch (const std::exception& error) {
        suite.error = ran.exitCode < 0
                          ? "ended by a signal or after " + std::to_string(static_cast<int>(atMostS)) + " s"
                          : error.what();
      }
      std::filesystem::remove(resultsOf(name, share));
    }
    suite.seconds = seconds() - begin;
    core::writeFileAtomically(folder_ / (name + ".log"), log);
    report_.suites.push_back(suite);
    keep();
  }
  std::filesystem::path resultsOf(const std::string& name, int share) const {
    return folder_ / (name + '.' + std::to_string(share) + ".json");
  }

  // What the golden scenes looked like where they differ, before the folder of the programs goes.
  void keepPictures() const {
    const std::filesystem::path pictures = std::filesystem::path(test::binaryDir()) / "artifacts";
    if (std::filesystem::exists(pictures))
      std::filesystem::copy(
          pictures, folder_ / "pictures",
          std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
  }

  static void read(Suite& suite, const std::string& text) {
    const nlohmann::json results = nlohmann::json::parse(text);
    for (const auto& group : results.at("testsuites")) {
      for (const auto& test : group.at("testsuite")) {
        if (test.at("status") != "RUN") continue;
        ++suite.tests;
        if (test.at("result") == "SKIPPED") ++suite.skipped;
        if (!test.contains("failures")) continue;
        ++suite.failed;
        suite.failures.push_back(group.at("name").get<std::string>() + '.' +
                                 test.at("name").get<std::string>());
      }
    }
  }

  // Studies at the size of a screen, timed by the driver's queries.
  void accuracy() {
    if (quick_ || !hasTimeFor("accuracy studies", kAccuracyS)) return;
    tell("accuracy studies");
    const std::filesystem::path folder = folder_ / "accuracy";
    const test::ProcessResult ran =
        test::runProcess({test::programFile(), "accuracy", "clouds-tiers", "land-lod", "--quick", "--size",
                          "1920x1080", "--out", folder.string()},
                         {}, kAccuracyS);
    if (ran.exitCode == 0)
      report_.accuracy = "accuracy/accuracy.html";
    else
      report_.suites.push_back(
          {.name = "accuracy studies", .error = ran.exitCode < 0 ? "took too long" : ran.err});
  }

  std::filesystem::path folder_;
  bool quick_;
  Clock::time_point begin_ = Clock::now();
  Report report_;
};

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "";
  const bool quick = argc > 2 && std::string_view(argv[2]) == "--quick";
  if (folder.empty() || folder.starts_with('-') || argc > (quick ? 3 : 2)) {
    std::fprintf(stderr, "usage: device_check OUT [--quick]\n");
    return 2;
  }
  try {
    std::filesystem::create_directories(folder);
    const bool good = DeviceCheck(std::filesystem::absolute(folder), quick).run();
    std::printf("%s\n", (std::filesystem::path(folder) / "device.md").c_str());
    return good ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "device_check: %s\n", error.what());
    return 1;
  }
}

}  // namespace
}  // namespace skydrop::device

int main(int argc, char** argv) { return skydrop::device::main(argc, argv); }
