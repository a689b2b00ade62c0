#include "app/cli/photo_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

using core::UsageError;

namespace {

PhotoRequest& requestOf(CommandLine& line) { return line.photo ? *line.photo : line.photo.emplace(); }

PhotoView viewOf(const std::string& t) {
  const auto view = std::ranges::find(kPhotoViewNames, t);
  if (view == kPhotoViewNames.end() || view == kPhotoViewNames.begin())
    throw UsageError("--photo-view: '" + t + "' is not one of overlay wipe beside");
  return static_cast<PhotoView>(view - kPhotoViewNames.begin());
}

}  // namespace

// Where it lies, for both.
void PhotoFlags::addPlace(CLI::App& verb, CommandLine& line, const std::string& of) {
  addText(verb, "--photo-field", "DEGREES", of + "its horizontal field of view (that of the picture)",
          [this, &line](const std::string& t) {
            words_.emplace_back("--photo-field");
            requestOf(line).fieldDegrees = number("--photo-field", t, 1, 170);
          });
  addText(verb, "--photo-panorama", "DEGREES",
          of + "it goes round the horizon, from this heading at its left edge on",
          [this, &line](const std::string& t) {
            words_.emplace_back("--photo-panorama");
            requestOf(line).panoramaFromDegrees = number("--photo-panorama", t, -360, 360);
          });
}

// View and share are rows of the menu.
void PhotoFlags::addWindow(CLI::App& verb, CommandLine& line) {
  addText(verb, "--photo", "FILE", "a photograph over the picture, PNG or JPEG: view.photo says how",
          [&line](const std::string& t) {
            if (t.empty()) throw UsageError("--photo: the path is empty");
            requestOf(line).file = t;
          });
  addPlace(verb, line, "of --photo: ");
  addText(verb, "--photo-view", "overlay|wipe|beside", "of --photo: how it is shown (view.photo)",
          [this, &line](const std::string& t) {
            words_.emplace_back("--photo-view");
            requestOf(line).view = viewOf(t);
            line.set.push_back("view.photo=" + t);
          });
  addText(verb, "--photo-share", "S",
          "of --photo: its opacity, or the share of the width that it has (view.photoShare)",
          [this, &line](const std::string& t) {
            words_.emplace_back("--photo-share");
            requestOf(line).share = number("--photo-share", t, 0, 1);
            line.set.push_back("view.photoShare=" + t);
          });
}

void PhotoFlags::add(CLI::App& verb, CommandLine& line) {
  verb.add_option_function<std::vector<std::string>>(
          "--compare",
          [&line](const std::vector<std::string>& all) {
            PhotoRequest& request = requestOf(line);
            for (const std::string& t : all) {
              if (t.empty()) throw UsageError("--compare: the path is empty");
              if (request.file.empty())
                request.file = t;
              else
                request.others.emplace_back(t);
            }
          },
          "a photograph, PNG or JPEG: how far its brightness, hue and colours are from those of the picture; "
          "of several the one whose name has the time that is nearest to the frame's")
      ->type_name("PHOTO..")
      ->expected(1, 10000);
  addPlace(verb, line, "of --compare: ");
  const auto of = [&](const std::string& flag, const std::string& form, const std::string& help,
                      std::function<void(const std::string&, PhotoRequest&)> read) {
    addText(verb, flag, form, "of --compare: " + help, [this, &line, flag, read](const std::string& t) {
      words_.push_back(flag);
      if (t.empty()) throw UsageError(flag + ": the path is empty");
      read(t, requestOf(line));
    });
  };
  of("--photo-view", "overlay|wipe|beside", "write the picture with the photograph",
     [](const std::string& t, PhotoRequest& request) { request.view = viewOf(t); });
  of("--photo-share", "S", "0 to 1: its opacity, or the share of the width that it has from the left (.5)",
     [](const std::string& t, PhotoRequest& request) { request.share = number("--photo-share", t, 0, 1); });
  of("--photo-mask", "frame|photo|FILE",
     "what counts: the sky of the frame, what looks like sky in the photograph, or where a picture of the "
     "photograph's size is white",
     [](const std::string& t, PhotoRequest& request) {
       request.sky = t == "frame" ? PhotoSky::frame : t == "photo" ? PhotoSky::photo : PhotoSky::all;
       request.mask.reset();
       if (request.sky == PhotoSky::all) request.mask = t;
     });
  of("--photo-table", "FILE", "the distances of each frame as CSV",
     [](const std::string& t, PhotoRequest& request) { request.table = t; });
  of("--photo-plot", "FILE.svg|FILE.png", "the distances over the frames",
     [](const std::string& t, PhotoRequest& request) { request.plot = t; });
}

void PhotoFlags::check(const CommandLine& line) const {
  if (!line.photo) return;
  if (line.photo->file.empty())
    throw UsageError(words_.front() + " belongs to " + (line.verb == Verb::fly ? "--photo" : "--compare") +
                     ", which is not given");
  if (line.photo->fieldDegrees && line.photo->panoramaFromDegrees)
    throw UsageError("--photo-field and --photo-panorama exclude each other");
  if (line.split) throw UsageError("--compare and --split exclude each other");
}

}  // namespace skydrop::app
