#include "app/cli/command_line_parser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "app/cli/flag_values.h"
#include "app/cli/noise_words.h"
#include "app/types/version.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/message.h"
#include "skydrop/core/nearest_names.h"
#include "skydrop/scene/scene.h"

namespace skydrop::app {
namespace {

using core::UsageError;

constexpr double kMaxSeconds = 1e6;  // more is a slip of the hand
constexpr double kLongestWeatherS = 1e9;
constexpr const char* kExitCodes =
    "Exit codes: 0 ok, 1 failed, 2 usage, 3 no OpenGL 4.5 or no display, "
    "141 nobody reads standard output.";

// Where the file's name begins in a path.
std::size_t nameAt(const std::string& path) { return path.rfind('/') + 1; }

// Judges the name of a picture; returns whether it counts frames.
bool countsFrames(const std::string& pattern) {
  bool counts = false;
  for (std::size_t i = pattern.find('%', nameAt(pattern)); i < pattern.size(); i = pattern.find('%', i + 2)) {
    const char what = i + 1 < pattern.size() ? pattern[i + 1] : 0;
    if (what != 'd' && what != '%') {
      throw UsageError("--out: '" + pattern +
                       "': in a name % is followed by d (the frame's number) or % (a percent sign)");
    }
    counts = counts || what == 'd';
  }
  return counts;
}

// CLI11 only splits words and writes the help; values arrive as text and are read above, so that every
// refusal has the same form.
class Parser {
 public:
  Parser() {
    app_.set_help_flag("--help", "print this help");
    app_.add_flag("--version", version_, "print the version");
    app_.add_flag("--list-scenes", listScenes_,
                  "print the names of the scenes; a broken one is an error (1) after the list");
    addCommon(app_);
    addFly(app_);
    CLI::App* render = app_.add_subcommand("render", "frames to PNG files, no window needed");
    CLI::App* simulate = app_.add_subcommand("simulate", "no graphics: physics and game only");
    CLI::App* accuracy = app_.add_subcommand("accuracy", "measure error against time, write the report");
    CLI::App* noise = app_.add_subcommand(
        "noise", "make, check, export and read noise: the clouds' own, and textures of any settings");
    CLI::App* sky = app_.add_subcommand("sky", "where sun and moon stand at a place and time, as JSON");
    CLI::App* weather =
        app_.add_subcommand("weather", "the state of a scene's air at a place and time, as JSON");
    CLI::App* info = app_.add_subcommand("info", "versions, OpenGL renderer, limits");
    CLI::App* compare =
        app_.add_subcommand("compare", "how far two pictures differ; exit code 1 where it is too far");
    CLI::App* settings =
        app_.add_subcommand("settings", "every setting with default, range and what it does");
    for (CLI::App* verb : {render, simulate, accuracy, noise, sky, weather, info, compare, settings})
      verb->set_help_flag("--help", "print this help");
    for (CLI::App* verb : {&app_, render, simulate, accuracy, noise, sky, weather, info, compare, settings})
      verb->footer(kExitCodes);
    addCommon(*render);
    addRender(*render);
    addCommon(*simulate);
    addSimulate(*simulate);
    addNoise(*noise);
    addSky(*sky);
    addWeather(*weather);
    for (CLI::App* verb : {render, simulate, accuracy, noise}) {
      verb->add_flag("--progress", line_.progress,
                     "tell how far it is, each second, where there is no terminal");
    }
    addAccuracy(*accuracy);
    text(*info, "--backend", "egl|osmesa|window", "the back-end to ask",
         [this](const std::string& t) { line_.backend = parseBackend(t); });
    addCompare(*compare);
    addSettings(*settings);
    app_.require_subcommand(0, 1);
    render->callback([this] { line_.verb = Verb::render; });
    simulate->callback([this] { line_.verb = Verb::simulate; });
    accuracy->callback([this] { line_.verb = Verb::accuracy; });
    noise->callback([this] { line_.verb = Verb::noise; });
    sky->callback([this] { line_.verb = Verb::sky; });
    weather->callback([this] { line_.verb = Verb::weather; });
    info->callback([this] { line_.verb = Verb::info; });
    compare->callback([this] { line_.verb = Verb::compare; });
    settings->callback([this] { line_.verb = Verb::settings; });
  }

