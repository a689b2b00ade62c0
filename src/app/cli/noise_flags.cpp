#include "app/cli/noise_flags.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

using core::UsageError;

// A file takes the place of the folder.
void takeFile(NoiseRequest& request, const std::string& ending, bool mayBeStream) {
  request.file = request.folder->string();
  request.folder.reset();
  if (!(mayBeStream && request.file == "-") && !request.file.ends_with(ending))
    throw UsageError("--out: '" + request.file + "' does not end in " + ending);
}

}  // namespace

void NoiseFlags::add(CLI::App& verb, CommandLine& line) {
  verb.add_flag("--check", line.noise.check,
                "make all by processor and by shader, compare them, look for seams");
  addFiles(verb, "--noise", "--noise",
           "read these DDS files (-: standard input) instead of making; may stand several times",
           line.noise.files)
      ->allow_extra_args(false)
      ->expected(1, 1000);
  addPath(verb, "--out", "DIR|FILE",
          "export to this folder; with --generate the file, .dds or .png (-: standard output)",
          line.noise.folder);
  addTexture(verb, line);
  addText(verb, "--format", "dds|dx10|png",
          "of the export (dx10): DDS with legacy or DX10 header, slices as PNG",
          [&line](const std::string& t) { line.noise.format = parseNoiseFormat(t); });
  addText(verb, "--backend", "egl|osmesa|window",
          "what runs the shader of --check, and draws the picture of --tool",
          [&line](const std::string& t) { line.backend = parseBackend(t); });
}

void NoiseFlags::addTexture(CLI::App& verb, CommandLine& line) {
  NoiseWords& words = words_;
  verb.add_flag("--tool", line.noise.tool,
                "open the tool that makes such noise, with these settings or the file of --noise; with "
                "--out FILE.png "
                "a picture of it, without a window");
  addText(verb, "--generate", "2d|3d", "make a texture or a volume of gradient noise (docs/noise.md) instead",
          [&words](const std::string& t) {
            if (t != "2d" && t != "3d") throw UsageError("--generate: '" + t + "' is not one of 2d 3d");
            words.volume = t == "3d";
          });
  const auto whole = [&](const std::string& flag, std::optional<int>& target, const std::string& help) {
    addText(verb, flag, "N", help, [flag, &target, &words](const std::string& t) {
      constexpr int kMost = std::numeric_limits<int>::max();
      target = integer(flag, t, -kMost, kMost);
      words.flags.push_back(flag);
    });
  };
  const auto real = [&](const std::string& flag, std::optional<double>& target, const std::string& help) {
    addText(verb, flag, "X", help, [flag, &target, &words](const std::string& t) {
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
  real("--cutoff", words.cutoff, "cut to clouds: values up to this one are 0 (not cut; 0.5 with --density)");
  real("--density", words.density,
       "cut to clouds: 1 - density^(255 (value - cutoff)) above (0.96 with --cutoff)");
  whole("--bits", words.bits, "of a texel: 8, 16, or 32 for floats (8)");
  addText(verb, "--channel", "alpha|luminance", "what the texels are (alpha; luminance with 16 and 32 bits)",
          [&words](const std::string& t) {
            if (t != "alpha" && t != "luminance")
              throw UsageError("--channel: '" + t + "' is not one of alpha luminance");
            words.alpha = t == "alpha";
            words.flags.emplace_back("--channel");
          });
}

void NoiseFlags::finish(CommandLine& line) const {
  NoiseRequest& request = line.noise;
  if (request.tool) return finishTool(line);
  if (line.verb == Verb::noise && line.size) throw UsageError("--size belongs to --tool, which is not given");
  if (!words_.volume) {
    if (!words_.flags.empty())
      throw UsageError(words_.flags.front() + " belongs to --generate or --tool, which are not given");
    return;
  }
  if (request.check || !request.files.empty()) throw UsageError("--generate excludes --check and --noise");
  request.texture = noiseTexture(words_, line.seed.value_or(0));
  if (!request.folder) throw UsageError("--generate needs --out FILE");
  const bool png = request.format == NoiseFormat::png;
  if (png && core::texelBytes(request.texture->texels) != 1) throw UsageError("--format png holds 8 bits");
  takeFile(request, png ? ".png" : ".dds", !png || !request.texture->size.isVolume());
}

void NoiseFlags::finishTool(CommandLine& line) const {
  NoiseRequest& request = line.noise;
  if (request.check) throw UsageError("--tool and --check exclude each other");
  if (request.files.size() > 1) throw UsageError("--tool opens one file of --noise");
  for (const std::string& flag : words_.flags) {
    if (flag == "--width" || flag == "--height" || flag == "--slices" || flag == "--bits" ||
        flag == "--channel")
      throw UsageError(flag + " does not go with --tool, which has it among its rows");
  }
  request.texture = noiseTexture(words_, line.seed.value_or(0));
  if (request.folder) takeFile(request, ".png", true);
}

}  // namespace skydrop::app
