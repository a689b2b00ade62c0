// The command line as a value. Everything that can be judged from the words alone is judged here: an unknown
// flag, a size that is none, a number out of range. Paths and values of --set are judged in settings.h, which
// knows them; both throw core::UsageError (exit code 2).
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace skydrop::app {

enum class Verb { fly, render, simulate, accuracy, noise, info };
enum class Backend { egl, osmesa, window };

inline constexpr int kMaxSide = 16384;  // what images (core/image.h) and GL 4.5 targets can hold

struct Size {
  int width = 0, height = 0;  // pixels, 1 .. kMaxSide
};

// A camera in the world: metres; degrees; yaw 0 looks along +x (east) and grows towards +z (south), pitch up,
// roll right. A compass heading is yaw + 90.
struct Pose {
  glm::dvec3 position{0};
  double yawDegrees = 0, pitchDegrees = 0, rollDegrees = 0;
  bool aboveGround = false;  // position.y is counted from the surface, land or sea
};

inline constexpr const char* kDefaultScene = "fair";

enum class NoiseFormat { dds, dx10, png };

struct NoiseRequest {
  bool check = false;
  std::vector<std::filesystem::path> files;     // to read instead of making
  std::optional<std::filesystem::path> folder;  // to export to
  NoiseFormat format = NoiseFormat::dx10;
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
  bool autopilot = false;

  // fly
  bool fullscreen = false;

  // fly and render
  std::optional<Size> size;
  std::optional<Pose> pose;  // --pose, or --camera and what belongs to it

  // render, simulate, accuracy and noise
  bool progress = false;  // also where standard error is no terminal

  // render
  std::optional<Backend> backend;  // unset: EGL, or OSMesa where EGL gives no OpenGL 4.5
  std::string out = "skydrop.png";
  int frames = 1;
  double fps = 60;   // simulated frames a second, (0, 1000]
  double timeS = 0;  // simulated seconds before the first frame
  bool menu = false;

  // simulate
  static constexpr double kDefaultSeconds = 60;
  std::optional<double> seconds;  // unless told kDefaultSeconds, and the whole of a replay
  std::optional<std::filesystem::path> trace;

  NoiseRequest noise;

  // accuracy
  std::vector<std::string> studies;
};

struct ParsedCommandLine {
  CommandLine commandLine;
  std::optional<std::string> answer;    // --help, --version, --list-scenes: print it and end with 0,
  std::vector<std::string> complaints;  // or, after these lines on stderr, with 1
};

ParsedCommandLine parseCommandLine(int argc, const char* const* argv);

// Whether the words set this setting, by --set or by a flag that stands for it.
bool sets(const CommandLine& line, std::string_view path);

// What the export of a DDS file is called, without its ending.
std::string noiseExportName(const std::filesystem::path& file);

// In the name of the pattern's file, not of its folders, "%d" becomes the frame's number and "%%" a percent sign;
// any other use of % was refused by parseCommandLine().
std::string framePath(const std::string& pattern, int frame);

}  // namespace skydrop::app