  ParsedCommandLine parse(int argc, const char* const* argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
      const auto chosen = app_.get_subcommands();
      return {line_, (chosen.empty() ? app_ : *chosen.front()).help(), {}};
    } catch (const CLI::ParseError& error) {
      throw UsageError(error.what());
    }
    if (version_) return {line_, std::string("skydrop ") + kVersion + "\n", {}};
    if (listScenes_) return sceneList();
    finishNoise();
    check();
    checkCamera();
    if (camera_) line_.pose = poseOfCamera();
    // After every --set: the flag is the shorter word for the same.
    if (frameBudget_) line_.set.push_back("view.frameBudgetMs=" + *frameBudget_);
    // Before every other word, so that --no-effect weather and --set are heard. A replay has its effects.
    if (!line_.weatherFiles.empty() && !line_.replay)
      line_.set.insert(line_.set.begin(), "effects.weather=true");
    if (hud_ || noHud_) line_.set.push_back(std::string("view.hud=") + (hud_ ? "true" : "false"));
    return {line_, std::nullopt, {}};
  }

 private:
  static void text(CLI::App& verb, const std::string& flag, const std::string& form, const std::string& help,
                   std::function<void(const std::string&)> read) {
    verb.add_option_function<std::string>(flag, std::move(read), help)
        ->type_name(form)
        ->allow_extra_args(false);
  }

  void path(CLI::App& verb, const std::string& flag, const std::string& form, const std::string& help,
            std::optional<std::filesystem::path>& target) {
    text(verb, flag, form, help, [flag, &target](const std::string& t) {
      if (t.empty()) throw UsageError(flag + ": the path is empty");
      target = t;
    });
  }

  void addScene(CLI::App& verb) {
    text(verb, "--scene", "NAME|FILE|-",
         std::string("the scene (") + kDefaultScene + "); - is standard input, here and below",
         [this](const std::string& t) {
           if (t.empty()) throw UsageError("--scene: the name is empty");
           line_.scene = t;
         });
  }

  void addSet(CLI::App& verb) {
    verb.add_option_function<std::vector<std::string>>(
            "--set",
            [this](const std::vector<std::string>& all) {
              line_.set.insert(line_.set.end(), all.begin(), all.end());
            },
            "a setting for this run; may stand several times")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false)
        ->expected(1, 1000);
  }

  void addCommon(CLI::App& verb) {
    addScene(verb);
    text(verb, "--preset", "NAME|FILE|-", "a preset that the menu saved, for this run; --set comes after it",
         [this](const std::string& t) {
           if (t.empty()) throw UsageError("--preset: the name is empty");
           line_.preset = t;
         });
    addSet(verb);
    addEffect(verb, "--effect", true,
              "switch an effect on that the scene does not call for (effects.NAME=true)");
    addEffect(verb, "--no-effect", false, "switch an effect off (effects.NAME=false)");
    addSeed(verb, "the world's seed instead of the scene's");
    text(verb, "--workers", "N", "threads that make terrain (cores - 1)",
         [this](const std::string& t) { line_.workers = integer("--workers", t, 1, 64); });
    addWeatherFiles(verb);
    path(verb, "--user-dir", "DIR", "the player's settings", line_.userDir);
    path(verb, "--stats", "FILE|-", "write what was measured, as JSON; - is standard output", line_.stats);
    path(verb, "--replay", "FILE|-", "fly a recorded input log, and compare", line_.replay);
    path(verb, "--record", "FILE|-", "record the flight as an input log; FILE must be new or empty",
         line_.record);
    text(verb, "--frame-budget", "MS",
         "most milliseconds of a frame, 1 to 1000: chooses the settings with the least error within it, of "
         "flights in a window alone (view.frameBudgetMs=MS)",
         [this](const std::string& t) {
           number("--frame-budget", t, 1, 1000);
           frameBudget_ = t;
         });
    verb.add_flag("--autopilot", line_.autopilot, "let the autopilot fly");
  }

  void addWeatherFiles(CLI::App& verb) {
    const auto files = [&](const std::string& flag, std::vector<std::filesystem::path>& target,
                           const std::string& help) {
      verb.add_option_function<std::vector<std::string>>(
              flag,
              [flag, &target](const std::vector<std::string>& all) {
                if (std::ranges::find(all, "") != all.end()) throw UsageError(flag + ": the path is empty");
                target.assign(all.begin(), all.end());
              },
              help)
          ->type_name("FILE|-")
          ->allow_extra_args(false)
          ->expected(1, 100);
    };
    files(
        "--weather", line_.weatherFiles,
        "fly in the weather of a file: an answer of meteoblue or Open-Meteo, or METARs; switches the effect "
        "weather on; several of one place count as one");
    files("--weather-far", line_.farWeatherFiles, "of --weather: the weather of a second site");
  }

