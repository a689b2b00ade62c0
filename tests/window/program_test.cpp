// The program as a process: exit codes, and one clear line for everything that is wrong.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/paths.h"
#include "support/process.h"
#include "support/shared_noise.h"
#include "support/temporary_folder.h"

namespace skydrop::test {
namespace {

// One line that starts with the program's name.
testing::AssertionResult isOneLine(const ProcessResult& result) {
  const auto lines = std::count(result.err.begin(), result.err.end(), '\n');
  if (lines == 1 && result.err.starts_with("skydrop: ")) return testing::AssertionSuccess();
  return testing::AssertionFailure() << lines << " lines: " << result.err;
}

TEST(Program, usageErrorsExitWithTwoAndOneLine) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "a.png").string(), dds = (folder.path() / "a.dds").string();
  const std::vector<std::vector<std::string>> wrong = {
      {"--fast"},
      {"dance"},
      {"render", "--out", out, "--size", "0x0"},
      {"render", "--out", out, "--pose", "1,2"},
      {"render", "--out", out, "--pose", "0,200000,0,0,0,0"},
      {"render", "--out", out, "--heading", "90"},
      {"render", "--out", out, "--set", "aircraft.rollFactr=1"},
      {"render", "--out", out, "--set", "aircraft.rollFactor=1e9"},
      {"render", "--out", out, "--set", "aircraft.rollFactor=nan"},
      {"render", "--out", out, "--set", "aircraft.rollFactor"},
      {"render", "--out", out, "--set", "clouds.coverage=2"},
      {"render", "--out", out, "--set", "clouds.tier=best"},
      {"render", "--out", out, "--split", "clouds"},
      {"render", "--out", out, "--split", "sky=reference"},
      {"render", "--out", out, "--split", "clouds=best"},
      {"render", "--out", out, "--split", "land=reference", "--scene", "empty"},
      {"render", "--out", out, "--split", "clouds=ultra", "--set", "clouds.tier=ultra"},
      {"simulate", "--seconds", "many"},
      {"accuracy", "nothing-of-this-name"},
      {"accuracy", "integrators", "--scene", "fair"},
      {"accuracy", "cost", "--resume"},
      {"accuracy", "--merge", "a", "--part", "1/2"},
      {"sky", "--utc", "2023-02-30", "--lat", "0", "--lon", "0"},
      {"sky", "--utc", "2026-01-01", "--lat", "-90.5", "--lon", "0"},
      {"sky", "--utc", "2026-01-01", "--lat", "0"},
      {"weather", "forecast"},
      {"weather", "state", "--at", "0,nan,0"},
      {"weather", "state", "--set", "weather.sites.0.layers.0.cover=1.5"},
      {"simulate", "--scene", "breeze", "--set", "weather.sites.0.layers.0.top=100"},
      {"render", "--out", out, "--set", "sky.utc=2023-02-30"},
      {"render", "--out", out, "--set", "sky.latitude=nan"},
      {"noise", "--format", "bmp"},
      {"noise", "--check", "--noise", out},
      {"noise", "--generate", "2d", "--octaves", "0", "--out", dds},
      {"noise", "--generate", "2d", "--frequency", "0.5", "--out", dds},
      {"noise", "--generate", "3d", "--width", "3", "--out", dds},
      {"noise", "--generate", "2d", "--height", "100000", "--out", dds},
      {"noise", "--generate", "2d", "--density", "-1", "--out", dds},
  };
  for (const auto& words : wrong) {
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, 2) << words.back();
    EXPECT_TRUE(isOneLine(result)) << words.back();
    EXPECT_EQ(result.out, "") << words.back();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "something was written";
}

