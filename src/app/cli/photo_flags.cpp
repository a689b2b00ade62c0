#include "app/cli/photo_flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

#include "app/cli/flag_options.h"
#include "app/cli/flag_values.h"
#include "skydrop/core/error.h"

namespace skydrop::app {

using core::UsageError;

void PhotoFlags::add(CLI::App& verb, CommandLine& line) {
  const auto requestOf = [&line]() -> PhotoRequest& {
    return line.photo ? *line.photo : line.photo.emplace();
  };
  addText(verb, "--compare", "PHOTO",
          "a photograph, PNG or JPEG: how far its brightness, hue and colours are from those of the picture",
          [requestOf](const std::string& t) {
            if (t.empty()) throw UsageError("--compare: the path is empty");
            requestOf().file = t;
          });
  const auto of = [&](const std::string& flag, const std::string& form, const std::string& help,
                      std::function<void(const std::string&, PhotoRequest&)> read) {
    addText(verb, flag, form, "of --compare: " + help, [this, requestOf, flag, read](const std::string& t) {
      words_.push_back(flag);
      read(t, requestOf());
    });
  };
  of("--photo-view", "overlay|wipe|beside", "write the picture with the photograph",
     [](const std::string& t, PhotoRequest& request) {
       const auto view = std::ranges::find(kPhotoViewNames, t);
       if (view == kPhotoViewNames.end() || view == kPhotoViewNames.begin())
         throw UsageError("--photo-view: '" + t + "' is not one of overlay wipe beside");
       request.view = static_cast<PhotoView>(view - kPhotoViewNames.begin());
     });
  of("--photo-share", "S", "0 to 1: its opacity, or the share of the width that it has from the left (.5)",
     [](const std::string& t, PhotoRequest& request) { request.share = number("--photo-share", t, 0, 1); });
  of("--photo-field", "DEGREES", "its horizontal field of view (that of the picture)",
     [](const std::string& t, PhotoRequest& request) {
       request.fieldDegrees = number("--photo-field", t, 1, 170);
     });
  of("--photo-panorama", "DEGREES", "it goes round the horizon, from this heading at its left edge on",
     [](const std::string& t, PhotoRequest& request) {
       request.panoramaFromDegrees = number("--photo-panorama", t, -360, 360);
     });
  const auto path = [&](const std::string& flag, const std::string& help,
                        std::optional<std::filesystem::path> PhotoRequest::*target) {
    of(flag, "FILE", help, [flag, target](const std::string& t, PhotoRequest& request) {
      if (t.empty()) throw UsageError(flag + ": the path is empty");
      request.*target = t;
    });
  };
  path("--photo-mask", "a picture of the photograph's size: white is what counts, the sky",
       &PhotoRequest::mask);
  path("--photo-table", "the distances of each frame as CSV", &PhotoRequest::table);
  path("--photo-plot", "the distances over the frames as PNG", &PhotoRequest::plot);
}

void PhotoFlags::check(const CommandLine& line) const {
  if (!line.photo) return;
  if (line.photo->file.empty())
    throw UsageError(words_.front() + " belongs to --compare, which is not given");
  if (line.photo->fieldDegrees && line.photo->panoramaFromDegrees)
    throw UsageError("--photo-field and --photo-panorama exclude each other");
  if (line.split) throw UsageError("--compare and --split exclude each other");
}

}  // namespace skydrop::app