  // The flags are the shorter words for --set, and count in the order in which all of them stand.
  void addEffect(CLI::App& verb, const std::string& flag, bool on, const std::string& help) {
    verb.add_option_function<std::vector<std::string>>(
            flag,
            [this, flag, on](const std::vector<std::string>& all) {
              for (const std::string& name : all) {
                if (std::ranges::find(scene::kEffectNames, name) == scene::kEffectNames.end())
                  throw UsageError(flag + ": unknown effect '" + name + "'" +
                                   core::nearestText(name, scene::kEffectNames));
                line_.set.push_back("effects." + name + "=" + (on ? "true" : "false"));
              }
            },
            help + "; may stand several times")
        ->type_name("NAME")
        ->allow_extra_args(false)
        ->expected(1, 1000);
  }

  void addSeed(CLI::App& verb, const std::string& help) {
    text(verb, "--seed", "N", help, [this](const std::string& t) {
      line_.seed = wholeText<std::uint64_t>(t);
      if (const auto negative = wholeText<std::int64_t>(t); !line_.seed && negative) {
        line_.seed = static_cast<std::uint64_t>(*negative);
      }
      if (!line_.seed) throw UsageError("--seed: '" + t + "' is not a whole number of 64 bits");
    });
  }

  void addNoise(CLI::App& verb) {
    addSeed(verb, "the noise's seed (0); its lower 32 bits");
    verb.add_flag("--check", line_.noise.check,
                  "make all by processor and by shader, compare them, look for seams");
    verb.add_option_function<std::vector<std::string>>(
            "--noise",
            [this](const std::vector<std::string>& all) {
              if (std::ranges::find(all, "") != all.end()) throw UsageError("--noise: the path is empty");
              line_.noise.files.assign(all.begin(), all.end());
            },
            "read these DDS files (-: standard input) instead of making; may stand several times")
        ->type_name("FILE|-")
        ->allow_extra_args(false)
        ->expected(1, 1000);
    path(verb, "--out", "DIR|FILE",
         "export to this folder; with --generate the file, .dds or .png (-: standard output)",
         line_.noise.folder);
    addNoiseTexture(verb);
    text(verb, "--format", "dds|dx10|png",
         "of the export (dx10): DDS with legacy or DX10 header, slices as PNG",
         [this](const std::string& t) { line_.noise.format = parseNoiseFormat(t); });
    text(verb, "--backend", "egl|osmesa|window",
         "what runs the shader of --check, and draws the picture of --tool",
         [this](const std::string& t) { line_.backend = parseBackend(t); });
  }

  void addNoiseTexture(CLI::App& verb) {
    NoiseWords& words = noiseWords_;
    verb.add_flag("--tool", line_.noise.tool,
                  "open the tool that makes such noise, with these settings or the file of --noise; with "
                  "--out FILE.png "
                  "a picture of it, without a window");
    addSize(verb);
    text(verb, "--generate", "2d|3d", "make a texture or a volume of gradient noise (docs/noise.md) instead",
         [&words](const std::string& t) {
           if (t != "2d" && t != "3d") throw UsageError("--generate: '" + t + "' is not one of 2d 3d");
           words.volume = t == "3d";
         });
    const auto whole = [&](const std::string& flag, std::optional<int>& target, const std::string& help) {
      text(verb, flag, "N", help, [flag, &target, &words](const std::string& t) {
        constexpr int kMost = std::numeric_limits<int>::max();
        target = integer(flag, t, -kMost, kMost);
        words.flags.push_back(flag);
      });
    };
    const auto real = [&](const std::string& flag, std::optional<double>& target, const std::string& help) {
      text(verb, flag, "X", help, [flag, &target, &words](const std::string& t) {
        constexpr double kMost = std::numeric_limits<double>::max();
        target = number(flag, t, -kMost, kMost);
        words.flags.push_back(flag);
      });
    };
    whole("--octaves", words.octaves, "1 to 16 (6)");
    whole("--frequency", words.frequency, "lattice cells to a period in the first octave, 1 to 512 (6)");
    real("--amplitude", words.amplitude, "weight of the first octave, 0 to 4 (0.7)");
    real("--persistence", words.persistence, "weight of an octave over the one before, 0 to 1 (0.5)");
    whole("--width", words.width, "texels, a power of two (512; 128 of a volume)");
    whole("--height", words.height, "texels, a power of two (the width)");
    whole("--slices", words.slices, "layers of a volume, a power of two (the width)");
    real("--cutoff", words.cutoff,
         "cut to clouds: values up to this one are 0 (not cut; 0.5 with --density)");
    real("--density", words.density,
         "cut to clouds: 1 - density^(255 (value - cutoff)) above (0.96 with --cutoff)");
    whole("--bits", words.bits, "of a texel: 8, 16, or 32 for floats (8)");
    text(verb, "--channel", "alpha|luminance", "what the texels are (alpha; luminance with 16 and 32 bits)",
         [&words](const std::string& t) {
           if (t != "alpha" && t != "luminance")
             throw UsageError("--channel: '" + t + "' is not one of alpha luminance");
           words.alpha = t == "alpha";
           words.flags.emplace_back("--channel");
         });
  }

