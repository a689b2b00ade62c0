// One part of a frame. A pass is a class in its own file that owns its GL objects; its programs come from the
// renderer's cache. docs/rendering.md tells how to add one.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "skydrop/render/frame/frame_input.h"
#include "skydrop/render/frame/frame_resources.h"
#include "skydrop/render/frame/frame_uniforms.h"
#include "skydrop/render/frame/pixel_box.h"
#include "skydrop/render/frame/render_settings.h"
#include "skydrop/render/frame/render_stage.h"
#include "skydrop/render/gl/context.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/gl/shader_cache.h"

namespace skydrop::render {

// Draws, of the scene, what water mirrors (Pass::isMirrored) into a target of the view's size that has been
// cleared: linear light (RGBA16F) and reversed depth (D32F), lit as the scene is, without what lies below the
// plane of the sea. view: the mirrored eye's. The passes find what is in `resources`, and publish there.
using DrawMirrored =
    std::function<void(const View& view, gl::FrameBuffer& target, FrameResources& resources)>;

// What a pass draws with. References are valid during draw() only.
struct FrameContext {
  gl::Context& gl;
  gl::ShaderCache& shaders;
  const FrameInput& frame;
  const SkyLight& light;
  const FrameUniforms& uniforms;  // bound as block 0 (shaders/frame.glsl)
  const RenderSettings& settings;
  std::span<const std::string> defines;  // of the frame's features, for the cache
  // The same for programs whose vertex shader includes shaders/sea_cut.glsl (SeaCut).
  std::span<const std::string> meshDefines;
  FrameResources& resources;         // what earlier passes made for later ones
  const gl::Texture& sceneColor;     // RGBA16F; to be read from stage toneMap on (stage clouds: as an image)
  const gl::Texture& sceneDepth;     // D32F; to be read from stage clouds on, without filtering
  const DrawMirrored& drawMirrored;  // for passes of stage mirrors
};

class Pass {
 public:
  virtual ~Pass() = default;

  // As in the statistics: one word, lowerCamel.
  virtual std::string_view name() const = 0;
  virtual RenderStage stage() const = 0;
  // Why it has nothing to do in this frame; nullopt: it has. Not asked to draw if it gives a reason.
  virtual std::optional<std::string> skipReason(const FrameInput&) const { return std::nullopt; }
  // The same by what earlier passes of the frame have published. Asked where skipReason() gave none.
  virtual std::optional<std::string> skipReasonAfter(const FrameInput&, const FrameResources&) const {
    return std::nullopt;
  }
  // The pixels that it may touch. Asked of passes whose stage has a layer (Renderer::setLayer).
  virtual PixelBox extent(const FrameInput& frame) const {
    return {0, 0, frame.view.width, frame.view.height};
  }
  // How it darkens the day around the eye, asked before the light of the frame is made; clouds of a weather.
  virtual Overcast overcast(const FrameInput&) { return {}; }
  // Waits for what it makes beside the frames, so that this frame shows its settings as they are.
  virtual void settle(const FrameInput&) {}
  // Whether water mirrors what it draws. It is then also asked, skip reasons included, for mirrored frames
  // (FrameInput::isMirrored), before the frame itself, and cuts off what lies below the sea (SeaCut).
  virtual bool isMirrored() const { return false; }
  // The other view in which it shows the scene in a frame of this one: land is asked for it too.
  virtual std::optional<View> alsoShows(const View&) const { return std::nullopt; }
  // Target, viewport, the frame's uniform block and the default state (gl::Context::setDefaultState) are set.
  // State may be left changed; the target may not. A program that later frames may need is asked of the cache
  // in every frame that looks ahead, whether it uses it or not: what is not asked for is deleted when effects
  // change.
  virtual void draw(FrameContext& context) = 0;
};

}  // namespace skydrop::render
