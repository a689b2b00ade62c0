// "Make some noise": the tool that noise textures are made with. All of it but its window, so that a frame
// can also be had without one. Main thread, on the context's thread. Source: Tarantilis, "Simulating Clouds
// with Procedural Texturing Techniques Using the GPU", 2004, chapter III.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/types/size.h"
#include "app/window/noise_tool_settings.h"
#include "app/window/noise_work.h"
#include "skydrop/core/image.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/noise/noise_plane_view.h"
#include "skydrop/render/noise/noise_volume_view.h"
#include "skydrop/render/overlay/imgui_pass.h"
#include "skydrop/ui/noise_tool_view.h"

namespace skydrop::app {

// A change is shown at once by a small texture; the full one follows as soon as no slider is held. Both are
// made on workers (NoiseWork), and a frame shows whatever is there.
class NoiseTool {
 public:
  NoiseTool(render::gl::Context& context, Size size, const ui::InterfaceScale& scale = {});

  NoiseToolSettings& settings() { return settings_; }

  // Draws a frame. `begun` is called when the frame has taken the input (EventFeed::frameBuilt).
  void draw(Size size, double seconds, const ui::InterfaceScale& scale = {},
            const std::function<void()>& begun = nullptr);
  // A frame of the interface alone, which nobody sees (EventFeed).
  void buildUnseen(Size size, const ui::InterfaceScale& scale, const std::function<void()>& begun);

  render::Renderer& renderer() { return renderer_; }

  // Shows a DDS file, and takes its settings over; message() tells how that went.
  void open(const std::string& file);
  // The texture of the present settings, in their format, on a worker; message() tells the end.
  void save(const std::string& file);

  // What is shown is the full texture of the present settings, or a file.
  bool isSettled() const;
  // Texels of a side of what is shown; 0 while nothing is.
  int shownSide() const { return shown_ ? shown_->texture.width : 0; }
  // The last line on files.
  const std::string& message() const { return message_; }
  const ui::NoiseToolView& view() const { return view_; }

  // Whether it tells how long a texture took; a picture that is to be the same each time does not.
  bool showsTimes = true;
  // Takes what is shown into the sky: there is a button "Use in the sky" when it is set.
  std::function<void(const noise::NoiseRecipe& recipe, bool isVolume)> useInSky;

 private:
  bool build(Size size, double seconds, const ui::InterfaceScale& scale, const std::function<void()>& begun);
  void advance();
  void show(NoiseSample sample);
  void uploadPlane();
  void serve(const ui::NoiseToolResult& result);
  std::string statusText() const;

  bool isCut() const;  // what is shown

  NoiseToolSettings settings_;
  core::SettingsTable table_{settings_};
  ui::Interface interface_;
  ui::NoiseToolView view_;
  render::Renderer renderer_;
  render::ImGuiPass* pass_;  // the renderer's
  render::NoisePlaneView planeView_;
  render::NoiseVolumeView volumeView_;
  int shownSlice_ = 0;
  double angleRad_ = 0.6;
  NoiseWork work_;
  std::optional<NoiseSample> shown_;
  bool opened_ = false;  // it is a file's
  bool held_ = false;    // a slider is
  std::string message_;
};

}  // namespace skydrop::app