  // What --generate and --tool ask for; a file takes the place of the folder.
  void finishNoise() {
    NoiseRequest& request = line_.noise;
    if (request.tool) return finishTool();
    if (line_.verb == Verb::noise && line_.size)
      throw UsageError("--size belongs to --tool, which is not given");
    if (!noiseWords_.volume) {
      if (!noiseWords_.flags.empty())
        throw UsageError(noiseWords_.flags.front() + " belongs to --generate or --tool, which are not given");
      return;
    }
    if (request.check || !request.files.empty()) throw UsageError("--generate excludes --check and --noise");
    request.texture = noiseTexture(noiseWords_, line_.seed.value_or(0));
    if (!request.folder) throw UsageError("--generate needs --out FILE");
    const bool png = request.format == NoiseFormat::png;
    if (png && core::texelBytes(request.texture->texels) != 1) throw UsageError("--format png holds 8 bits");
    takeNoiseFile(png ? ".png" : ".dds", !png || !request.texture->size.isVolume());
  }

  void finishTool() {
    NoiseRequest& request = line_.noise;
    if (request.check) throw UsageError("--tool and --check exclude each other");
    if (request.files.size() > 1) throw UsageError("--tool opens one file of --noise");
    for (const std::string& flag : noiseWords_.flags) {
      if (flag == "--width" || flag == "--height" || flag == "--slices" || flag == "--bits" ||
          flag == "--channel")
        throw UsageError(flag + " does not go with --tool, which has it among its rows");
    }
    request.texture = noiseTexture(noiseWords_, line_.seed.value_or(0));
    if (request.folder) takeNoiseFile(".png", true);
  }

  void takeNoiseFile(const std::string& ending, bool mayBeStream) {
    NoiseRequest& request = line_.noise;
    request.file = request.folder->string();
    request.folder.reset();
    if (!(mayBeStream && request.file == "-") && !request.file.ends_with(ending))
      throw UsageError("--out: '" + request.file + "' does not end in " + ending);
  }

  void addSize(CLI::App& verb) {
    text(verb, "--size", "WxH", "pixels", [this](const std::string& t) { line_.size = parseSize(t); });
  }

  void addView(CLI::App& verb) {
    addSize(verb);
    text(verb, "--camera", "X,Y,Z", "a camera in the world: metres, +X east, Y up, -Z north",
         [this](const std::string& t) { camera_ = parseCamera(t); });
    const auto angle = [&](const std::string& flag, std::optional<double>& target, double most,
                           const std::string& help) {
      text(verb, flag, "DEGREES", help,
           [flag, &target, most](const std::string& t) { target = number(flag, t, -most, most); });
    };
    angle("--heading", heading_, 360, "of --camera by the compass: 0 north, 90 east (0)");
    angle("--pitch", pitch_, 90, "of --camera, up (0)");
    angle("--roll", roll_, 360, "of --camera, right side down (0)");
    verb.add_flag("--above-ground", aboveGround_, "Y of --camera is counted from the surface, land or sea");
    text(verb, "--pose", "X,Y,Z,YAW,PITCH,ROLL",
         "the same in one word; YAW 0 looks east, 90 south: the compass heading less 90",
         [this](const std::string& t) { line_.pose = parsePose(t); });
    verb.add_flag("--hud", hud_,
                  "with the HUD, which a camera in the world leaves out of pictures (view.hud=true)");
    verb.add_flag("--no-hud", noHud_, "without the HUD (view.hud=false)");
  }

  void addFly(CLI::App& verb) {
    addView(verb);
    verb.add_flag("--fullscreen", line_.fullscreen, "fill the screen");
  }