TEST(Program, badDataExitsWithOneAndNamesTheFile) {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.json", "{\"schema\": 1, ");
  const std::string wrongSetting =
      folder.write("setting.json", R"({"schema": 1, "settings": {"aircraft": {"rollFactor": -7}}})");
  const std::string wrongDate =
      folder.write("date.json", R"({"schema": 1, "settings": {"sky": {"utc": "2023-02-30"}}})");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"simulate", "--scene", broken}, broken},
      {{"simulate", "--scene", wrongSetting}, "aircraft.rollFactor"},
      {{"simulate", "--scene", wrongDate}, "has day 30, but February 2023 has 28 days"},
      {{"simulate", "--scene", "nowhere"}, "nowhere"},
      {{"simulate", "--scene", "/nowhere/a.json"}, "/nowhere/a.json"},
      {{"simulate", "--replay", broken}, broken},
      {{"noise", "--noise", broken}, "magic number"},
      {{"noise", "--noise", "/nowhere/a.dds"}, "/nowhere/a.dds"},
      {{"simulate", "--replay", "/nowhere/a.log"}, "/nowhere/a.log"},
      {{"simulate", "--seconds", "1", "--stats", "/nowhere/s.json"}, "/nowhere/s.json"},
      {{"render", "--scene", "empty", "--out", "/nowhere/a.png"}, "/nowhere/a.png"},
  };
  for (const auto& [words, named] : wrong) {
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, 1) << named;
    EXPECT_TRUE(isOneLine(result)) << named;
    EXPECT_NE(result.err.find(named), std::string::npos) << result.err;
  }
}

TEST(Program, weatherPrintsTheStateOfTheAirAtAPoint) {
  // One JSON object with state, wind, turbulence and cloud density; asked again it is the same; another time
  // has other weather.
  const auto ask = [](const char* time) {
    return runSkydrop({"weather", "state", "--scene", "coldFront", "--time", time, "--at", "0,2000,0"});
  };
  const ProcessResult early = ask("0"), late = ask("900");
  ASSERT_EQ(early.exitCode, 0) << early.err;
  EXPECT_EQ(early.err, "");
  EXPECT_EQ(ask("0").out, early.out);
  const nlohmann::json before = nlohmann::json::parse(early.out), after = nlohmann::json::parse(late.out);
  EXPECT_EQ(before["isFlown"], true);
  EXPECT_EQ(before["siteShare"], 0);
  EXPECT_EQ(after["siteShare"], 1);
  EXPECT_EQ(before["state"]["layers"][0]["genus"], "cumulus");
  EXPECT_EQ(before["state"]["temperatureC"], 14);
  EXPECT_EQ(after["state"]["temperatureC"], 7);
  const nlohmann::json& at = before["at"];
  EXPECT_GT(at["turbulence"]["intensityMps"][2].get<double>(), 0.5);
  EXPECT_NEAR(at["turbulence"]["lengthM"][2].get<double>(), 533.4, 1e-6);
  EXPECT_GE(at["cloudDensity"].get<double>(), 0);
  EXPECT_LE(at["cloudDensity"].get<double>(), 1);
  EXPECT_NEAR(at["air"]["densityKgM3"].get<double>(), 1.0, 0.02);
  const ProcessResult clear = runSkydrop({"weather", "state", "--scene", "terrain"});
  EXPECT_EQ(nlohmann::json::parse(clear.out)["isFlown"], false);
}

