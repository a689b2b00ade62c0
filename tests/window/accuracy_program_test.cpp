// `skydrop accuracy` and its report as their users run them.
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "skydrop/core/image.h"
#include "support/background_process.h"
#include "support/paths.h"
#include "support/process.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

namespace fs = std::filesystem;

const char* const kMotion = R"({"schema": 1, "title": "Motion <b>", "method": "A body.", "subject": "motion",
 "set": {"seconds": 2}, "cases": [{"name": "tumbling"}, {"name": "thrown", "set": {"body": "projectile"}}],
 "axes": [{"path": "integrator", "values": ["semiImplicitEuler", "rk4"]}, {"path": "rateHz", "values": [30, 60]}],
 "reference": {"integrator": "rkmk4", "rateHz": 3840}, "check": {"rateHz": 7680},
 "metrics": [{"name": "degrees", "floor": 1e-9}, {"name": "metres", "floor": 1e-9}], "timed": "cpu",
 "order": "rateHz", "shipped": [{"name": "default", "set": {"integrator": "rk4", "rateHz": 60}}]})";
const char* const kPicture = R"({"schema": 1, "title": "Haze", "method": "A sky.", "subject": "picture",
 "scene": "SCENE", "cases": [{"name": "up", "pose": [0, 400, 0, 0, 30, 0]}, {"name": "level", "pose": [0, 400, 0, 0, 5, 0]}],
 "axes": [{"path": "render.atmosphere.visibilityM", "values": [20000, 40000, 70000]}],
 "reference": {"render.atmosphere.visibilityM": 100000}, "check": {"render.atmosphere.visibilityM": 100001},
 "metrics": ["relativeRmse", "flip"], "timed": "frame",
 "shipped": [{"name": "default", "set": {"render.atmosphere.visibilityM": 70000}}]})";

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool isOneLine(const ProcessResult& result) {
  return !result.err.empty() && result.err.find('\n') == result.err.size() - 1;
}

// What does not depend on the machine: everything of the report but times, fronts and clocks.
nlohmann::json errorsOf(const fs::path& folder) {
  nlohmann::json report = nlohmann::json::parse(contentOf(folder / "accuracy.json")), errors;
  for (const auto& of : report["studies"]) {
    for (const auto& point : of["points"])
      errors.push_back(
          {of["study"], of["case"], point["label"], point["errors"], point.value("picture", "")});
    for (const auto& reference : of["references"]) errors.push_back(reference["changes"]);
  }
  return errors;
}