  void addRender(CLI::App& verb) {
    text(verb, "--backend", "egl|osmesa|window", "what gives the OpenGL context",
         [this](const std::string& t) { line_.backend = parseBackend(t); });
    addView(verb);
    text(verb, "--out", "FILE.png|-",
         "the picture; in its name %d is the frame's number and %% a percent sign",
         [this](const std::string& t) { line_.out = t; });
    text(verb, "--frames", "N|A..B",
         "how many (1), or the first and the last of those that are drawn, from 0 on",
         [this](const std::string& t) { parseFrames(t); });
    text(verb, "--fps", "N", "simulated frames a second (60)",
         [this](const std::string& t) { line_.fps = number("--fps", t, 1e-3, 1000); });
    text(verb, "--time", "S", "simulated seconds before the first frame (0)",
         [this](const std::string& t) { line_.timeS = number("--time", t, 0, kMaxSeconds); });
    verb.add_flag("--menu", line_.menu, "with the menu open");
    addSplit(verb);
  }

  // --heat and --divider are shorter words for --set.
  void addSplit(CLI::App& verb) {
    text(verb, "--split", "SUBJECT=REFERENCE",
         "the picture left of a divider, that of a reference right of it, and the error between them: "
         "clouds=reference (or any tier), land=reference, sky=reference",
         [this](const std::string& t) { line_.split = t; });
    verb.add_flag_callback(
        "--heat",
        [this] {
          splitWords_.emplace_back("--heat");
          line_.set.emplace_back("view.split.heat=true");
        },
        "of --split: right of the divider how visible the error is (view.split.heat=true)");
    text(verb, "--divider", "X", "of --split: where it is, 0 to 1 of the width (view.split.divider=X)",
         [this](const std::string& t) {
           splitWords_.emplace_back("--divider");
           line_.set.push_back("view.split.divider=" + std::to_string(number("--divider", t, 0, 1)));
         });
  }

  void addAccuracy(CLI::App& verb) {
    verb.add_option(
            "STUDY", line_.studies,
            "studies by name, or files of the same form; or cost alone: what each effect costs; or "
            "calibrate alone: what a frame budget chooses from, for the cache folder. None named: all "
            "but those two")
        ->type_name("NAME|FILE");
    verb.add_option_function<std::vector<std::string>>(
            "--scene",
            [this](const std::vector<std::string>& all) {
              if (std::ranges::find(all, "") != all.end()) throw UsageError("--scene: the name is empty");
              line_.scenes = all;
            },
            "a scene that cost measures, and no others (all), may stand several times; or that of calibrate "
            "(fair)")
        ->type_name("NAME|FILE")
        ->allow_extra_args(false)
        ->expected(1, 1000);
    verb.add_flag("--quick", line_.quick, "small pictures (160x90) and three repeats instead of five");
    addSize(verb);
    text(verb, "--out", "DIR|FILE|-",
         "the folder of results and report (accuracy); of cost a file (accuracy.md) or - for standard output",
         [this](const std::string& t) {
           if (t.empty()) throw UsageError("--out: the path is empty");
           line_.out = t;
         });
    text(verb, "--format", "markdown|json|csv", "of the report of cost (markdown)",
         [this](const std::string& t) { line_.reportFormat = parseReportFormat(t); });
    verb.add_flag("--resume", line_.resume, "go on with the results in the folder");
    text(verb, "--part", "K/N", "measure every Nth case, beginning with the Kth",
         [this](const std::string& t) { parsePart(t); });
    verb.add_option_function<std::vector<std::string>>(
            "--merge",
            [this](const std::vector<std::string>& all) { line_.merge.assign(all.begin(), all.end()); },
            "make one report of these folders of shares")
        ->type_name("DIR..")
        ->expected(1, 1000);
    verb.preparse_callback([this](std::size_t) { line_.out.clear(); });
  }

  void parsePart(const std::string& t) {
    const std::size_t slash = t.find('/');
    if (slash == std::string::npos) throw UsageError("--part: '" + t + "' is not K/N");
    line_.parts = integer("--part", t.substr(slash + 1), 1, 10000);
    line_.part = integer("--part", t.substr(0, slash), 1, line_.parts);
  }

  // "N" or "A..B"
  void parseFrames(const std::string& t) {
    constexpr int kMost = 1000000;
    const std::size_t dots = t.find("..");
    if (dots == std::string::npos) {
      line_.frames = integer("--frames", t, 1, kMost);
      line_.firstFrame = 0;
      return;
    }
    line_.firstFrame = integer("--frames", t.substr(0, dots), 0, kMost - 1);
    line_.frames = integer("--frames", t.substr(dots + 2), line_.firstFrame, kMost - 1) + 1;
  }