TEST(Program, skyPrintsWhereSunAndMoonStand) {
  // One JSON object on standard output and nothing else, but for the note of a year that is less sure.
  const ProcessResult noon =
      runSkydrop({"sky", "--utc", "2026-06-21T12:02:00Z", "--lat", "51.5", "--lon", "0"});
  ASSERT_EQ(noon.exitCode, 0) << noon.err;
  EXPECT_EQ(noon.err, "");
  const nlohmann::json sky = nlohmann::json::parse(noon.out);
  EXPECT_NEAR(sky["sun"]["azimuthDegrees"].get<double>(), 180, 1);
  EXPECT_NEAR(sky["sun"]["elevationDegrees"].get<double>(), 61.94, 0.02);
  EXPECT_EQ(sky["twilight"], "day");
  EXPECT_EQ(sky["moon"]["phaseName"], "first quarter");
  for (const char* name : {"phase", "illuminatedFraction", "brightLimbDegrees", "brightLimbTiltDegrees"})
    EXPECT_TRUE(sky["moon"][name].is_number()) << name;
  for (const char* name : {"rise", "set", "transit"}) EXPECT_TRUE(sky["sun"][name].is_string()) << name;
  EXPECT_FALSE(sky.contains("note"));
  const ProcessResult polar = runSkydrop({"sky", "--utc", "1949-06-21", "--lat", "90", "--lon", "0"});
  ASSERT_EQ(polar.exitCode, 0) << polar.err;
  EXPECT_TRUE(isOneLine(polar)) << "the note";
  const nlohmann::json pole = nlohmann::json::parse(polar.out);
  EXPECT_TRUE(pole["sun"]["rise"].is_null() && pole["sun"]["set"].is_null());
  EXPECT_EQ(pole["sun"]["horizon"], "staysAbove");
  EXPECT_TRUE(pole.contains("note"));
}

// A shell's view of the program: redirections and pipes.
ProcessResult runShell(const std::string& command) {
  return runProcess({"/bin/sh", "-c", command}, {"DISPLAY", "WAYLAND_DISPLAY", "SKYDROP=" + programFile(),
                                                 "XDG_CACHE_HOME=" + sharedCacheHome().string()});
}

TEST(Program, outputsAreTriedBeforeTheWork) {
  // Nothing is drawn, simulated or studied (a study names itself first), nothing is left behind, and the line
  // names the path that was asked for.
  const TemporaryFolder folder;
  const std::string here = folder.path().string(), picture = here + "/a-%d.png";
  std::filesystem::create_directory(folder.path() / "a-1.png");
  std::filesystem::create_directory(folder.path() / "shape.dds");
  const std::string old = folder.write("old.json", "old");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"accuracy", "cost", "--out", "/nonexistent/a.md"},
       "/nonexistent/a.md: cannot write: No such file or directory"},
      {{"accuracy", "cost", "--out", here}, here + ": cannot write: is a folder"},
      {{"accuracy", "--out", old}, old + ": cannot make the folder: File exists"},
      {{"render", "--out", picture, "--frames", "2"}, here + "/a-1.png: cannot write: is a folder"},
      {{"render", "--out", here + "/no%d/a.png"},
       here + "/no%d/a.png: cannot write: No such file or directory"},
      {{"render", "--out", here + "/b.png", "--stats", "/nonexistent/s"}, "/nonexistent/s: cannot write"},
      {{"simulate", "--stats", old + "/s"}, old + "/s: cannot write: Not a directory"},
      {{"--stats", "/nonexistent/s"}, "/nonexistent/s: cannot write"},
      {{"noise", "--check", "--out", old}, old + ": cannot make the folder: File exists"},
      {{"noise", "--check", "--out", "/proc/export"}, "/proc/export: cannot make the folder"},
      {{"noise", "--out", here}, here + "/shape.dds: cannot write: is a folder"},
      {{"noise", "--generate", "3d", "--width", "512", "--out", here + "/shape.dds"},
       here + "/shape.dds: cannot write: is a folder"},
      {{"noise", "--generate", "2d", "--out", "/nonexistent/a.dds"},
       "/nonexistent/a.dds: cannot write: No such file or directory"},
  };
  for (const auto& [words, line] : wrong) {
    const ProcessResult result = runSkydrop(words);
    EXPECT_EQ(result.exitCode, 1) << line;
    EXPECT_TRUE(isOneLine(result)) << line;
    EXPECT_TRUE(result.err.starts_with("skydrop: " + line)) << result.err;
    EXPECT_EQ(result.out, "") << line;
  }
  // A run that fails for another reason touches no output either.
  EXPECT_EQ(runSkydrop({"simulate", "--stats", old, "--scene", here + "/none.json"}).exitCode, 1);
  EXPECT_EQ(runSkydrop({"--stats", here + "/new.json"}).exitCode, 3);
  EXPECT_EQ(std::ifstream(old).peek(), 'o');
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 3);
}

