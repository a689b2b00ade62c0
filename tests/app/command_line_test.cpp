#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "app/cli/command_line_parser.h"
#include "app/cli/frame_path.h"
#include "skydrop/core/error.h"
#include "skydrop/core/message.h"
#include "support/refusal.h"

namespace skydrop::app {
namespace {

ParsedCommandLine parse(std::vector<const char*> words) {
  words.insert(words.begin(), "skydrop");
  return parseCommandLine(static_cast<int>(words.size()), words.data());
}

std::string refusalOf(std::vector<const char*> words) {
  return test::refusalOf<core::UsageError>([&] { parse(std::move(words)); });
}

TEST(CommandLine, noWordsFlyTheTerrainScene) {
  const CommandLine line = parse({}).commandLine;
  EXPECT_EQ(line.verb, Verb::fly);
  EXPECT_FALSE(line.scene);
}

TEST(CommandLine, everyFlagOfRenderArrives) {
  const CommandLine line = parse({"render",     "--backend",  "osmesa",   "--size",  "320x180",
                                  "--out",      "a-%d.png",   "--frames", "3",       "--fps",
                                  "0.25",       "--time",     "4",        "--pose",  "1,2,-3,90,-10,5",
                                  "--menu",     "--scene",    "empty",    "--set",   "a=1",
                                  "--set",      "b=2",        "--seed",   "-1",      "--workers",
                                  "2",          "--user-dir", "u",        "--stats", "s.json",
                                  "--autopilot"})
                               .commandLine;
  EXPECT_EQ(line.verb, Verb::render);
  EXPECT_EQ(line.backend, render::gl::Backend::osmesa);
  EXPECT_EQ(line.size->width, 320);
  EXPECT_EQ(line.size->height, 180);
  EXPECT_EQ(line.out, "a-%d.png");
  EXPECT_EQ(line.frames, 3);
  EXPECT_EQ(line.fps, 0.25);
  EXPECT_EQ(line.timeS, 4);
  EXPECT_EQ(line.pose->position, glm::dvec3(1, 2, -3));
  EXPECT_EQ(line.pose->rollDegrees, 5);
  EXPECT_TRUE(line.menu);
  EXPECT_EQ(line.set, (std::vector<std::string>{"a=1", "b=2"}));
  EXPECT_EQ(line.seed, ~std::uint64_t{0});
  EXPECT_EQ(line.workers, 2);
  EXPECT_TRUE(line.autopilot);
}

TEST(CommandLine, aCameraTakesCompassDegrees) {
  // Heading 0 is north (-z, yaw -90 of a pose), 90 east (+x, yaw 0); what is not given is 0. For a window and
  // for pictures.
  for (const char* verb : {"render", "--fullscreen"}) {
    const Pose north = *parse({verb, "--camera", "1,2,-3"}).commandLine.pose;
    EXPECT_EQ(north.position, glm::dvec3(1, 2, -3));
    EXPECT_EQ(north.yawDegrees, -90);
    EXPECT_EQ(north.pitchDegrees, 0);
    EXPECT_FALSE(north.aboveGround);
  }
  const Pose pose = *parse({"render", "--camera=-1,20,5", "--heading", "135", "--pitch=-30", "--roll", "15",
                            "--above-ground"})
                         .commandLine.pose;
  EXPECT_EQ(pose.position, glm::dvec3(-1, 20, 5));
  EXPECT_EQ(pose.yawDegrees, 45);
  EXPECT_EQ(pose.pitchDegrees, -30);
  EXPECT_EQ(pose.rollDegrees, 15);
  EXPECT_TRUE(pose.aboveGround);
  EXPECT_EQ(parse({"render", "--camera", "0,1,0", "--heading=-300"}).commandLine.pose->yawDegrees, -30);
}

TEST(CommandLine, theReportOfAccuracyHasThreeFormats) {
  EXPECT_EQ(parse({"accuracy"}).commandLine.reportFormat, ReportFormat::markdown);
  EXPECT_EQ(parse({"accuracy", "--format", "json"}).commandLine.reportFormat, ReportFormat::json);
  EXPECT_EQ(parse({"accuracy", "land", "--format", "csv"}).commandLine.reportFormat, ReportFormat::csv);
  EXPECT_EQ(refusalOf({"accuracy", "--format", "xml"}), "--format: 'xml' is not one of markdown json csv");
}

TEST(CommandLine, accuracyTakesScenesAndMayBeQuick) {
  const CommandLine plain = parse({"accuracy"}).commandLine;
  EXPECT_TRUE(plain.scenes.empty());
  EXPECT_FALSE(plain.quick);
  const CommandLine chosen =
      parse({"accuracy", "cost", "--scene", "fair", "--quick", "--scene", "empty"}).commandLine;
  EXPECT_EQ(chosen.studies, std::vector<std::string>{"cost"});
  EXPECT_EQ(chosen.scenes, (std::vector<std::string>{"fair", "empty"}));
  EXPECT_TRUE(chosen.quick);
  EXPECT_EQ(refusalOf({"accuracy", "cost", "--scene", ""}), "--scene: the name is empty");
}

TEST(CommandLine, accuracyMeasuresSharesAndMergesThem) {
  const CommandLine part = parse({"accuracy", "--part", "2/3", "--resume", "--out", "d"}).commandLine;
  EXPECT_EQ(part.part, 2);
  EXPECT_EQ(part.parts, 3);
  EXPECT_TRUE(part.resume);
  EXPECT_EQ(parse({"accuracy", "--merge", "a", "b", "--out", "c"}).commandLine.merge.size(), 2u);
  EXPECT_EQ(refusalOf({"accuracy", "--part", "4/3"}), "--part: 4 is out of range 1 to 3");
  EXPECT_EQ(refusalOf({"accuracy", "--part", "2"}), "--part: '2' is not K/N");
}

TEST(CommandLine, framesAreANumberOrTheFirstAndTheLast) {
  EXPECT_EQ(parse({"render", "--frames", "3", "--out", "%d.png"}).commandLine.frames, 3);
  const CommandLine range = parse({"render", "--frames", "4..6", "--out", "%d.png"}).commandLine;
  EXPECT_EQ(range.firstFrame, 4);
  EXPECT_EQ(range.frames, 7);
  EXPECT_EQ(parse({"render", "--frames", "4..4", "--out", "a.png"}).commandLine.firstFrame, 4);
  EXPECT_NE(refusalOf({"render", "--frames", "4..3", "--out", "%d.png"}), "");
  EXPECT_NE(refusalOf({"render", "--frames", "4..6", "--out", "a.png"}), "");
}

TEST(CommandLine, flagsOfTheHudStandForItsSetting) {
  EXPECT_EQ(parse({"render", "--no-hud"}).commandLine.set, std::vector<std::string>{"view.hud=false"});
  EXPECT_EQ(parse({"--no-hud"}).commandLine.set, std::vector<std::string>{"view.hud=false"});
  EXPECT_EQ(parse({"render", "--hud"}).commandLine.set, std::vector<std::string>{"view.hud=true"});
  EXPECT_TRUE(sets(parse({"render", "--hud"}).commandLine, "view.hud"));
  EXPECT_TRUE(sets(parse({"render", "--set", "view.hud=true"}).commandLine, "view.hud"));
  EXPECT_FALSE(sets(parse({"render", "--set", "view.hudson=true"}).commandLine, "view.hud"));
}

TEST(CommandLine, helpOfEveryVerbNamesTheExitCodes) {
  for (const char* verb : {"render", "simulate", "accuracy", "noise", "sky", "weather", "info", "--help"}) {
    EXPECT_NE(parse({verb, "--help"}).answer->find("0 ok, 1 failed, 2 usage, 3 no OpenGL"), std::string::npos)
        << verb;
  }
}

TEST(CommandLine, skyTakesATimeAndAPlace) {
  const CommandLine line =
      parse({"sky", "--utc", "2026-06-21T12:00Z", "--lat", "-33.9", "--lon=-70"}).commandLine;
  EXPECT_EQ(line.verb, Verb::sky);
  EXPECT_EQ(line.utc, sky::parseInstant("2026-06-21T12:00:00Z"));
  EXPECT_EQ(line.place.latitudeDegrees, -33.9);
  EXPECT_EQ(line.place.longitudeDegrees, -70);
  const auto refused = [](const char* utc, const char* lat, const char* lon) {
    return refusalOf({"sky", "--utc", utc, "--lat", lat, "--lon", lon});
  };
  EXPECT_EQ(refused("2023-02-30", "0", "0"), "--utc: '2023-02-30' has day 30, but February 2023 has 28 days");
  EXPECT_EQ(refused("2026-01-01", "90.001", "0"), "--lat: 90.001 is out of range -90 to 90");
  EXPECT_EQ(refused("2026-01-01", "nan", "0"), "--lat: 'nan' is not a finite number");
  EXPECT_EQ(refused("2026-01-01", "0", "361"), "--lon: 361 is out of range -360 to 360");
  EXPECT_EQ(refusalOf({"sky", "--lat", "1", "--lon", "1"}), "--utc is required");
}

TEST(CommandLine, weatherFilesAreFlownInAndChecked) {
  // --weather names the files of the near site and brings the effect, before --set and --no-effect.
  const CommandLine flown = parse({"--weather", "a.json", "--weather", "b.json", "--weather-far", "c.txt",
                                   "--no-effect", "weather"})
                                .commandLine;
  EXPECT_EQ(flown.weatherFiles, (std::vector<std::filesystem::path>{"a.json", "b.json"}));
  EXPECT_EQ(flown.farWeatherFiles, (std::vector<std::filesystem::path>{"c.txt"}));
  EXPECT_EQ(flown.set, (std::vector<std::string>{"effects.weather=true", "effects.weather=false"}));
  EXPECT_TRUE(parse({"simulate", "--replay", "a.log", "--weather", "a.json"}).commandLine.set.empty());
  const CommandLine checked =
      parse({"weather", "check", "a", "-", "--json", "--utc", "2026-06-21"}).commandLine;
  EXPECT_EQ(checked.weather.verb, WeatherVerb::check);
  EXPECT_EQ(checked.weather.files, (std::vector<std::filesystem::path>{"a", "-"}));
  EXPECT_TRUE(checked.asJson && checked.weather.utc);
  EXPECT_EQ(refusalOf({"--weather-far", "a.json"}),
            "--weather-far needs --weather, the weather of the first site");
  EXPECT_EQ(refusalOf({"--weather", ""}), "--weather: the path is empty");
  EXPECT_EQ(refusalOf({"weather", "check"}), "weather check: there is no file to check");
  EXPECT_EQ(refusalOf({"weather", "check", "-", "-"}), "- (standard input) can be read only once");
  EXPECT_EQ(refusalOf({"weather", "state", "a.json"}),
            "weather state: files, --json and --utc belong to weather check; --weather FILE is flown in");
}

TEST(CommandLine, placesAreRowsAndCameras) {
  // --place sets the world's origin and the sky's place before --set; with a height or --look-at it is a
  // camera.
  const CommandLine flown =
      parse({"--place", "46.5,7.25", "--set", "a=1", "--elevation", "x.tif", "y.tif"}).commandLine;
  EXPECT_EQ(flown.elevationFiles, (std::vector<std::filesystem::path>{"x.tif", "y.tif"}));
  EXPECT_EQ(flown.set, (std::vector<std::string>{
                           "elevation.atCentre=false", "elevation.latitude=46.500000000",
                           "elevation.longitude=7.250000000", "render.sun.latitudeDegrees=46.500000000",
                           "render.sun.longitudeDegrees=7.250000000", "a=1"}));
  EXPECT_FALSE(flown.pose);
  const CommandLine view = parse({"render", "--place", "Gurten,30", "--look-at", "Solothurn"}).commandLine;
  ASSERT_TRUE(view.pose);
  EXPECT_EQ(view.pose->position.y, 30);
  EXPECT_TRUE(view.pose->aboveGround);
  EXPECT_NEAR(view.pose->yawDegrees + 90, 13, 1) << "Solothurn lies north by east of the Gurten";
  EXPECT_NE(parse({"render", "--place", "Bantiger"}).commandLine.pose->position.y, 0)
      << "the place's own height";
  EXPECT_EQ(refusalOf({"--look-at", "Bern"}), "--look-at belongs to --place, which is not given");
  EXPECT_NE(refusalOf({"--place", "Gurtn"}).find("Gurten"), std::string::npos);
  EXPECT_EQ(refusalOf({"--place", "91,0"}), "--place: 91 is out of range -90 to 90");
  EXPECT_NE(refusalOf({"--place", "46"}), "");
  EXPECT_NE(refusalOf({"--place", "46,7,8,9"}), "");
  EXPECT_EQ(refusalOf({"render", "--place", "Bern", "--look-at", "Gurten", "--camera", "0,1,0"}),
            "--look-at and a camera exclude each other");
  const ElevationRequest request =
      parse({"elevation", "check", "a.tif", "b.hgt", "--at", "46.9,7.4", "--at", "2600000,1200000"})
          .commandLine.elevation;
  EXPECT_EQ(request.files.size(), 2u);
  EXPECT_EQ(request.at.size(), 2u);
  EXPECT_EQ(refusalOf({"elevation", "check"}), "elevation check: there is no file to check");
  EXPECT_EQ(refusalOf({"elevation", "look", "a"}), "elevation: 'look' is not check");
}

TEST(CommandLine, weatherIsFetchedOfAServiceAndAPlace) {
  const WeatherRequest request = parse({"weather", "fetch", "--provider", "open-meteo", "--lat", "46.9",
                                        "--lon=-7", "--url", "http://127.0.0.1:8/x", "--out", "a.json"})
                                     .commandLine.weather;
  EXPECT_EQ(request.verb, WeatherVerb::fetch);
  EXPECT_EQ(request.fetch.provider, forecast::Provider::openMeteo);
  EXPECT_EQ(request.fetch.longitudeDegrees, -7);
  EXPECT_EQ(request.fetch.url, "http://127.0.0.1:8/x");
  EXPECT_EQ(refusalOf({"weather", "fetch"}), "weather fetch: --provider is required");
  EXPECT_EQ(refusalOf({"weather", "fetch", "--provider", "wind"}),
            "--provider: 'wind' is not one of meteoblue open-meteo metar");
  EXPECT_EQ(refusalOf({"weather", "fetch", "--provider", "open-meteo", "--lat", "1"}),
            "weather fetch: --lat and --lon are required");
  EXPECT_EQ(refusalOf({"weather", "fetch", "--provider", "metar"}), "weather fetch: a METAR needs --station");
  EXPECT_EQ(refusalOf({"weather", "state", "--lat", "1"}), "--lat belongs to weather fetch");
}

TEST(CommandLine, aFlightIsInTheWeatherOfAServiceAndAPlace) {
  const CommandLine line = parse({"--live", "open-meteo", "--live-at", "46.9,-7", "--live-url",
                                  "http://127.0.0.1:8/x", "--live-key-file", "k"})
                               .commandLine;
  ASSERT_TRUE(line.live);
  EXPECT_EQ(line.live->fetch.provider, forecast::Provider::openMeteo);
  EXPECT_EQ(line.live->fetch.latitudeDegrees, 46.9);
  EXPECT_EQ(line.live->fetch.longitudeDegrees, -7);
  EXPECT_EQ(line.live->fetch.url, "http://127.0.0.1:8/x");
  EXPECT_EQ(line.live->keyFile, std::filesystem::path("k"));
  EXPECT_EQ(line.set, (std::vector<std::string>{"effects.weather=true"}));
  EXPECT_FALSE(parse({}).commandLine.live);
  EXPECT_EQ(refusalOf({"--live", "wind"}), "--live: 'wind' is not one of meteoblue open-meteo metar");
  EXPECT_EQ(refusalOf({"--live", "open-meteo"}),
            "--live needs --live-at, the place that the forecast is for");
  EXPECT_EQ(refusalOf({"--live", "metar"}), "--live metar needs --live-station");
  EXPECT_EQ(refusalOf({"--live-at", "1,2"}), "--live-at belongs to --live, which is not given");
  EXPECT_EQ(refusalOf({"--live", "open-meteo", "--live-at", "1"}), "--live-at: '1' is not LAT,LON");
  EXPECT_EQ(refusalOf({"--live", "open-meteo", "--live-at", "91,2"}),
            "--live-at: 91 is out of range -90 to 90");
  EXPECT_EQ(refusalOf({"--live", "open-meteo", "--live-at", "1,2", "--record", "a.log"}),
            "--live excludes --record and --replay: a flight is recorded in one forecast");
}

TEST(CommandLine, picturesAreComparedWithAPhotograph) {
  const PhotoRequest photo = *parse({"render", "--compare", "a.jpg", "--photo-view", "wipe", "--photo-share",
                                     ".3", "--photo-field", "60", "--photo-table", "t.csv"})
                                  .commandLine.photo;
  EXPECT_EQ(photo.file, "a.jpg");
  EXPECT_EQ(photo.view, PhotoView::wipe);
  EXPECT_EQ(photo.share, 0.3);
  EXPECT_EQ(photo.fieldDegrees, 60);
  EXPECT_EQ(photo.table, std::filesystem::path("t.csv"));
  EXPECT_EQ(refusalOf({"render", "--photo-view", "wipe"}),
            "--photo-view belongs to --compare, which is not given");
  EXPECT_EQ(refusalOf({"render", "--compare", "a.jpg", "--photo-view", "none"}),
            "--photo-view: 'none' is not one of overlay wipe beside");
  EXPECT_EQ(refusalOf({"render", "--compare", "a.jpg", "--photo-share", "2"}),
            "--photo-share: 2 is out of range 0 to 1");
  EXPECT_EQ(refusalOf({"render", "--compare", "a.jpg", "--photo-field", "9", "--photo-panorama", "0"}),
            "--photo-field and --photo-panorama exclude each other");
  EXPECT_EQ(refusalOf({"render", "--compare", "a.jpg", "--out", "t.png", "--photo-plot", "t.png"}),
            "--out and --photo-plot name the same file");
}

TEST(CommandLine, weatherTakesASceneATimeAndAPlace) {
  const CommandLine line =
      parse({"weather", "state", "--scene", "breeze", "--time", "600", "--at=-1,2.5,3e9", "--set", "a=1"})
          .commandLine;
  EXPECT_EQ(line.verb, Verb::weather);
  EXPECT_EQ(line.scene, "breeze");
  EXPECT_EQ(line.timeS, 600);
  EXPECT_EQ(line.weatherAt, glm::dvec3(-1, 2.5, 3e9));
  EXPECT_EQ(line.set, std::vector<std::string>{"a=1"});
  EXPECT_EQ(refusalOf({"weather", "forecast"}), "weather: 'forecast' is not one of state check fetch");
  EXPECT_EQ(refusalOf({"weather", "state", "--at", "1,2"}), "--at: '1,2' is not of the form X,Y,Z");
  EXPECT_EQ(refusalOf({"weather", "state", "--at", "1,nan,2"}), "--at: 'nan' is not a finite number");
  EXPECT_EQ(refusalOf({"weather", "state", "--time", "-1"}), "--time: -1 is out of range 0 to 1e+09");
  EXPECT_EQ(refusalOf({"weather"}), "WHAT is required");
}

TEST(CommandLine, questionsAreAnsweredInsteadOfRun) {
  EXPECT_TRUE(parse({"--version"}).answer->starts_with("skydrop "));
  EXPECT_NE(parse({"--help"}).answer->find("simulate"), std::string::npos);
  EXPECT_NE(parse({"render", "--help"}).answer->find("--pose"), std::string::npos);
  EXPECT_NE(parse({"--list-scenes"}).answer->find("terrain\t"), std::string::npos);
}

TEST(CommandLine, aHyphenIsStandardInputOnce) {
  EXPECT_EQ(parse({"--scene", "-"}).commandLine.scene, "-");
  EXPECT_EQ(parse({"simulate", "--replay", "-"}).commandLine.replay, "-");
  EXPECT_EQ(parse({"noise", "--noise", "-"}).commandLine.noise.files.at(0), "-");
  EXPECT_EQ(refusalOf({"--scene", "-", "--preset", "-"}), "- (standard input) can be read only once");
  EXPECT_EQ(refusalOf({"noise", "--noise", "-", "--noise", "-"}), "- (standard input) can be read only once");
}

TEST(CommandLine, twoNoiseFilesOfOneNameAreNotExportedOverEachOther) {
  const std::string line =
      refusalOf({"noise", "--noise", "a/shape.dds", "--noise", "b/shape.dds", "--out", "c"});
  EXPECT_EQ(line, "--noise: 'a/shape.dds' and 'b/shape.dds' would both be exported as shape");
  EXPECT_EQ(refusalOf({"noise", "--noise", "a/shape.dds", "--noise", "a/detail.dds", "--out", "c"}), "");
  EXPECT_EQ(refusalOf({"noise", "--noise", "a/shape.dds", "--noise", "b/shape.dds"}), "")
      << "nothing is written";
}

TEST(CommandLine, generateTakesWhatItSays) {
  const NoiseRequest plane = parse({"noise", "--generate", "2d", "--out", "a.dds"}).commandLine.noise;
  EXPECT_EQ(plane.file, "a.dds");
  EXPECT_FALSE(plane.folder);
  EXPECT_EQ(plane.texture->size, (noise::NoiseSize{512, 512, 0}));
  EXPECT_EQ(plane.texture->texels, core::TexelFormat::a8);
  EXPECT_EQ(plane.texture->recipe, noise::NoiseRecipe());
  const NoiseRequest volume =
      parse({"noise", "--generate",    "3d",  "--octaves", "4",  "--frequency", "3",   "--amplitude",
             "1",     "--persistence", "0.3", "--seed",    "5",  "--width",     "64",  "--slices",
             "16",    "--cutoff",      "0.6", "--bits",    "16", "--format",    "dds", "--out",
             "a.dds"})
          .commandLine.noise;
  EXPECT_EQ(volume.texture->size, (noise::NoiseSize{64, 64, 16}));
  EXPECT_EQ(volume.texture->texels, core::TexelFormat::r16);
  const noise::NoiseSettings settings{
      .octaves = 4, .frequency = 3, .amplitude = 1, .persistence = 0.3, .seed = 5};
  EXPECT_EQ(volume.texture->recipe, (noise::NoiseRecipe{settings, noise::PostProcess{.cutoff = 0.6}}));
}

TEST(CommandLine, badNoiseIsRefusedAtTheDoor) {
  const auto refusal = [](std::vector<const char*> words, const char* kind = "2d") {
    words.insert(words.begin(), {"noise", "--generate", kind, "--out", "a.dds"});
    return refusalOf(words);
  };
  EXPECT_EQ(refusal({"--octaves", "0"}), "--octaves: 0 is out of range 1 to 16");
  EXPECT_EQ(refusal({"--octaves", "17"}), "--octaves: 17 is out of range 1 to 16");
  EXPECT_EQ(refusal({"--frequency", "0"}), "--frequency: 0 is out of range 1 to 512");
  EXPECT_EQ(refusal({"--frequency", "2.5"}), "--frequency: '2.5' is not a whole number");
  EXPECT_EQ(refusal({"--amplitude", "nan"}), "--amplitude: 'nan' is not a finite number");
  EXPECT_EQ(refusal({"--persistence", "-1"}), "--persistence: -1 is out of range 0 to 1");
  EXPECT_EQ(refusal({"--cutoff", "1.5"}), "--cutoff: 1.5 is out of range 0 to 1");
  EXPECT_EQ(refusal({"--density", "2"}), "--density: 2 is out of range 0 to 1");
  EXPECT_EQ(refusal({"--width", "0"}), "--width: 0 is out of range 1 to 8192");
  EXPECT_EQ(refusal({"--width", "3"}),
            "--width: 3 is not a power of two, which exact tiling and mip levels need");
  EXPECT_EQ(refusal({"--width", "100000"}), "--width: 100000 is out of range 1 to 8192");
  EXPECT_EQ(refusal({"--height", "-1"}), "--height: -1 is out of range 1 to 8192");
  EXPECT_EQ(refusal({"--slices", "4"}), "--slices belongs to --generate 3d");
  EXPECT_EQ(refusal({"--slices", "0"}, "3d"), "--slices: 0 layers make no volume");
  EXPECT_EQ(refusal({"--width", "1024"}, "3d"), "--size: 1024 MiB of texels: more than 256 MiB");
  EXPECT_EQ(refusal({"--bits", "12"}), "--bits: 12 is not one of 8 16 32");
  EXPECT_EQ(refusal({"--channel", "alpha", "--bits", "16"}),
            "--bits 16: DDS has alpha alone in 8 bits only; --channel luminance has 16 and 32");
  EXPECT_EQ(refusal({"--channel", "red"}), "--channel: 'red' is not one of alpha luminance");
  EXPECT_EQ(refusal({"--format", "png"}), "--out: 'a.dds' does not end in .png");
  EXPECT_EQ(refusal({"--check"}), "--generate excludes --check and --noise");
  EXPECT_EQ(refusalOf({"noise", "--generate", "4d", "--out", "a.dds"}),
            "--generate: '4d' is not one of 2d 3d");
  EXPECT_EQ(refusalOf({"noise", "--generate", "2d"}), "--generate needs --out FILE");
  EXPECT_EQ(refusalOf({"noise", "--octaves", "4"}),
            "--octaves belongs to --generate or --tool, which are not given");
}

TEST(CommandLine, theToolTakesSettingsAFileAndAPicture) {
  const CommandLine line = parse({"noise", "--tool", "--generate", "3d", "--octaves", "3", "--noise", "a.dds",
                                  "--out", "a.png", "--size", "640x360"})
                               .commandLine;
  EXPECT_TRUE(line.noise.tool);
  EXPECT_EQ(line.noise.texture->recipe.settings.octaves, 3);
  EXPECT_TRUE(line.noise.texture->size.isVolume());
  EXPECT_EQ(line.noise.file, "a.png");
  EXPECT_EQ(line.size->width, 640);
  EXPECT_EQ(refusalOf({"noise", "--tool"}), "");
  EXPECT_EQ(refusalOf({"noise", "--tool", "--check"}), "--tool and --check exclude each other");
  EXPECT_EQ(refusalOf({"noise", "--tool", "--noise", "a", "--noise", "b"}),
            "--tool opens one file of --noise");
  EXPECT_EQ(refusalOf({"noise", "--tool", "--width", "64"}),
            "--width does not go with --tool, which has it among its rows");
  EXPECT_EQ(refusalOf({"noise", "--tool", "--out", "a.dds"}), "--out: 'a.dds' does not end in .png");
  EXPECT_EQ(refusalOf({"noise", "--size", "64x64"}), "--size belongs to --tool, which is not given");
}

TEST(CommandLine, wrongWordsAreEchoedPrintableAndBounded) {
  // What stands on the command line may come from a script that passes on anything.
  const std::string bad = "a\x1b[2J\n" + std::string(5000, 'x') + "end";
  for (const char* flag : {"--size", "--seed", "--workers"}) {
    const std::string line = refusalOf({flag, bad.c_str()});
    EXPECT_NE(line.find("a\\x1b[2J\\n"), std::string::npos) << line;
    EXPECT_LE(line.size(), core::kLongestMessage);
    EXPECT_EQ(line, core::printable(line));
  }
  EXPECT_LE(refusalOf({bad.c_str()}).size(), core::kLongestMessage);
}

TEST(CommandLine, aFrameBudgetIsItsSettingInAWindowAndRefusedElsewhere) {
  EXPECT_THAT(parse({"--set", "view.frameBudgetMs=5", "--frame-budget", "33.5"}).commandLine.set,
              testing::ElementsAre("view.frameBudgetMs=5", "view.frameBudgetMs=33.5"));
  EXPECT_EQ(refusalOf({"--frame-budget", "0"}), "--frame-budget: 0 is out of range 1 to 1000");
  EXPECT_EQ(refusalOf({"--frame-budget", "-33"}), "--frame-budget: -33 is out of range 1 to 1000");
  EXPECT_EQ(refusalOf({"--frame-budget", "1001"}), "--frame-budget: 1001 is out of range 1 to 1000");
  for (const std::string bad : {"nan", "inf", "fast", "33ms", ""})
    EXPECT_EQ(refusalOf({"--frame-budget", bad.c_str()}),
              "--frame-budget: '" + bad + "' is not a finite number");
  for (const char* verb : {"render", "simulate"}) {
    EXPECT_EQ(refusalOf({verb, "--frame-budget", "33"}), std::string("--frame-budget: ") + kNoBudgetHere)
        << verb;
  }
}

TEST(CommandLine, wrongWordsAreRefusedInOneLineThatNamesThem) {
  EXPECT_NE(refusalOf({"--fast"}).find("--fast"), std::string::npos);
  EXPECT_NE(refusalOf({"dance"}).find("dance"), std::string::npos);
  EXPECT_NE(refusalOf({"--scene"}).find("--scene"), std::string::npos);
  EXPECT_EQ(refusalOf({"--size", "640"}), "--size: '640' is not of the form WIDTHxHEIGHT");
  EXPECT_EQ(refusalOf({"--size", "0x5"}), "--size: 0 is out of range 1 to 16384");
  EXPECT_EQ(refusalOf({"--size", "axb"}), "--size: 'a' is not a whole number");
  EXPECT_EQ(refusalOf({"--size", "99999999999x5"}), "--size: '99999999999' is not a whole number");
  EXPECT_EQ(refusalOf({"--seed", "one"}), "--seed: 'one' is not a whole number of 64 bits");
  EXPECT_EQ(refusalOf({"--workers", "0"}), "--workers: 0 is out of range 1 to 64");
  EXPECT_EQ(refusalOf({"render", "--pose", "1,2,3"}),
            "--pose: '1,2,3' is not of the form X,Y,Z,YAW,PITCH,ROLL");
  EXPECT_EQ(refusalOf({"render", "--pose", "nan,2,3,0,0,0"}), "--pose: 'nan' is not a finite number");
  EXPECT_EQ(refusalOf({"render", "--pose", "1e13,2,3,0,0,0"}),
            "--pose: 1e13 is out of range -1e+12 to 1e+12");
  EXPECT_EQ(refusalOf({"render", "--camera", "1,2"}), "--camera: '1,2' is not of the form X,Y,Z");
  EXPECT_EQ(refusalOf({"render", "--camera", "1,2e5,3"}), "--camera: 2e5 is out of range -1e+12 to 20000");
  EXPECT_EQ(refusalOf({"render", "--pose", "1,2e5,3,0,0,0"}), "--pose: 2e5 is out of range -1e+12 to 20000");
  EXPECT_EQ(refusalOf({"render", "--camera", "1,2,3", "--pose", "1,2,3,0,0,0"}),
            "--camera and --pose exclude each other");
  for (const char* flag : {"--heading=1", "--pitch=1", "--roll=1", "--above-ground"}) {
    const std::string name = std::string(flag).substr(0, std::string(flag).find('='));
    EXPECT_EQ(refusalOf({"render", flag, "--pose", "1,2,3,0,0,0"}),
              name + " belongs to --camera, which is not given");
    EXPECT_EQ(refusalOf({flag}), name + " belongs to --camera, which is not given");
  }
  EXPECT_EQ(refusalOf({"render", "--camera", "1,2,3", "--heading", "north"}),
            "--heading: 'north' is not a finite number");
  EXPECT_EQ(refusalOf({"render", "--camera", "1,2,3", "--pitch", "91"}),
            "--pitch: 91 is out of range -90 to 90");
  EXPECT_EQ(refusalOf({"render", "--hud", "--no-hud"}), "--hud and --no-hud exclude each other");
  EXPECT_EQ(refusalOf({"render", "--frames", "2"}), "--out: 'skydrop.png' needs %d for several frames");
  EXPECT_EQ(refusalOf({"render", "--out", "a.bmp"}), "--out: 'a.bmp' does not end in .png");
  EXPECT_EQ(refusalOf({"render", "--backend", "vulkan"}),
            "--backend: 'vulkan' is not one of egl osmesa window");
  EXPECT_EQ(refusalOf({"render", "--heat"}), "--heat belongs to --split, which is not given");
  EXPECT_EQ(refusalOf({"render", "--divider", "0.5"}), "--divider belongs to --split, which is not given");
  EXPECT_EQ(refusalOf({"render", "--split", "clouds=reference", "--divider", "1.5"}),
            "--divider: 1.5 is out of range 0 to 1");
  EXPECT_EQ(refusalOf({"render", "--fps", "0"}), "--fps: 0 is out of range 0.001 to 1000");
  EXPECT_EQ(refusalOf({"simulate", "--seconds", "-1"}), "--seconds: -1 is out of range 0 to 1e+06");
  EXPECT_EQ(refusalOf({"--autopilot", "--replay", "a"}), "--autopilot and --replay exclude each other");
  for (const char* flag : {"--scene", "--seed", "--stats"}) {
    EXPECT_EQ(refusalOf({flag, ""}).find('\n'), std::string::npos) << flag;
  }
}

TEST(CommandLine, onlyTheNameOfAPictureCountsFrames) {
  // A folder may have any name; a percent sign of the name is written twice, and nothing else follows one.
  EXPECT_EQ(framePath("100%done/x-%d.png", 3), "100%done/x-3.png");
  EXPECT_EQ(framePath("%d/%d.png", 3), "%d/3.png");
  EXPECT_EQ(framePath("/a/50%%-%d-%d.png", 3), "/a/50%-3-3.png");
  EXPECT_EQ(framePath("%%d.png", 3), "%d.png");
  EXPECT_EQ(parse({"render", "--out", "100%done/x.png"}).commandLine.out, "100%done/x.png");
  EXPECT_EQ(parse({"render", "--out", "-"}).commandLine.out, "-");
  for (const char* wrong : {"a-%04d.png", "100%.png", "%s.png", "a%20b.png", "%%%.png"}) {
    EXPECT_NE(refusalOf({"render", "--out", wrong}).find(wrong), std::string::npos) << wrong;
  }
  for (const char* one : {"%d/x.png", "%%d.png", "-"}) {
    EXPECT_NE(refusalOf({"render", "--frames", "2", "--out", one}).find("needs %d"), std::string::npos)
        << one;
  }
}

TEST(CommandLine, twoOutputsOfOneNameAreRefused) {
  EXPECT_EQ(refusalOf({"simulate", "--stats", "a", "--trace", "./a"}),
            "--stats and --trace name the same file");
  EXPECT_EQ(refusalOf({"simulate", "--record", "a", "--stats", "a"}),
            "--stats and --record name the same file");
  EXPECT_EQ(refusalOf({"render", "--out", "-", "--stats", "-"}), "--out and --stats name the same file");
  EXPECT_TRUE(parse({"simulate", "--stats", "/dev/null", "--trace", "/dev/null"}).commandLine.trace);
}

TEST(CommandLine, framePathsCountFrames) {
  EXPECT_EQ(framePath("a-%d.png", 12), "a-12.png");
  EXPECT_EQ(framePath("a.png", 12), "a.png");
}

}  // namespace
}  // namespace skydrop::app