  void addSimulate(CLI::App& verb) {
    path(verb, "--trace", "FILE.csv|-", "write every step of the flight as a row of numbers", line_.trace);
    text(verb, "--seconds", "S", "how long (60; a replay to its end)",
         [this](const std::string& t) { line_.seconds = number("--seconds", t, 0, kMaxSeconds); });
    text(verb, "--fps", "N", "the drawing rate that is imitated (60)",
         [this](const std::string& t) { line_.fps = number("--fps", t, 1e-3, 1000); });
  }

  void addSky(CLI::App& verb) {
    text(verb, "--utc", "TIME", "ISO 8601, such as 2026-06-21T12:00:00Z, in the years 1000 to 3000",
         [this](const std::string& t) { line_.utc = parseUtc(t); });
    text(verb, "--lat", "DEGREES", "latitude, north, -90 to 90",
         [this](const std::string& t) { line_.place.latitudeDegrees = number("--lat", t, -90, 90); });
    text(verb, "--lon", "DEGREES", "longitude, east, -360 to 360",
         [this](const std::string& t) { line_.place.longitudeDegrees = number("--lon", t, -360, 360); });
    for (const char* flag : {"--utc", "--lat", "--lon"}) verb.get_option(flag)->required();
  }

  void addWeather(CLI::App& verb) {
    verb.add_option_function<std::string>(
            "WHAT",
            [this](const std::string& t) {
              const auto what = std::ranges::find(kWeatherVerbs, t);
              if (what == kWeatherVerbs.end())
                throw UsageError("weather: '" + t + "' is not one of state check fetch");
              line_.weather.verb = static_cast<WeatherVerb>(what - kWeatherVerbs.begin());
            },
            "state: the whole state, with wind, turbulence and cloud at the point; check: what weather files "
            "say, hour by hour, and what they lack; fetch: ask a service, and keep its answer in the cache "
            "folder")
        ->required();
    verb.add_option_function<std::vector<std::string>>(
            "FILE",
            [this](const std::vector<std::string>& all) {
              if (std::ranges::find(all, "") != all.end()) throw UsageError("weather: the path is empty");
              line_.weather.files.assign(all.begin(), all.end());
            },
            "of check: several answers about one place count as one")
        ->type_name("FILE|-")
        ->expected(0, 100);
    verb.add_flag("--json", line_.weather.json, "of check: as JSON");
    addFetch(verb);
    text(verb, "--utc", "TIME",
         "of check: about when METARs were made, which name no month (the file's time)",
         [this](const std::string& t) { line_.weather.utc = parseUtc(t); });
    addScene(verb);
    addSet(verb);
    addWeatherFiles(verb);
    addSeed(verb, "the world's seed instead of the scene's");
    text(verb, "--time", "S", "simulated seconds (0)",
         [this](const std::string& t) { line_.timeS = number("--time", t, 0, kLongestWeatherS); });
    text(verb, "--at", "X,Y,Z", "where: metres, +X east, Y above the sea, -Z north (0,500,0)",
         [this](const std::string& t) { line_.weatherAt = parseAt(t); });
  }

  void addCompare(CLI::App& verb) {
    verb.add_option("PICTURE REFERENCE", line_.comparison.files, "two PNG files of one size")
        ->required()
        ->expected(2);
    text(verb, "--max", "N", "most that any channel may differ by, 0 to 255",
         [this](const std::string& t) { line_.comparison.most = integer("--max", t, 0, 255); });
    text(verb, "--mean", "M", "most that channels may differ by in the mean, 0 to 255",
         [this](const std::string& t) { line_.comparison.mean = number("--mean", t, 0, 255); });
    text(verb, "--flip", "F", "largest mean FLIP error, 0 to 1",
         [this](const std::string& t) { line_.comparison.flip = number("--flip", t, 0, 1); });
    path(verb, "--out", "DIR", "for difference.png and flip.png, a map of FLIP errors",
         line_.comparison.folder);
    verb.add_flag("--json", line_.asJson, "print the figures as JSON");
  }

  void addSettings(CLI::App& verb) {
    verb.add_option("PATH", line_.settingsPath, "a setting, or a group of them (all)");
    verb.add_flag("--json", line_.asJson, "print them as JSON");
  }

