// The command line as a value: what the program was asked to do. cli/command_line_parser.h makes it from
// words.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/types/lab_request.h"
#include "app/types/photo_request.h"
#include "app/types/pose.h"
#include "app/types/report_format.h"
#include "app/types/size.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/elevation/projection.h"
#include "skydrop/forecast/fetch.h"
#include "skydrop/noise/noise_generator.h"
#include "skydrop/noise/noise_recipe.h"
#include "skydrop/render/gl/backend.h"
#include "skydrop/sky/almanac.h"

namespace skydrop::app {

enum class Verb {
  fly,
  render,
  simulate,
  accuracy,
  noise,
  sky,
  weather,
  elevation,
  lab,
  info,
  compare,
  settings
};

inline constexpr const char* kDefaultScene = "fair";

enum class NoiseFormat { dds, dx10, png };

// A texture of gradient noise to be made; what the parser let through is in range.
struct NoiseTextureRequest {
  noise::NoiseRecipe recipe;
  noise::NoiseSize size;
  core::TexelFormat texels = core::TexelFormat::a8;
};

struct NoiseRequest {
  bool check = false;
  bool tool = false;                            // opens it, or draws a picture of it to `file`
  std::optional<NoiseTextureRequest> texture;   // --generate, or what the tool begins with
  std::string file;                             // that it goes to: .dds or .png, or "-"
  std::vector<std::filesystem::path> files;     // to read instead of making
  std::optional<std::filesystem::path> folder;  // to export to
  NoiseFormat format = NoiseFormat::dx10;
};

// Two pictures, and how far they may differ: in steps of 8 bits, and in mean FLIP, [0, 1].
struct PictureComparison {
  std::vector<std::filesystem::path> files;  // the picture and the reference
  std::optional<int> most;
  std::optional<double> mean, flip;
  std::optional<std::filesystem::path> folder;  // for pictures of the difference
};

// What `skydrop weather` does: tells the state at a point, checks files, or fetches one.
enum class WeatherVerb { state, check, fetch };
inline constexpr std::array<std::string_view, 3> kWeatherVerbs = {"state", "check", "fetch"};

struct WeatherRequest {
  WeatherVerb verb = WeatherVerb::state;
  std::vector<std::filesystem::path> files;  // to check
  std::optional<sky::Instant> utc;           // about when reports were made, which name no month
  forecast::FetchRequest fetch;              // without its key
  std::optional<std::filesystem::path> keyFile, out;
};

// Where one flies from: by degrees, or by a name of assets/places.json.
struct PlaceRequest {
  elevation::GeoPlace place;
  std::optional<double> heightM;  // above the ground
};

// A place to ask elevation files about: degrees, or coordinates of the first file's system.
struct ElevationRequest {
  std::vector<std::filesystem::path> files;
  std::vector<glm::dvec2> at;  // north, east in degrees where both can be that; else east, north in metres
};

// The service whose weather is flown in and renewed.
struct LiveRequest {
  forecast::FetchRequest fetch;  // without its key
  std::optional<std::filesystem::path> keyFile;
};

struct CommandLine {
  Verb verb = Verb::fly;

  // Of scene, preset, replay and noise.files at most one is "-", standard input.
  std::optional<std::string> scene;   // kDefaultScene unless told; a replay brings its own
  std::optional<std::string> preset;  // a name or a file; below `set`
  std::vector<std::string> set;       // PATH=VALUE, in order
  std::optional<std::uint64_t> seed;
  std::optional<int> workers;  // 1 .. 64; unless told cores - 1, and all of them to render
  std::optional<std::filesystem::path> userDir, stats, replay, record;
  std::vector<std::filesystem::path> weatherFiles,
      farWeatherFiles;  // forecasts; far ones only with near ones
  std::vector<std::filesystem::path> elevationFiles, imageFiles;
  std::optional<elevation::ImageCorners> imageCorners;  // of the one image
  std::optional<PlaceRequest> start;                    // --place
  std::optional<elevation::GeoPlace> lookAt;            // needs a start
  bool autopilot = false;

  // fly
  bool fullscreen = false;
  std::optional<LiveRequest> live;

  // fly and render
  std::optional<Size> size;
  std::optional<Pose> pose;  // --pose, or --camera and what belongs to it

  // render, simulate, accuracy and noise
  bool progress = false;  // also where standard error is no terminal

  // render
  std::optional<render::gl::Backend> backend;  // unset: EGL, or OSMesa where EGL gives no OpenGL 4.5
  std::string out = "skydrop.png";
  int frames = 1;      // how many there are
  int firstFrame = 0;  // of those, from which on they are drawn
  double fps = 60;     // simulated frames a second, (0, 1000]
  double timeS = 0;    // simulated seconds before the first frame
  bool menu = false;
  std::optional<PhotoRequest> photo;
  std::optional<std::string> split;  // SUBJECT=REFERENCE that the picture is compared with

  // simulate
  static constexpr double kDefaultSeconds = 60;
  std::optional<double> seconds;  // unless told kDefaultSeconds, and the whole of a replay
  std::optional<std::filesystem::path> trace;

  NoiseRequest noise;

  // sky
  sky::Instant utc;
  sky::Place place;

  // weather
  WeatherRequest weather;
  glm::dvec3 weatherAt{0, 500, 0};  // m; its time is timeS

  LabRequest lab;
  ElevationRequest elevation;

  // accuracy
  std::vector<std::string> studies;
  std::vector<std::string> scenes;  // that the study cost measures; none named: all
  bool quick = false;               // smaller pictures, fewer repetitions
  bool resume = false;
  int part = 1, parts = 1;                   // the share of the cases that is measured, 1 .. parts
  std::vector<std::filesystem::path> merge;  // folders of shares to make one report of
  ReportFormat reportFormat = ReportFormat::markdown;

  // info
  std::optional<std::filesystem::path> picture;  // what its file says, instead of the machine

  // compare
  PictureComparison comparison;

  // settings
  std::string settingsPath;  // of a setting or a group; empty: all of them

  // compare, settings, weather check and elevation check
  bool asJson = false;
};

// Why the verbs without a window take no frame budget.
inline constexpr const char* kNoBudgetHere =
    "a picture or a simulated flight does not depend on the time that it takes; a flight in the window holds "
    "a "
    "budget, with --autopilot too";

// Whether the words set this setting, by --set or by a flag that stands for it.
bool sets(const CommandLine& line, std::string_view path);

}  // namespace skydrop::app