TEST(Program, noiseForACacheThatCannotBeWrittenIsNotMade) {
  // Exported it is made all the same.
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  const std::vector<std::string> environment = {"XDG_CACHE_HOME=" + file};
  const ProcessResult lost = runProcess({programFile(), "noise"}, environment);
  EXPECT_EQ(lost.exitCode, 1);
  EXPECT_TRUE(isOneLine(lost));
  EXPECT_NE(lost.err.find(file + "/skydrop: cannot make the folder"), std::string::npos) << lost.err;
  EXPECT_EQ(lost.out, "");
  const std::string out = (folder.path() / "out").string();
  EXPECT_EQ(runProcess({programFile(), "noise", "--out", out}, environment).exitCode, 0);
  EXPECT_TRUE(std::filesystem::exists(out + "/shape.dds"));
}

TEST(Program, aResultThatCannotBeWrittenIsAFailure) {
  // A full disk and a closed descriptor, for everything that prints.
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "a.png").string(), report = (folder.path() / "a.md").string();
  for (const std::string& words :
       {std::string("--help"), std::string("--version"), std::string("--list-scenes"),
        std::string("render --help"), std::string("simulate --seconds 1"),
        std::string("simulate --seconds 1 --stats -"), std::string("noise"), std::string("info"),
        std::string("accuracy projectile --quick --resume --out ") + report,
        "render --scene empty --size 16x16 --out " + out}) {
    const ProcessResult result = runShell("\"$SKYDROP\" " + words + " >/dev/full");
    EXPECT_EQ(result.exitCode, 1) << words;
    EXPECT_NE(result.err.find("skydrop: standard output: cannot write: No space left on device\n"),
              std::string::npos)
        << words << ": " << result.err;
    const ProcessResult closed = runShell("\"$SKYDROP\" " + words + " >&-");
    EXPECT_EQ(closed.exitCode, 1) << words;
    EXPECT_NE(closed.err.find("skydrop: standard output: cannot write: Bad file descriptor\n"),
              std::string::npos)
        << words << ": " << closed.err;
  }
}

TEST(Program, aClosedPipeEndsItWithoutALine) {
  // The named pipe has lost its reader when the program starts. What was finished before is kept.
  const TemporaryFolder folder;
  const std::string pipe = (folder.path() / "pipe").string(), out = (folder.path() / "%d.png").string();
  for (const std::string& words : {std::string("--help"), std::string("simulate --seconds 1"),
                                   "render --scene empty --size 16x16 --frames 3 --out " + out}) {
    const ProcessResult result = runShell("mkfifo " + pipe + "; exec 3<>" + pipe + " 4>" + pipe +
                                          " 3<&-; rm " + pipe + "; exec \"$SKYDROP\" " + words + " >&4");
    EXPECT_EQ(result.exitCode, 141) << words;
    EXPECT_EQ(result.err, "") << words;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "0.png"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "1.png"));
}

TEST(Program, aDashWritesAFileToStandardOutputAndNothingElse) {
  const ProcessResult stats = runSkydrop({"simulate", "--seconds", "1", "--stats", "-"});
  EXPECT_EQ(stats.exitCode, 0);
  EXPECT_TRUE(nlohmann::json::accept(stats.out)) << stats.out;
  EXPECT_NE(stats.err.find("1.000 s, score"), std::string::npos) << stats.err;
  EXPECT_TRUE(
      nlohmann::json::accept(runSkydrop({"simulate", "--seconds", "1", "--stats", "/dev/stdout"}).out));
  const ProcessResult trace = runSkydrop({"simulate", "--seconds", "1", "--trace", "-"});
  EXPECT_TRUE(trace.out.starts_with("time_s,")) << trace.out;
  EXPECT_EQ(trace.out.find("score 0 of"), std::string::npos) << "the result stands in the table";
  const ProcessResult picture = runSkydrop({"render", "--scene", "empty", "--size", "16x16", "--out", "-"});
  EXPECT_EQ(picture.exitCode, 0) << picture.err;
  EXPECT_TRUE(picture.out.starts_with("\x89PNG")) << picture.out;
  EXPECT_TRUE(picture.out.ends_with("IEND\xae\x42\x60\x82")) << "a name was printed behind it";
  EXPECT_EQ(runSkydrop({"render", "--out", "-", "--stats", "-"}).exitCode, 2);
}