  // Standard input can be read once, and two exports of one name would be one.
  void checkFiles() const {
    std::vector<std::filesystem::path> inputs = line_.noise.files;
    if (line_.scene) inputs.emplace_back(*line_.scene);
    if (line_.preset) inputs.emplace_back(*line_.preset);
    if (line_.replay) inputs.push_back(*line_.replay);
    for (const auto* files : {&line_.weatherFiles, &line_.farWeatherFiles, &line_.weather.files})
      inputs.insert(inputs.end(), files->begin(), files->end());
    if (std::ranges::count_if(inputs, core::isStandardInput) > 1)
      throw UsageError("- (standard input) can be read only once");
    if (!line_.noise.folder) return;
    std::map<std::filesystem::path, std::string> exports;
    for (const std::filesystem::path& file : line_.noise.files) {
      const auto [first, isNew] = exports.emplace(noiseExportName(file), file.string());
      if (!isNew) {
        throw UsageError("--noise: '" + first->second + "' and '" + file.string() +
                         "' would both be exported as " + first->first.string());
      }
    }
  }

  // Compass degrees to those of a pose, within its range.
  Pose poseOfCamera() const {
    const double yaw = heading_.value_or(0) - 90;
    return {*camera_, yaw < -360 ? yaw + 360 : yaw, pitch_.value_or(0), roll_.value_or(0), aboveGround_};
  }

  void checkCamera() const {
    if (camera_ && line_.pose) throw UsageError("--camera and --pose exclude each other");
    if (hud_ && noHud_) throw UsageError("--hud and --no-hud exclude each other");
    if (camera_) return;
    for (const auto& [given, flag] :
         {std::pair(heading_.has_value(), "--heading"), std::pair(pitch_.has_value(), "--pitch"),
          std::pair(roll_.has_value(), "--roll"), std::pair(aboveGround_, "--above-ground")}) {
      if (given) throw UsageError(std::string(flag) + " belongs to --camera, which is not given");
    }
  }

