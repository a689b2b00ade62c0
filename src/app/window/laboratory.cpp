#include "app/window/laboratory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/measure/stopwatch.h"
#include "skydrop/core/error.h"

namespace skydrop::app {
namespace {

constexpr double kDegreesALine = 6;  // of text, that the mouse drags the picture by
constexpr double kCloserANotch = 0.9;

void setWithin(const core::Field* field, double value) {
  if (field) field->set(std::clamp(value, field->min, field->max));
}

}  // namespace

Laboratory::Laboratory(render::gl::Context& context, Size size, const ui::InterfaceScale& scale)
    : context_(context), interface_(size.width, size.height, scale), renderer_(context, {}, false) {
  auto pass = std::make_unique<render::ImGuiPass>(context);
  pass_ = pass.get();
  renderer_.add(std::move(pass));
  for (const lab::Page& page : lab::pages()) entries_.push_back({page.chapter, page.name, page.title});
  open(lab::pages().front());
}

void Laboratory::open(const lab::Page& page) {
  std::unique_ptr<lab::Knobs> knobs = page.makeKnobs();
  auto picture = std::make_unique<render::PagePicture>(
      context_, page, knobs->table(), std::max(drawnSize_.width, 1), std::max(drawnSize_.height, 1));
  picture_ = std::move(picture);
  knobs_ = std::move(knobs);
  page_ = &page;
  wasPrepared_ = false;
  figures_.clear();
  status_.clear();
  refresh();
}

void Laboratory::draw(Size size, double seconds, const ui::InterfaceScale& scale,
                      const std::function<void()>& begun) {
  const auto line = static_cast<float>(ui::Interface::linePixels(size.width, size.height, scale));
  const ui::LabPictureSize wanted = ui::labPictureSize(size.width, size.height, line);
  drawPicture({wanted.width, wanted.height});
  if (build(size, seconds, scale, begun)) pass_->uploadFonts();
  render::View view;
  view.width = size.width;
  view.height = size.height;
  renderer_.draw({.view = view});
}

void Laboratory::buildUnseen(Size size, const ui::InterfaceScale& scale, const std::function<void()>& begun) {
  if (build(size, 0, scale, begun)) pass_->uploadFonts();
}

void Laboratory::drawPicture(Size size) {
  // While a slider is held what takes long waits for its end, but not for a page's first picture.
  if (!isPrepared_ && (!held_ || !wasPrepared_)) {
    curves_ = page_->plot ? page_->plot(*knobs_) : std::vector<lab::Curve>();
    if (page_->volume) picture_->setVolume(page_->volume(*knobs_));
    isPrepared_ = wasPrepared_ = true;
    isDrawn_ = false;
  }
  if (isDrawn_ && size.width == drawnSize_.width && size.height == drawnSize_.height) return;
  const Stopwatch watch;
  picture_->resize(size.width, size.height);
  picture_->draw(curves_);
  context_.api().Finish();
  drawnSize_ = size;
  isDrawn_ = true;
  ++picturesDrawn_;
  if (!showsTimes) return;
  char text[64];
  std::snprintf(text, sizeof text, "%d x %d in %.1f ms", size.width, size.height, 1000 * watch.seconds());
  status_ = text;
}

bool Laboratory::build(Size size, double seconds, const ui::InterfaceScale& scale,
                       const std::function<void()>& begun) {
  const bool fontsChanged = interface_.beginFrame(size.width, size.height, seconds, scale);
  if (begun) begun();
  ui::LabContent content{.entries = entries_, .text = page_->text, .table = knobs_->table()};
  content.chosen = static_cast<std::size_t>(page_ - lab::pages().data());
  content.texture = picture_->texture().id();
  content.figures = figures_;
  content.status = status_;
  const ui::LabResult result = view_.draw(interface_, content);
  interface_.endFrame();
  serve(result);
  return fontsChanged;
}

void Laboratory::serve(const ui::LabResult& result) {
  held_ = result.held;
  if (result.changed) refresh();
  if (result.refusal) status_ = *result.refusal;
  if (result.reset) {
    for (const core::Field& field : knobs_->table().fields()) field.reset();
    refresh();
  }
  if (result.turnedX != 0 || result.turnedY != 0 || result.zoomed != 0)
    turn(-kDegreesALine * result.turnedX, kDegreesALine * result.turnedY, result.zoomed);
  if (result.measure) {
    const lab::Figures figures = page_->measure(*knobs_);
    figures_ = figures.summary + "\n" + lab::figuresText(figures, false);
  }
  if (result.chosen) {
    try {
      open(lab::pages()[*result.chosen]);
    } catch (const core::DataError& failure) {
      status_ = failure.what();
    }
  }
}

void Laboratory::turn(double azimuth, double elevation, double closer) {
  const core::SettingsTable& table = knobs_->table();
  const core::Field *around = table.find("view.azimuthDegrees"), *above = table.find("view.elevationDegrees"),
                    *distance = table.find("view.distance");
  if (!around) return;  // a page without an eye
  setWithin(around, std::remainder(around->get() + azimuth, 360.0));
  setWithin(above, above->get() + elevation);
  setWithin(distance, distance->get() * std::pow(kCloserANotch, closer));
  isDrawn_ = false;
}

}  // namespace skydrop::app