TEST(Program, longWorkTellsHowFarItIsWhereItIsAsked) {
  const std::vector<std::string> words = {"simulate", "--autopilot", "--seconds", "30"};
  std::vector<std::string> asked = words;
  asked.emplace_back("--progress");
  EXPECT_EQ(runSkydrop(words).err, "");
  EXPECT_TRUE(runSkydrop(asked).err.starts_with("simulate: 0 of 30 s\n"));
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "a-%d.png").string();
  EXPECT_TRUE(runSkydrop({"render", "--scene", "empty", "--size", "16x16", "--frames", "2", "--out", out,
                          "--progress"})
                  .err.starts_with("render: 0 of 0 s, frame 1 of 2\n"));
}

TEST(Program, everyVerbTellsWhatIsWrongWithThePlayersFile) {
  // Broken as a whole it is kept, under a new name each time; a key of a newer version costs nothing else.
  const TemporaryFolder folder;
  const std::string user = (folder.path() / "user").string();
  std::filesystem::create_directory(user);
  const std::vector<std::vector<std::string>> verbs = {
      {"simulate", "--seconds", "1", "--user-dir", user},
      {"render", "--scene", "empty", "--size", "16x16", "--user-dir", user, "--out", user + "/a.png"}};
  for (std::size_t i = 0; i < verbs.size(); ++i) {
    const std::string aside = user + (i == 0 ? "/settings.json.bad" : "/settings.json.bad2");
    folder.write("user/settings.json", R"({"schema": 1, "settings": {},})");
    const ProcessResult broken = runSkydrop(verbs[i]);
    EXPECT_EQ(broken.exitCode, 0);
    EXPECT_TRUE(isOneLine(broken));
    EXPECT_TRUE(broken.err.ends_with("the file is kept as " + aside + "\n")) << broken.err;
    EXPECT_TRUE(std::filesystem::exists(aside));
    folder.write("user/settings.json", R"({"schema": 1, "settings": {"moon": 1}})");
    const ProcessResult newer = runSkydrop(verbs[i]);
    EXPECT_EQ(newer.exitCode, 0);
    EXPECT_TRUE(isOneLine(newer));
    EXPECT_NE(newer.err.find("/settings.json: moon: unknown setting"), std::string::npos) << newer.err;
  }
}

TEST(Program, whatIsNoRegularFileIsRefusedAtOnce) {
  // A pipe without a writer would be waited for, a device read for ever; the time limit would end either.
  const TemporaryFolder folder;
  const std::string pipe = folder.path() / "pipe.json";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "zero.json");
  const std::string zero = folder.path() / "zero.json", empty = folder.write("empty.json", "");
  for (const std::string& file : {pipe, zero, folder.path().string() + "/", empty, std::string("/dev/null"),
                                  "/" + std::string(5000, 'x'), folder.write("a\n\x1b[2J.json", "{")}) {
    const std::vector<std::vector<std::string>> readers = {{"simulate", "--scene", file},
                                                           {"simulate", "--replay", file},
                                                           {"simulate", "--preset", file},
                                                           {"noise", "--noise", file}};
    for (const std::vector<std::string>& words : readers) {
      const ProcessResult result = runSkydrop(words, 20);
      EXPECT_EQ(result.exitCode, 1) << words[1] << " " << file;
      EXPECT_TRUE(isOneLine(result)) << words[1] << " " << file;
      EXPECT_EQ(result.err.find('\x1b'), std::string::npos) << result.err;
      EXPECT_LE(result.err.size(), 1024u) << words[1];
    }
  }
}

