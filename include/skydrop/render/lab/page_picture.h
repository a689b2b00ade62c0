// A page of the laboratory as a picture: one program over the whole target, compiled for the page.
#pragma once

#include <optional>

#include "skydrop/core/image.h"
#include "skydrop/lab/page.h"
#include "skydrop/render/gl/frame_buffer.h"
#include "skydrop/render/gl/shader.h"
#include "skydrop/render/gl/vertex_array.h"

namespace skydrop::render {

// What is compiled of a page: its variant, and a name for each of its knobs ("knob_view_distance knobs[2]").
std::vector<std::string> definesOf(const lab::Page& page, const core::SettingsTable& knobs);
// Its entry file, "lab/march.frag".
std::string shaderOf(const lab::Page& page);

// On the context's thread; owns its objects, keeps the page, which must outlive it. Nothing of another page
// is compiled or made. Throws core::DataError where a shader does not compile.
class PagePicture {
 public:
  PagePicture(gl::Context& context, const lab::Page& page, const core::SettingsTable& knobs, int width,
              int height);

  void resize(int width, int height);
  // By the knobs as they are now. `curves` of the page's plot, at most lab::kMostCurves.
  void draw(std::span<const lab::Curve> curves);
  // Of a page with a volume, before the first draw() and when it has changed.
  void setVolume(const lab::Volume& volume);

  // sRGB-encoded; v = 0 is the lowest row.
  const gl::Texture& texture() const { return target_.colorTexture(); }
  core::Image read() const;

 private:
  gl::Context& context_;
  const lab::Page& page_;
  const core::SettingsTable& knobs_;
  gl::Shader shader_;
  gl::VertexArray nothing_;
  gl::Texture volume_;
  gl::FrameBuffer target_;
  std::optional<gl::FrameBuffer> small_;  // of a page that is drawn at half the size
};

}  // namespace skydrop::render
