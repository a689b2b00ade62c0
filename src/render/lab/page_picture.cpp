#include "skydrop/render/lab/page_picture.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/vec2.hpp>
#include <string>

namespace skydrop::render {
namespace {

constexpr std::size_t kMostKnobs = 32;  // as in shaders/lab/frame.glsl
constexpr GLuint kVolumeUnit = 0;       // as in shaders/lab/cloud.glsl

gl::FrameBufferFormat eightBits() { return {.color = GL_RGBA8, .depth = 0}; }

gl::Shader shaderFor(gl::Context& context, const lab::Page& page, const core::SettingsTable& knobs) {
  const std::vector<std::string> defines = definesOf(page, knobs);
  return {context, "fullscreen.vert", shaderOf(page), {}, defines};
}

}  // namespace

std::string shaderOf(const lab::Page& page) { return "lab/" + std::string(page.chapter) + ".frag"; }

std::vector<std::string> definesOf(const lab::Page& page, const core::SettingsTable& knobs) {
  assert(knobs.fields().size() <= kMostKnobs);
  std::vector<std::string> defines = {std::string(page.variant)};
  for (std::size_t i = 0; i < knobs.fields().size(); ++i) {
    std::string name = "knob_" + knobs.fields()[i].path;
    std::ranges::replace(name, '.', '_');
    defines.push_back(name + " knobs[" + std::to_string(i) + "]");
  }
  return defines;
}

PagePicture::PagePicture(gl::Context& context, const lab::Page& page, const core::SettingsTable& knobs,
                         int width, int height)
    : context_(context),
      page_(page),
      knobs_(knobs),
      shader_(shaderFor(context, page, knobs)),
      nothing_(context, "lab"),
      target_(context, width, height, eightBits(), "lab page") {
  if (page.everySecondPixel)
    small_.emplace(context, (width + 1) / 2, (height + 1) / 2, eightBits(), "lab page at half the size");
}

void PagePicture::resize(int width, int height) {
  target_.resize(width, height);
  if (small_) small_->resize((width + 1) / 2, (height + 1) / 2);
}

void PagePicture::draw(std::span<const lab::Curve> curves) {
  assert(curves.size() <= lab::kMostCurves);
  gl::FrameBuffer& target = small_ ? *small_ : target_;
  std::array<float, kMostKnobs> values{};
  for (std::size_t i = 0; i < knobs_.fields().size(); ++i)
    values[i] = static_cast<float>(knobs_.fields()[i].get());
  std::array<float, lab::kPlotPlaces * lab::kMostCurves> places{};
  for (std::size_t i = 0; i < curves.size(); ++i)
    std::ranges::copy(curves[i], places.begin() + static_cast<std::ptrdiff_t>(i * lab::kPlotPlaces));
  context_.setDefaultState();
  context_.api().Disable(GL_DEPTH_TEST);
  target.bind(gl::FrameBuffer::Clear::no);
  shader_.use();
  shader_.setVec2("pictureSize", {static_cast<float>(target.width()), static_cast<float>(target.height())});
  shader_.setFloats("knobs", values);
  shader_.setFloats("curves", places);
  shader_.setInt("curveCount", static_cast<int>(curves.size()));
  if (volume_) volume_.bind(kVolumeUnit);
  nothing_.bind();
  context_.drawArrays(GL_TRIANGLES, 0, 3);
  target.unBind();
  if (small_) small_->drawTo(target_);
}

void PagePicture::setVolume(const lab::Volume& volume) {
  assert(volume.side > 0);
  if (!volume_ || volume_.width() != volume.side) {
    volume_ = gl::Texture::make3D(context_, GL_RG16F, volume.side, volume.side, volume.side, "lab volume");
    volume_.setWrap(GL_REPEAT);
  }
  volume_.upload(GL_RG, GL_FLOAT, std::as_bytes(std::span(volume.pairs)));
}

core::Image PagePicture::read() const {
  const gl::Texture& picture = texture();
  core::Image image(picture.width(), picture.height());
  picture.read(GL_RGBA, GL_UNSIGNED_BYTE, std::as_writable_bytes(std::span(image.rgba)));
  // OpenGL's first row is the lowest.
  const auto row = static_cast<std::ptrdiff_t>(image.width) * 4;
  for (int y = 0; y < image.height / 2; ++y) {
    const auto upper = image.rgba.begin() + y * row,
               lower = image.rgba.begin() + (image.height - 1 - y) * row;
    std::swap_ranges(upper, upper + row, lower);
  }
  return image;
}

}  // namespace skydrop::render