TEST(Program, aHyphenReadsStandardInput) {
  // Where the command line names a file to read; a pipe is as good as a file there.
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.json", R"({"schema": 1, "seed": 9, "effects": ["aircraft"]})");
  const auto fed = [](const std::string& file, const std::string& words) {
    return runProcess({"/bin/sh", "-c", "cat '" + file + "' | '" + programFile() + "' " + words});
  };
  const std::string flight = runSkydrop({"simulate", "--seconds", "1", "--scene", scene}).out;
  EXPECT_NE(flight.find("state "), std::string::npos) << flight;
  EXPECT_EQ(fed(scene, "simulate --seconds 1 --scene -").out, flight);
  const ProcessResult broken = fed(folder.write("b.json", "{\"schema\": 1,\n}"), "simulate --scene -");
  EXPECT_EQ(broken.exitCode, 1);
  EXPECT_EQ(broken.err.find("skydrop: standard input: line 2, column 1: "), 0u) << broken.err;
  const std::string preset = folder.write(
      "c.json", R"({"schema": 1, "groups": ["aircraft"], "settings": {"aircraft": {"speed": 1}}})");
  const ProcessResult unknown = fed(preset, "simulate --preset -");
  EXPECT_EQ(unknown.exitCode, 1);
  EXPECT_EQ(unknown.err.find("skydrop: standard input: aircraft.speed: unknown setting"), 0u) << unknown.err;
}

TEST(Program, aBrokenSceneLeavesTheOthersListed) {
  // The list is whole but for the broken ones, each of which is one line on stderr; the exit code says it.
  const TemporaryFolder folder;
  const std::filesystem::path source = sourceDir();
  std::filesystem::create_symlink(source / "shaders", folder.path() / "shaders");
  std::filesystem::create_directory(folder.path() / "assets");
  std::filesystem::copy(source / "assets" / "scenes", folder.path() / "assets" / "scenes");
  folder.write("assets/scenes/aaa.json", "{");
  folder.write("assets/scenes/loud.json", "{\"schema\": 1, \"description\": \"\\u001b[2J\\u0007\"}");
  ASSERT_EQ(mkfifo((folder.path() / "assets/scenes/pipe.json").c_str(), 0600), 0);
  const ProcessResult result =
      runProcess({programFile(), "--list-scenes"}, {"SKYDROP_DATA_DIR=" + folder.path().string()}, 20);
  EXPECT_EQ(result.exitCode, 1);
  for (const char* line : {"clear\t", "terrain\t", "loud\t\\x1b[2J\\x07\n"})
    EXPECT_NE(result.out.find(line), std::string::npos) << result.out;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2) << result.err;
  EXPECT_NE(result.err.find("aaa.json: line 1, column 1: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("pipe.json: cannot open: is a pipe"), std::string::npos) << result.err;
}

TEST(Program, aFieldOfPlayersBrokenFilesIsSaidOnceAndTheGameGoesOn) {
  // Deep, endless, empty, binary: each is one line, and the simulation runs with defaults.
  const TemporaryFolder folder;
  for (const std::string& content :
       {std::string(), std::string(120000, '['), std::string("\0\x1b[2J\xff", 6)}) {
    folder.write("settings.json", content);
    const ProcessResult result =
        runSkydrop({"simulate", "--seconds", "0.1", "--user-dir", folder.path().string()});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.err.find('\x1b'), std::string::npos);
  }
}

