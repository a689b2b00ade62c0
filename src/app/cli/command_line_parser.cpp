#include "app/cli/command_line_parser.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "app/cli/accuracy_flags.h"
#include "app/cli/elevation_flags.h"
#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "app/cli/frame_path.h"
#include "app/cli/lab_flags.h"
#include "app/cli/live_flags.h"
#include "app/cli/noise_flags.h"
#include "app/cli/photo_flags.h"
#include "app/cli/weather_flags.h"
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
    liveFlags_.add(app_, line_);
    CLI::App* render = app_.add_subcommand("render", "frames to PNG files, no window needed");
    CLI::App* simulate = app_.add_subcommand("simulate", "no graphics: physics and game only");
    CLI::App* accuracy = app_.add_subcommand("accuracy", "measure error against time, write the report");
    CLI::App* noise = app_.add_subcommand(
        "noise", "make, check, export and read noise: the clouds' own, and textures of any settings");
    CLI::App* sky = app_.add_subcommand("sky", "where sun and moon stand at a place and time, as JSON");
    CLI::App* weather =
        app_.add_subcommand("weather", "the state of a scene's air at a place and time, as JSON");
    CLI::App* info =
        app_.add_subcommand("info", "versions, OpenGL renderer, limits; or how a picture was made");
    CLI::App* lab = app_.add_subcommand(
        "lab", "the laboratory: what clouds are made of, page by page, with cost and error");
    CLI::App* elevation =
        app_.add_subcommand("elevation", "what elevation files hold, and heights at places");
    CLI::App* compare =
        app_.add_subcommand("compare", "how far two pictures differ; exit code 1 where it is too far");
    CLI::App* settings =
        app_.add_subcommand("settings", "every setting with default, range and what it does");
    const std::vector<CLI::App*> verbs = {render,    simulate, accuracy, noise,   sky,     weather,
                                          elevation, lab,      info,     compare, settings};
    for (CLI::App* verb : verbs) verb->set_help_flag("--help", "print this help");
    app_.footer(kExitCodes);
    for (CLI::App* verb : verbs) verb->footer(kExitCodes);
    addCommon(*render);
    addRender(*render);
    addCommon(*simulate);
    addSimulate(*simulate);
    addSeed(*noise, "the noise's seed (0); its lower 32 bits");
    noiseFlags_.add(*noise, line_);
    addSize(*noise);
    addSky(*sky);
    addWeather(*weather);
    addLabFlags(*lab, line_);
    addSet(*lab);
    addSize(*lab);
    elevationFlags_.addCheck(*elevation, line_);
    for (CLI::App* verb : {render, simulate, accuracy, noise}) {
      verb->add_flag("--progress", line_.progress,
                     "tell how far it is, each second, where there is no terminal");
    }
    addAccuracyFlags(*accuracy, line_);
    addSize(*accuracy);
    addText(*info, "--backend", "egl|osmesa|window", "the back-end to ask",
            [this](const std::string& t) { line_.backend = parseBackend(t); });
    info->add_option("PICTURE", line_.picture, "a PNG file: print what it says about how it was made");
    addCompare(*compare);
    addSettings(*settings);
    app_.require_subcommand(0, 1);
    render->callback([this] { line_.verb = Verb::render; });
    simulate->callback([this] { line_.verb = Verb::simulate; });
    accuracy->callback([this] { line_.verb = Verb::accuracy; });
    noise->callback([this] { line_.verb = Verb::noise; });
    sky->callback([this] { line_.verb = Verb::sky; });
    weather->callback([this] { line_.verb = Verb::weather; });
    lab->callback([this] { line_.verb = Verb::lab; });
    elevation->callback([this] { line_.verb = Verb::elevation; });
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
    noiseFlags_.finish(line_);
    check();
    checkCamera();
    if (camera_) line_.pose = poseOfCamera();
    elevationFlags_.finish(line_, line_.pose.has_value());
    // After every --set: the flag is the shorter word for the same.
    if (frameBudget_) line_.set.push_back("view.frameBudgetMs=" + *frameBudget_);
    // Before every other word, so that --no-effect weather and --set are heard. A replay has its effects.
    if ((!line_.weatherFiles.empty() || line_.live) && !line_.replay)
      line_.set.insert(line_.set.begin(), "effects.weather=true");
    if (hud_ || noHud_) line_.set.push_back(std::string("view.hud=") + (hud_ ? "true" : "false"));
    return {line_, std::nullopt, {}};
  }

 private:
  void addScene(CLI::App& verb) {
    addText(verb, "--scene", "NAME|FILE|-",
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
    addText(verb, "--preset", "NAME|FILE|-",
            "a preset that the menu saved, for this run; --set comes after it", [this](const std::string& t) {
              if (t.empty()) throw UsageError("--preset: the name is empty");
              line_.preset = t;
            });
    addSet(verb);
    addEffect(verb, "--effect", true,
              "switch an effect on that the scene does not call for (effects.NAME=true)");
    addEffect(verb, "--no-effect", false, "switch an effect off (effects.NAME=false)");
    addSeed(verb, "the world's seed instead of the scene's");
    addText(verb, "--workers", "N", "threads that make terrain (cores - 1)",
            [this](const std::string& t) { line_.workers = integer("--workers", t, 1, 64); });
    addWeatherFiles(verb);
    elevationFlags_.addLand(verb, line_, true);
    addPath(verb, "--user-dir", "DIR", "the player's settings", line_.userDir);
    addPath(verb, "--stats", "FILE|-", "write what was measured, as JSON; - is standard output", line_.stats);
    addPath(verb, "--replay", "FILE|-", "fly a recorded input log, and compare", line_.replay);
    addPath(verb, "--record", "FILE|-", "record the flight as an input log; FILE must be new or empty",
            line_.record);
    addText(
        verb, "--frame-budget", "MS",
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
      addFiles(verb, flag, flag, help, target)->allow_extra_args(false)->expected(1, 100);
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
    addText(verb, "--seed", "N", help, [this](const std::string& t) {
      line_.seed = wholeText<std::uint64_t>(t);
      if (const auto negative = wholeText<std::int64_t>(t); !line_.seed && negative) {
        line_.seed = static_cast<std::uint64_t>(*negative);
      }
      if (!line_.seed) throw UsageError("--seed: '" + t + "' is not a whole number of 64 bits");
    });
  }

  void addSize(CLI::App& verb) {
    addText(verb, "--size", "WxH", "pixels", [this](const std::string& t) { line_.size = parseSize(t); });
  }

  void addView(CLI::App& verb) {
    addSize(verb);
    addText(verb, "--camera", "X,Y,Z", "a camera in the world: metres, +X east, Y up, -Z north",
            [this](const std::string& t) { camera_ = parseCamera(t); });
    const auto angle = [&](const std::string& flag, std::optional<double>& target, double most,
                           const std::string& help) {
      addText(verb, flag, "DEGREES", help,
              [flag, &target, most](const std::string& t) { target = number(flag, t, -most, most); });
    };
    angle("--heading", heading_, 360, "of --camera by the compass: 0 north, 90 east (0)");
    angle("--pitch", pitch_, 90, "of --camera, up (0)");
    angle("--roll", roll_, 360, "of --camera, right side down (0)");
    verb.add_flag("--above-ground", aboveGround_, "Y of --camera is counted from the surface, land or sea");
    addText(verb, "--pose", "X,Y,Z,YAW,PITCH,ROLL",
            "the same in one word; YAW 0 looks east, 90 south: the compass heading less 90",
            [this](const std::string& t) { line_.pose = parsePose(t); });
    verb.add_flag("--hud", hud_,
                  "with the HUD, which a camera in the world leaves out of pictures (view.hud=true)");
    verb.add_flag("--no-hud", noHud_, "without the HUD (view.hud=false)");
  }

  void addFly(CLI::App& verb) {
    addView(verb);
    verb.add_flag("--fullscreen", line_.fullscreen, "fill the screen");
    photoFlags_.addWindow(verb, line_);
  }

  void addRender(CLI::App& verb) {
    addText(verb, "--backend", "egl|osmesa|window", "what gives the OpenGL context",
            [this](const std::string& t) { line_.backend = parseBackend(t); });
    addView(verb);
    addText(verb, "--out", "FILE.png|-",
            "the picture; in its name %d is the frame's number and %% a percent sign",
            [this](const std::string& t) { line_.out = t; });
    addText(verb, "--frames", "N|A..B",
            "how many (1), or the first and the last of those that are drawn, from 0 on",
            [this](const std::string& t) { parseFrames(t); });
    addText(verb, "--fps", "N", "simulated frames a second (60)",
            [this](const std::string& t) { line_.fps = number("--fps", t, 1e-3, 1000); });
    addText(verb, "--time", "S", "simulated seconds before the first frame (0)",
            [this](const std::string& t) { line_.timeS = number("--time", t, 0, kMaxSeconds); });
    verb.add_flag("--menu", line_.menu, "with the menu open");
    addSplit(verb);
    photoFlags_.add(verb, line_);
  }

  // --heat and --divider are shorter words for --set.
  void addSplit(CLI::App& verb) {
    addText(verb, "--split", "SUBJECT=REFERENCE",
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
    addText(verb, "--divider", "X", "of --split: where it is, 0 to 1 of the width (view.split.divider=X)",
            [this](const std::string& t) {
              splitWords_.emplace_back("--divider");
              line_.set.push_back("view.split.divider=" + std::to_string(number("--divider", t, 0, 1)));
            });
  }

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
    addPath(verb, "--trace", "FILE.csv|-", "write every step of the flight as a row of numbers", line_.trace);
    addText(verb, "--seconds", "S", "how long (60; a replay to its end)",
            [this](const std::string& t) { line_.seconds = number("--seconds", t, 0, kMaxSeconds); });
    addText(verb, "--fps", "N", "the drawing rate that is imitated (60)",
            [this](const std::string& t) { line_.fps = number("--fps", t, 1e-3, 1000); });
  }

  void addSky(CLI::App& verb) {
    addText(verb, "--utc", "TIME", "ISO 8601, such as 2026-06-21T12:00:00Z, in the years 1000 to 3000",
            [this](const std::string& t) { line_.utc = parseUtc(t); });
    addText(verb, "--lat", "DEGREES", "latitude, north, -90 to 90",
            [this](const std::string& t) { line_.place.latitudeDegrees = number("--lat", t, -90, 90); });
    addText(verb, "--lon", "DEGREES", "longitude, east, -360 to 360",
            [this](const std::string& t) { line_.place.longitudeDegrees = number("--lon", t, -360, 360); });
    for (const char* flag : {"--utc", "--lat", "--lon"}) verb.get_option(flag)->required();
  }

  void addWeather(CLI::App& verb) {
    weatherFlags_.add(verb, line_);
    addScene(verb);
    addSet(verb);
    addWeatherFiles(verb);
    elevationFlags_.addLand(verb, line_, false);
    addSeed(verb, "the world's seed instead of the scene's");
    addText(verb, "--time", "S", "simulated seconds (0)",
            [this](const std::string& t) { line_.timeS = number("--time", t, 0, kLongestWeatherS); });
    addText(verb, "--at", "X,Y,Z", "where: metres, +X east, Y above the sea, -Z north (0,500,0)",
            [this](const std::string& t) { line_.weatherAt = parseAt(t); });
  }

  void addCompare(CLI::App& verb) {
    verb.add_option("PICTURE REFERENCE", line_.comparison.files, "two PNG files of one size")
        ->required()
        ->expected(2);
    addText(verb, "--max", "N", "most that any channel may differ by, 0 to 255",
            [this](const std::string& t) { line_.comparison.most = integer("--max", t, 0, 255); });
    addText(verb, "--mean", "M", "most that channels may differ by in the mean, 0 to 255",
            [this](const std::string& t) { line_.comparison.mean = number("--mean", t, 0, 255); });
    addText(verb, "--flip", "F", "largest mean FLIP error, 0 to 1",
            [this](const std::string& t) { line_.comparison.flip = number("--flip", t, 0, 1); });
    addPath(verb, "--out", "DIR", "for difference.png and flip.png, a map of FLIP errors",
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
    if (line_.photo && line_.photo->table) outputs.emplace_back("--photo-table", *line_.photo->table);
    if (line_.photo && line_.photo->plot) outputs.emplace_back("--photo-plot", *line_.photo->plot);
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

  void check() const {
    checkFiles();
    if (frameBudget_ && line_.verb != Verb::fly)
      throw UsageError(std::string("--frame-budget: ") + kNoBudgetHere);
    if (line_.autopilot && line_.replay) throw UsageError("--autopilot and --replay exclude each other");
    if (line_.replay && (line_.scene || line_.seed)) {
      throw UsageError("--replay brings its own scene and seed: --scene and --seed cannot be given with it");
    }
    weatherFlags_.check(line_);
    liveFlags_.check(line_);
    photoFlags_.check(line_);
    checkOutputs();
    if (line_.verb == Verb::lab) checkLab(line_);
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
  NoiseFlags noiseFlags_;
  WeatherFlags weatherFlags_;
  ElevationFlags elevationFlags_;
  LiveFlags liveFlags_;
  PhotoFlags photoFlags_;
  std::vector<std::string> splitWords_;  // flags that belong to --split
  bool aboveGround_ = false, hud_ = false, noHud_ = false;
  CLI::App app_{"Fly over endless land and drop packages on targets.", "skydrop"};
};

}  // namespace

ParsedCommandLine parseCommandLine(int argc, const char* const* argv) {
  Parser parser;
  return parser.parse(argc, argv);
}

}  // namespace skydrop::app
