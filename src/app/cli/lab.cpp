// skydrop lab: the pages of the laboratory, in a window or as pictures.
#include <filesystem>
#include <memory>

#include "app/cli/verbs.h"
#include "app/console/standard_output.h"
#include "app/measure/stopwatch.h"
#include "app/session/open_context.h"
#include "app/window/laboratory_run.h"
#include "skydrop/core/error.h"
#include "skydrop/core/file.h"
#include "skydrop/core/output_file.h"
#include "skydrop/lab/page.h"
#include "skydrop/render/lab/page_picture.h"

namespace skydrop::app {
namespace {

constexpr Size kUsualSize{640, 360};
constexpr int kTimed = 3;

// A page with its picture, as the gallery has it.
struct Drawn {
  core::Image picture;
  lab::Figures figures;
  double milliseconds = 0;  // of a frame, once compiled: the least of a few
};

Drawn drawPage(render::gl::Context& context, const lab::Page& page, const lab::Knobs& knobs, Size size,
               bool timed) {
  const std::vector<lab::Curve> curves = page.plot ? page.plot(knobs) : std::vector<lab::Curve>();
  render::PagePicture picture(context, page, knobs.table(), size.width, size.height);
  if (page.volume) picture.setVolume(page.volume(knobs));
  Drawn drawn;
  picture.draw(curves);
  drawn.picture = picture.read();
  for (int i = 0; timed && i < kTimed; ++i) {
    const Stopwatch watch;
    picture.draw(curves);
    context.api().Finish();
    const double milliseconds = 1000 * watch.seconds();
    if (i == 0 || milliseconds < drawn.milliseconds) drawn.milliseconds = milliseconds;
  }
  drawn.figures = page.measure(knobs);
  return drawn;
}

void listPages() {
  for (const lab::Page& page : lab::pages()) {
    print("%s\t%s\n", std::string(page.name).c_str(), std::string(page.title).c_str());
    const std::unique_ptr<lab::Knobs> knobs = page.makeKnobs();
    for (const core::Field& field : knobs->table().fields())
      print("  %s = %s  %s\n", field.path.c_str(), core::fieldText(field).c_str(), field.help.c_str());
  }
}

void drawOne(const CommandLine& line) {
  const lab::Page& page = lab::pageNamed(*line.lab.page);
  const std::unique_ptr<lab::Knobs> knobs = page.makeKnobs();
  for (const std::string& assignment : line.set) core::setField(knobs->table(), assignment);
  core::OutputFile file = openOutput(*line.lab.out).value();
  const Size size = line.size.value_or(kUsualSize);
  const auto context = openContext(line.backend, size);
  const Drawn drawn = drawPage(*context, page, *knobs, size, false);
  file.write(core::encodePng(drawn.picture));
  print("%s: %s\n%s", std::string(page.title).c_str(), drawn.figures.summary.c_str(),
        lab::figuresText(drawn.figures, false).c_str());
}

// The pictures, and gallery.md beside them: a paragraph, a picture and the figures of each page.
void drawAll(const CommandLine& line) {
  const std::filesystem::path folder = *line.lab.out;
  core::requireFolder(folder);
  core::makeFolder(folder);
  const Size size = line.size.value_or(kUsualSize);
  const auto context = openContext(line.backend, size);
  std::string gallery;
  for (const lab::Page& page : lab::pages()) {
    const std::string name(page.name);
    const std::unique_ptr<lab::Knobs> knobs = page.makeKnobs();
    const Drawn drawn = drawPage(*context, page, *knobs, size, true);
    core::writePng(folder / (name + ".png"), drawn.picture);
    print("%-24s %6.1f ms  %s\n", name.c_str(), drawn.milliseconds, drawn.figures.summary.c_str());
    char time[64];
    std::snprintf(time, sizeof time, "%.0f ms", drawn.milliseconds);
    gallery += "## " + std::string(page.title) + "\n`skydrop lab --page " + name + "`\n\n" +
               std::string(page.text) + "\n\n![" + std::string(page.title) + "](" + name + ".png)\n\n" +
               drawn.figures.summary + ". A picture takes " + time + ".\n\n" +
               lab::figuresText(drawn.figures, true) + "\n";
  }
  core::OutputFile(folder / "gallery.md").write(gallery);
}

}  // namespace

int lab(const CommandLine& line) {
  try {
    if (line.lab.list)
      listPages();
    else if (line.lab.all)
      drawAll(line);
    else if (line.lab.out)
      drawOne(line);
    else
      runLaboratory(line);
  } catch (const core::RangeError& refusal) {
    throw core::UsageError(refusal.what());
  }
  return 0;
}

}  // namespace skydrop::app