class AccuracyProgram : public testing::Test {
 protected:
  std::vector<std::string> words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> all = {"accuracy", motion_, picture_, "--quick",
                                    "--size",   "32x18", "--out",  at(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::string at(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
  std::string pictureText() const {
    std::string text = kPicture;
    const std::string scene = folder_.write("air.json", R"({"schema": 1, "effects": ["sky", "haze"]})");
    return text.replace(text.find("SCENE"), 5, scene);
  }
  std::string motion_ = folder_.write("motion.json", kMotion),
              picture_ = folder_.write("haze.json", pictureText());
};

TEST_F(AccuracyProgram, sharesMergeToTheSingleRun) {
  // Errors and pictures bit for bit, whichever machine measured which share.
  ASSERT_EQ(runSkydrop(words("whole")).exitCode, 0) << runSkydrop(words("whole2")).err;
  for (const char* part : {"1/3", "2/3", "3/3"})
    ASSERT_EQ(runSkydrop(words(std::string("share") + part[0], {"--part", part})).exitCode, 0);
  const ProcessResult merge =
      runSkydrop({"accuracy", "--merge", at("share3"), at("share1"), at("share2"), "--out", at("merged")});
  ASSERT_EQ(merge.exitCode, 0) << merge.err;
  EXPECT_EQ(errorsOf(at("merged")), errorsOf(at("whole")));
  EXPECT_EQ(errorsOf(at("whole")).size(), 2u * (4 + 1) + 2 * (3 + 1));
  int pictures = 0;
  for (const auto& entry : fs::directory_iterator(at("whole") + "/pictures")) {
    EXPECT_EQ(contentOf(entry.path()),
              contentOf(fs::path(at("merged")) / "pictures" / entry.path().filename()));
    ++pictures;
  }
  EXPECT_EQ(pictures, 2 * (1 + 2 * 3));
  // A share that is missing is said.
  const ProcessResult some = runSkydrop({"accuracy", "--merge", at("share1"), "--out", at("some")});
  EXPECT_EQ(some.exitCode, 0);
  EXPECT_NE(some.err.find("2 of 4 cases are in none of the folders"), std::string::npos) << some.err;
}

TEST_F(AccuracyProgram, goesOnAfterItWasKilled) {
  // Killed while it measures, it has kept what it had; --resume ends with the errors of a run at one go.
  ASSERT_EQ(runSkydrop(words("whole")).exitCode, 0);
  const fs::path results = fs::path(at("cut")) / "results.jsonl";
  const auto words1 = words("cut");
  std::vector<std::string> command = {programFile()};
  command.insert(command.end(), words1.begin(), words1.end());
  {
    BackgroundProcess process(command, {"XDG_CACHE_HOME=" + sharedCacheHome().string()}, at("log"));
    while (process.isRunning() && contentOf(results).find("\"line\":\"error\"") == std::string::npos) {
    }
    process.send(SIGKILL);
    process.wait(10);
  }
  ASSERT_FALSE(fs::exists(fs::path(at("cut")) / "accuracy.json")) << "it had ended before it was killed";
  const ProcessResult refused = runSkydrop(words("cut"));
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_NE(refused.err.find("--resume goes on with them"), std::string::npos) << refused.err;
  // Half a line at the end, as a crash of the system leaves it.
  std::ofstream(results, std::ios::app) << "{\"line\":\"err";
  const ProcessResult resumed = runSkydrop(words("cut", {"--resume"}));
  EXPECT_EQ(resumed.exitCode, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("the last line was cut off"), std::string::npos) << resumed.err;
  EXPECT_EQ(errorsOf(at("cut")), errorsOf(at("whole")));
}

TEST_F(AccuracyProgram, theHardCasesArePrintedAndTheirPagesWritten) {
  // Every live check keeps its limit here and now, every row of the list is there; pages go into a folder,
  // and what does not belong to it is refused.
  const ProcessResult table = runSkydrop({"accuracy", "stability"});
  EXPECT_EQ(table.exitCode, 0) << table.err;
  EXPECT_EQ(table.out.rfind("Measured now by skydrop ", 0), 0u);
  const auto cases =
      nlohmann::json::parse(contentOf(fs::path(sourceDir()) / "tests/stability/cases.json"))["cases"];
  const std::string recorded = table.out.substr(table.out.find("Recorded by the suite"));
  for (const auto& row : cases)
    EXPECT_NE(recorded.find("\n" + row["id"].get<std::string>() + " "), std::string::npos) << row["id"];
  const ProcessResult pages = runSkydrop({"accuracy", "stability", "--out", at("report")});
  EXPECT_EQ(pages.exitCode, 0) << pages.err;
  EXPECT_NE(contentOf(fs::path(at("report")) / "hard-cases.html").find("Measured now"), std::string::npos);
  EXPECT_EQ(contentOf(fs::path(at("report")) / "hard-cases.md").rfind("# Hard cases", 0), 0u);
  const auto json = nlohmann::json::parse(contentOf(fs::path(at("report")) / "hard-cases.json"));
  EXPECT_GE(json["now"]["checks"].size(), 20u);
  EXPECT_EQ(json["recorded"]["cases"].size(), cases.size());
  for (const char* other : {"cost", "clouds-tiers", "--quick", "--resume"})
    EXPECT_EQ(runSkydrop({"accuracy", "stability", other}).exitCode, 2) << other;
}

TEST_F(AccuracyProgram, badInputIsOneLineAndLosesNothing) {
  const auto changed = [&](const std::string& name, const std::string& what, const std::string& with) {
    std::string text = kMotion;
    return folder_.write(name, text.replace(text.find(what), what.size(), with));
  };
  const std::string file = folder_.write("file", "");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{changed("path.json", "\"seconds\"", "\"second\"")},
       "path.json: 'semiImplicitEuler, 30': unknown setting 'second'"},
      {{changed("value.json", "[30, 60]", "[1, 60]")}, "rateHz: '1' is out of range 10 to 1e+06 Hz"},
      {{changed("same.json", "\"rateHz\": 3840", "\"integrator\": \"rk4\", \"rateHz\": 60")}, "same.json"},
      {{motion_, "--out", "/proc/no"}, "/proc/no: cannot make the folder"},
      {{motion_, "--out", file}, file + ": cannot make the folder"},
      {{at("none.json")}, "none.json"}};
  for (const auto& [study, line] : wrong) {
    std::vector<std::string> all = {"accuracy"};
    if (study.size() == 1) all.insert(all.end(), {"--out", at("bad")});
    all.insert(all.end(), study.begin(), study.end());
    const ProcessResult result = runSkydrop(all);
    EXPECT_EQ(result.exitCode, 1) << line;
    EXPECT_TRUE(isOneLine(result)) << result.err;
    EXPECT_NE(result.err.find(line), std::string::npos) << result.err;
    EXPECT_FALSE(fs::exists(at("bad"))) << "something was measured";
  }
  EXPECT_EQ(runSkydrop({"accuracy", "no-study", "--out", at("bad")}).exitCode, 2);
  EXPECT_EQ(runSkydrop({"accuracy", "cost", motion_}).exitCode, 2);

  // A damaged line: refused by its number, and the file stays as it is.
  const fs::path folder = at("damaged");
  fs::create_directory(folder);
  const std::string damaged = "{\"line\":\"head\",\"schema\":1}\nrubbish\n";
  std::ofstream(folder / "results.jsonl") << damaged;
  const ProcessResult result = runSkydrop(words("damaged", {"--resume"}));
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_TRUE(isOneLine(result)) << result.err;
  EXPECT_NE(result.err.find("results.jsonl: line 1"), std::string::npos) << result.err;
  EXPECT_EQ(contentOf(folder / "results.jsonl"), damaged);
}

TEST_F(AccuracyProgram, framesOfARangeAreThoseOfTheWholeSequence) {
  const auto render = [&](const std::string& frames, const std::string& name) {
    return runSkydrop({"render", "--scene", "empty", "--size", "32x18", "--fps", "10", "--frames", frames,
                       "--out", at(name + "-%d.png")});
  };
  ASSERT_EQ(render("4", "all").exitCode, 0);
  ASSERT_EQ(render("2..3", "part").exitCode, 0);
  EXPECT_FALSE(fs::exists(at("part-1.png")));
  for (const char* frame : {"2", "3"})
    EXPECT_EQ(contentOf(at(std::string("part-") + frame + ".png")),
              contentOf(at(std::string("all-") + frame + ".png")));
}

TEST_F(AccuracyProgram, theExampleForSnakemakeRunsWithTwoJobs) {
  const std::optional<std::string> snakemake = findProgram("snakemake");
  if (!snakemake) GTEST_SKIP() << "snakemake is not installed (install_dependencies.sh)";
  ASSERT_EQ(runSkydrop(words("whole")).exitCode, 0);
  const std::string studies = motion_ + " " + picture_;
  const ProcessResult result = runProcess(
      {*snakemake, "--snakefile", (fs::path(sourceDir()) / "docs/examples/Snakefile").string(), "--directory",
       at("matrix"), "--jobs", "2", "--nolock", "--config", "skydrop=" + programFile(), "studies=" + studies,
       "parts=2", "flags=--quick --size 32x18", "scene=empty", "size=32x18", "frames=5", "perJob=3"},
      {"XDG_CACHE_HOME=" + sharedCacheHome().string(), "HOME=" + folder_.path().string()}, 120);
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_EQ(errorsOf(at("matrix/report")), errorsOf(at("whole")));
  for (int frame = 0; frame < 5; ++frame)
    EXPECT_TRUE(fs::exists(at("matrix/frames/" + std::to_string(frame) + ".png"))) << frame;
}

// What headless Chromium makes of a page: its document after the scripts.
class Browser {
 public:
  static std::optional<std::string> program() {
    for (const char* name : {"chromium", "chromium-browser"}) {
      if (const auto found = findProgram(name)) return found;
    }
    return std::nullopt;
  }
  static ProcessResult open(const std::string& page, const fs::path& profile, const std::string& what) {
    return runProcess({*program(), "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                       "--user-data-dir=" + profile.string(), "--window-size=1200,1600",
                       "--virtual-time-budget=4000", what, "file://" + page},
                      {"HOME=" + profile.string()}, 60);
  }
};

TEST_F(AccuracyProgram, thePageWorksInABrowser) {
  // Plots, tables and pictures are there without a network; a click on a head sorts, one on a row shows its
  // picture, the slider moves the divider, and text of a study is text and no markup.
  if (!Browser::program()) GTEST_SKIP() << "chromium is not installed (install_dependencies.sh)";
  ASSERT_EQ(runSkydrop(words("report")).exitCode, 0);
  std::string page = contentOf(at("report/accuracy.html"));
  const std::string kNamespace = "http://www.w3.org/2000/svg";
  std::string rest = page;
  rest.erase(rest.find(kNamespace), kNamespace.size());
  EXPECT_EQ(rest.find("http"), std::string::npos) << "the page names an address";
  page += R"(<script>(async () => {
    const last = [...document.querySelectorAll('.case')].at(-1);
    const labels = () => [...last.querySelectorAll('tbody tr td:first-child')].map(cell => cell.textContent).join(' ');
    const head = last.querySelectorAll('th button')[2];
    head.click(); const up = labels(); head.click(); const down = labels();
    last.querySelector('circle.ring').previousSibling.dispatchEvent(new Event('click'));
    const slider = last.querySelector('input[type=range]'); slider.value = 25; slider.dispatchEvent(new Event('input'));
    const images = [...last.querySelectorAll('img')];
    await Promise.all(images.map(image => image.decode()));
    const facts = {up, down, points: document.querySelectorAll('circle.point').length,
      rings: document.querySelectorAll('circle.ring').length, fronts: document.querySelectorAll('path.front').length,
      sections: document.querySelectorAll('section').length, bold: document.querySelectorAll('b').length,
      chosen: last.querySelectorAll('tr.chosen').length, images: images.length,
      loaded: images.every(image => image.complete && image.naturalWidth === 32),
      divider: last.querySelector('.divider').style.left, ready: document.body.dataset.ready};
    document.title = 'FACTS' + JSON.stringify(facts) + 'END';
  })();</script>)";
  const std::string tested = folder_.write("tested.html", page);
  const ProcessResult result = Browser::open(tested, folder_.path(), "--dump-dom");
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const std::size_t begin = result.out.find("<title>FACTS"), end = result.out.find("END</title>");
  ASSERT_NE(begin, std::string::npos) << result.out.substr(0, 2000) << result.err;
  const auto facts = nlohmann::json::parse(result.out.substr(begin + 12, end - begin - 12));
  EXPECT_EQ(facts["ready"], "true");
  EXPECT_EQ(facts["up"], "70000 40000 20000");
  EXPECT_EQ(facts["down"], "20000 40000 70000");
  EXPECT_EQ(facts["points"], 2 * 4 + 2 * 3);
  EXPECT_EQ(facts["rings"], 4);
  EXPECT_EQ(facts["sections"], 2);
  EXPECT_EQ(facts["bold"], 0);
  EXPECT_EQ(facts["chosen"], 1);
  EXPECT_EQ(facts["images"], 3);
  EXPECT_TRUE(facts["loaded"]);
  EXPECT_EQ(facts["divider"], "25%");

  // What it draws is not one colour, in light and in dark.
  for (const char* scheme : {"0", "1"}) {
    const std::string shot = at(std::string("page") + scheme + ".png");
    const ProcessResult drawn =
        runProcess({*Browser::program(), "--headless", "--no-sandbox", "--disable-gpu",
                    "--disable-dev-shm-usage", "--user-data-dir=" + folder_.path().string(),
                    "--window-size=1200,1600", std::string("--blink-settings=preferredColorScheme=") + scheme,
                    "--screenshot=" + shot, "file://" + at("report/accuracy.html")},
                   {"HOME=" + folder_.path().string()}, 60);
    ASSERT_TRUE(fs::exists(shot)) << drawn.err;
    const core::Image image = core::readPng(shot);
    const int corner = image.pixel(3, 3)[1];
    EXPECT_EQ(corner > 128, scheme[0] == '1') << "the page does not follow the scheme";
  }
}

}  // namespace
}  // namespace skydrop::test