  // One would replace the other at the end. A device takes both.
  void checkOutputs() const {
    std::vector<std::pair<std::string, std::filesystem::path>> outputs;
    if (line_.verb == Verb::render) outputs.emplace_back("--out", line_.out);
    if (line_.stats) outputs.emplace_back("--stats", *line_.stats);
    if (line_.trace) outputs.emplace_back("--trace", *line_.trace);
    if (line_.record) outputs.emplace_back("--record", *line_.record);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      const std::filesystem::path path = outputs[i].second.lexically_normal();
      for (std::size_t j = 0; j < i; ++j) {
        if (path != outputs[j].second.lexically_normal() || path.string().starts_with("/dev/")) continue;
        throw UsageError(outputs[j].first + " and " + outputs[i].first + " name the same file");
      }
    }
  }

  void addFetch(CLI::App& verb) {
    forecast::FetchRequest& request = line_.weather.fetch;
    const auto of = [&](const std::string& flag, const std::string& form, const std::string& help,
                        std::function<void(const std::string&)> read) {
      text(verb, flag, form, "of fetch: " + help, [this, flag, read](const std::string& t) {
        fetchWords_.push_back(flag);
        read(t);
      });
    };
    of("--provider", "meteoblue|open-meteo|metar", "the service", [&request](const std::string& t) {
      constexpr std::array<std::string_view, 3> kWords = {"meteoblue", "open-meteo", "metar"};
      const auto word = std::ranges::find(kWords, t);
      if (word == kWords.end())
        throw UsageError("--provider: '" + t + "' is not one of meteoblue open-meteo metar");
      request.provider = static_cast<forecast::Provider>(word - kWords.begin());
    });
    of("--lat", "DEGREES", "latitude, north, -90 to 90",
       [&request](const std::string& t) { request.latitudeDegrees = number("--lat", t, -90, 90); });
    of("--lon", "DEGREES", "longitude, east, -180 to 180",
       [&request](const std::string& t) { request.longitudeDegrees = number("--lon", t, -180, 180); });
    of("--station", "ICAO", "whose METARs, such as LSZB",
       [&request](const std::string& t) { request.station = t; });
    of("--url", "URL", "another server, without ?...: https, or http of this machine",
       [&request](const std::string& t) {
         if (t.empty()) throw UsageError("--url: the address is empty");
         request.url = t;
       });
    const auto pathOf = [&](const std::string& flag, const std::string& form, const std::string& help,
                            std::optional<std::filesystem::path>& target) {
      of(flag, form, help, [flag, &target](const std::string& t) {
        if (t.empty()) throw UsageError(flag + ": the path is empty");
        target = t;
      });
    };
    pathOf("--key-file", "FILE", "the service's key, in a file of yours alone ($SKYDROP_METEOBLUE_KEY)",
           line_.weather.keyFile);
    pathOf("--out", "FILE|-", "write the answer there too", line_.weather.out);
  }

  void checkFetch() const {
    const auto isGiven = [&](const char* flag) {
      return std::ranges::find(fetchWords_, flag) != fetchWords_.end();
    };
    if (line_.weather.verb != WeatherVerb::fetch) {
      if (!fetchWords_.empty()) throw UsageError(fetchWords_.front() + " belongs to weather fetch");
      return;
    }
    if (!isGiven("--provider")) throw UsageError("weather fetch: --provider is required");
    if (line_.weather.fetch.provider == forecast::Provider::metar) {
      if (!isGiven("--station")) throw UsageError("weather fetch: a METAR needs --station");
    } else if (!isGiven("--lat") || !isGiven("--lon")) {
      throw UsageError("weather fetch: --lat and --lon are required");
    }
  }

  void checkWeather() const {
    if (!line_.farWeatherFiles.empty() && line_.weatherFiles.empty())
      throw UsageError("--weather-far needs --weather, the weather of the first site");
    const WeatherRequest& request = line_.weather;
    if (line_.verb != Verb::weather) return;
    checkFetch();
    if (request.verb == WeatherVerb::fetch && !request.files.empty())
      throw UsageError("weather fetch takes no files");
    if (request.verb == WeatherVerb::check && request.files.empty())
      throw UsageError("weather check: there is no file to check");
    if (request.verb == WeatherVerb::state && (!request.files.empty() || request.json || request.utc))
      throw UsageError(
          "weather state: files, --json and --utc belong to weather check; --weather FILE is flown in");
  }

  void check() const {
    checkFiles();
    if (frameBudget_ && line_.verb != Verb::fly)
      throw UsageError(std::string("--frame-budget: ") + kNoBudgetHere);
    if (line_.autopilot && line_.replay) throw UsageError("--autopilot and --replay exclude each other");
    if (line_.replay && (line_.scene || line_.seed)) {
      throw UsageError("--replay brings its own scene and seed: --scene and --seed cannot be given with it");
    }
    checkWeather();
    checkOutputs();
    if (line_.noise.check && !line_.noise.files.empty())
      throw UsageError("--check and --noise exclude each other");
    if (line_.verb != Verb::render) return;
    if (!line_.split && !splitWords_.empty())
      throw UsageError(splitWords_.front() + " belongs to --split, which is not given");
    if (!countsFrames(line_.out) && line_.frames - line_.firstFrame > 1) {
      throw UsageError("--out: '" + line_.out + "' needs %d for several frames");
    }
    if (line_.out != "-" && !line_.out.ends_with(".png"))
      throw UsageError("--out: '" + line_.out + "' does not end in .png");
  }

  // A scene that cannot be read is left out and complained of: the others are there all the same.
  ParsedCommandLine sceneList() const {
    ParsedCommandLine list{line_, "", {}};
    for (const std::string& name : scene::listScenes()) {
      try {
        const scene::Scene scene = scene::loadScene(scene::sceneFile(name).string());
        *list.answer += core::printable(name) + "\t" + core::printable(scene.description) + "\n";
      } catch (const core::DataError& error) {
        list.complaints.emplace_back(error.what());
      }
    }
    return list;
  }

  CommandLine line_;
  bool version_ = false, listScenes_ = false;
  std::optional<glm::dvec3> camera_;
  std::optional<double> heading_, pitch_, roll_;
  std::optional<std::string> frameBudget_;
  NoiseWords noiseWords_;
  std::vector<std::string> fetchWords_;  // flags that belong to weather fetch
  std::vector<std::string> splitWords_;  // flags that belong to --split
  bool aboveGround_ = false, hud_ = false, noHud_ = false;
  CLI::App app_{"Fly over endless land and drop packages on targets.", "skydrop"};
};

}  // namespace

ParsedCommandLine parseCommandLine(int argc, const char* const* argv) {
  Parser parser;
  return parser.parse(argc, argv);
}

std::string noiseExportName(const std::filesystem::path& file) {
  return core::isStandardInput(file) ? "stdin" : file.stem().string();
}

std::string framePath(const std::string& pattern, int frame) {
  const std::size_t name = nameAt(pattern);
  std::string path = pattern.substr(0, name);
  for (std::size_t i = name; i < pattern.size(); ++i) {
    if (pattern[i] != '%') {
      path += pattern[i];
    } else if (pattern[++i] == 'd') {
      path += std::to_string(frame);
    } else {
      path += '%';
    }
  }
  return path;
}

}  // namespace skydrop::app
