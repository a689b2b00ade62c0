// The laboratory with its interface: all of it but its window, so that a frame can also be had without one.
// Main thread, on the context's thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/types/size.h"
#include "skydrop/lab/page.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/lab/page_picture.h"
#include "skydrop/render/overlay/imgui_pass.h"
#include "skydrop/ui/lab_view.h"

namespace skydrop::app {

// Only the page that is shown has a program, a picture and a volume; they go when another is opened. A
// picture is drawn again when a knob or its size has changed.
class Laboratory {
 public:
  Laboratory(render::gl::Context& context, Size size, const ui::InterfaceScale& scale = {});

  // Throws core::DataError where its shader does not compile; then the page before stays.
  void open(const lab::Page& page);
  const lab::Page& page() const { return *page_; }
  const lab::Knobs& knobs() const { return *knobs_; }
  // After knobs were set from outside.
  void refresh() { isDrawn_ = isPrepared_ = false; }

  // Draws a frame. `begun` is called when the frame has taken the input (EventFeed::frameBuilt).
  void draw(Size size, double seconds, const ui::InterfaceScale& scale = {},
            const std::function<void()>& begun = nullptr);
  // A frame of the interface alone, which nobody sees (EventFeed).
  void buildUnseen(Size size, const ui::InterfaceScale& scale, const std::function<void()>& begun);

  render::Renderer& renderer() { return renderer_; }
  const ui::LabView& view() const { return view_; }
  int picturesDrawn() const { return picturesDrawn_; }
  const std::string& figures() const { return figures_; }

  // Whether it tells what a picture took; one that is to be the same each time does not.
  bool showsTimes = true;

 private:
  bool build(Size size, double seconds, const ui::InterfaceScale& scale, const std::function<void()>& begun);
  void drawPicture(Size size);
  void serve(const ui::LabResult& result);
  void turn(double azimuth, double elevation, double closer);

  render::gl::Context& context_;
  ui::Interface interface_;
  ui::LabView view_;
  render::Renderer renderer_;
  render::ImGuiPass* pass_;  // the renderer's
  std::vector<ui::LabEntry> entries_;
  const lab::Page* page_ = nullptr;
  std::unique_ptr<lab::Knobs> knobs_;
  std::unique_ptr<render::PagePicture> picture_;  // of page_ and knobs_
  std::vector<lab::Curve> curves_;
  Size drawnSize_{0, 0};
  bool isDrawn_ = false, isPrepared_ = false;  // picture; curves and volume
  bool wasPrepared_ = false;                   // since the page was opened
  bool held_ = false;                          // a slider is
  int picturesDrawn_ = 0;
  std::string figures_, status_;
};

}  // namespace skydrop::app