TEST(Program, noiseFilesOfAnyShapeAreReadAndExportsReplaceNothing) {
  const TemporaryFolder folder;
  const std::string column = folder.path() / "column.dds", out = folder.path() / "out";
  {
    // Legacy header: 1 x 4 texels of one byte.
    std::vector<std::uint32_t> words(32);
    words[0] = 0x20534444, words[1] = 124, words[2] = 0x1007, words[3] = 4, words[4] = 1, words[19] = 32;
    words[20] = 0x20000, words[22] = 8, words[23] = 0xff, words[27] = 0x1000;
    std::ofstream file(column, std::ios::binary);
    file.write(reinterpret_cast<const char*>(words.data()), 128).write("\0\1\2\3", 4);
  }
  const ProcessResult read = runSkydrop({"noise", "--noise", column});
  EXPECT_EQ(read.out, column + ": 1x4 r8, seam 3.00\n") << read.err;
  std::filesystem::create_directory(folder.path() / "other");
  const std::string other = folder.path() / "other" / "column.dds";
  std::filesystem::copy_file(column, other);
  const ProcessResult twice = runSkydrop({"noise", "--noise", column, "--noise", other, "--out", out});
  EXPECT_EQ(twice.exitCode, 2);
  EXPECT_TRUE(isOneLine(twice));
  EXPECT_FALSE(std::filesystem::exists(out));
  const ProcessResult onto = runSkydrop({"noise", "--noise", column, "--out", folder.path().string()});
  EXPECT_EQ(onto.exitCode, 1);
  EXPECT_NE(onto.err.find("would replace the file that is read"), std::string::npos) << onto.err;
  EXPECT_EQ(std::filesystem::file_size(column), 132u);
}

TEST(Program, generatedNoiseIsWhatTheFileSays) {
  // Every format and channel reads back as it was asked for, with its recipe; the line that reports it has
  // the seed.
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.dds").string();
  struct Row {
    std::vector<std::string> words;
    std::string expected;
  };
  for (const Row& row :
       {Row{{"2d", "--width", "64"}, "64x64 a8"},
        Row{{"2d", "--width", "64", "--height", "32", "--format", "dds"}, "64x32 a8"},
        Row{{"2d", "--width", "64", "--channel", "luminance", "--format", "dds"}, "64x64 r8"},
        Row{{"3d", "--width", "32", "--bits", "16", "--slices", "8"}, "32x32x8 r16"},
        Row{{"3d", "--width", "16", "--bits", "32", "--format", "dds"}, "16x16x16 r32f"}}) {
    std::vector<std::string> words = {"noise", "--seed", "77", "--cutoff",
                                      "0.4",   "--out",  file, "--generate"};
    words.insert(words.end(), row.words.begin(), row.words.end());
    const ProcessResult made = runSkydrop(words);
    EXPECT_EQ(made.exitCode, 0) << made.err;
    EXPECT_EQ(made.err, "");
    EXPECT_TRUE(made.out.starts_with(file + ": " + row.expected + ", octaves 6")) << made.out;
    EXPECT_NE(made.out.find("seed 77, cutoff 0.4, density 0.96"), std::string::npos) << made.out;
    const ProcessResult read = runSkydrop({"noise", "--noise", file});
    EXPECT_TRUE(read.out.starts_with(file + ": " + row.expected)) << read.out;
    EXPECT_NE(read.out.find("seed 77, cutoff 0.4, density 0.96"), std::string::npos) << read.out;
  }
  const std::string picture = (folder.path() / "v.png").string();
  EXPECT_EQ(
      runSkydrop({"noise", "--generate", "3d", "--width", "8", "--format", "png", "--out", picture}).exitCode,
      0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "v-007.png"));
  EXPECT_FALSE(std::filesystem::exists(picture));
  // On standard output the file is alone.
  const ProcessResult piped =
      runShell("\"$SKYDROP\" noise --generate 2d --width 8 --out - --progress | head -c 4");
  EXPECT_EQ(piped.out, "DDS ");
}

TEST(Program, noiseIsMadeOnceAndKept) {
  // The second run reads what the first has made; a damaged file is reported and made again; exports read
  // back.
  const TemporaryFolder folder;
  const std::string cache = folder.path() / "cache", out = folder.path() / "out";
  const auto noise = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {test::programFile(), "noise"});
    return runProcess(words, {"XDG_CACHE_HOME=" + cache});
  };
  const ProcessResult first = noise({"--out", out, "--format", "dds"});
  EXPECT_EQ(first.exitCode, 0) << first.err;
  EXPECT_EQ(first.out.find("from the cache"), std::string::npos) << first.out;
  EXPECT_EQ(noise({}).out.find("made"), std::string::npos);
  EXPECT_EQ(noise({"--noise", out + "/shape.dds"}).out.find(out + "/shape.dds: 128x128x128 rgba8"), 0u);
  const auto detail = std::filesystem::path(cache) / "skydrop" / "detail-1-0.noise";
  std::filesystem::resize_file(detail, 1000);
  const ProcessResult damaged = noise({});
  EXPECT_EQ(damaged.exitCode, 0);
  EXPECT_TRUE(isOneLine(damaged));
  EXPECT_NE(damaged.err.find(detail.string() + ": damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(noise({}).err, "");
}

TEST(Program, aSceneWithCloudsGetsTheirNoiseAndOthersDoNot) {
  // What the cache has not is made and kept; a damaged file is reported in one line; without clouds nothing
  // is looked for.
  const TemporaryFolder folder;
  const std::filesystem::path cache = folder.path() / "cache" / "skydrop";
  const auto frameOf = [&](const std::string& scene) {
    return runProcess({test::programFile(), "render", "--scene", scene, "--size", "64x36", "--set",
                       "streaming.viewDistanceM=2000", "--out", (folder.path() / "a.png").string()},
                      {"XDG_CACHE_HOME=" + (folder.path() / "cache").string()});
  };
  EXPECT_EQ(frameOf("terrain").exitCode, 0);
  EXPECT_FALSE(std::filesystem::exists(cache));
  copySharedNoise(cache);
  const std::filesystem::path weather = cache / "weather-1-0.noise";
  ASSERT_TRUE(std::filesystem::remove(weather));
  const ProcessResult first = frameOf("clear");
  EXPECT_EQ(first.exitCode, 0);
  EXPECT_EQ(first.err, "");
  ASSERT_TRUE(std::filesystem::exists(weather));
  std::filesystem::resize_file(weather, 100);
  const ProcessResult damaged = frameOf("overcast");
  EXPECT_EQ(damaged.exitCode, 0);
  EXPECT_TRUE(isOneLine(damaged));
  EXPECT_NE(damaged.err.find(weather.string() + ": damaged"), std::string::npos) << damaged.err;
  EXPECT_EQ(frameOf("fair").err, "");
}

TEST(Program, withoutADisplayItNamesRenderAndExitsWithThree) {
  const ProcessResult result = runSkydrop({});
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_TRUE(isOneLine(result));
  EXPECT_NE(result.err.find("skydrop render"), std::string::npos) << result.err;
}

TEST(Program, questionsAreAnsweredOnStandardOutput) {
  for (const char* question : {"--help", "--version", "--list-scenes"}) {
    const ProcessResult result = runSkydrop({question});
    EXPECT_EQ(result.exitCode, 0) << question;
    EXPECT_EQ(result.err, "") << question;
    EXPECT_NE(result.out, "") << question;
  }
}

TEST(Program, theSameFlightHasTheSameStateWhateverTheFrameRateAndTheWorkers) {
  const auto flight = [](const char* fps, const char* workers) {
    return runSkydrop({"simulate", "--autopilot", "--seconds", "20", "--fps", fps, "--workers", workers}).out;
  };
  const std::string state = flight("60", "1");
  EXPECT_NE(state.find("state "), std::string::npos) << state;
  EXPECT_EQ(flight("30", "4"), state);
  EXPECT_EQ(flight("144", "2"), state);
}

}  // namespace
}  // namespace skydrop::test
