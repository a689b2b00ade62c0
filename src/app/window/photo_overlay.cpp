#include "app/window/photo_overlay.h"

#include <algorithm>
#include <span>

#include "skydrop/core/picture_file.h"

namespace skydrop::app {
namespace {

// Vertices of the mesh: between them a panorama is linear to a pixel of 4K at 60 degrees of field.
constexpr int kColumns = 49, kRows = 29;

// Averaged over squares, so that no side is longer than `most`.
core::Image smaller(core::Image image, int most) {
  const int times = (std::max(image.width, image.height) + most - 1) / most;
  if (times < 2) return image;
  core::Image out((image.width + times - 1) / times, (image.height + times - 1) / times);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      int sum[4] = {}, count = 0;
      for (int v = y * times; v < std::min((y + 1) * times, image.height); ++v) {
        for (int u = x * times; u < std::min((x + 1) * times, image.width); ++u, ++count) {
          for (int c = 0; c < 4; ++c) sum[c] += image.pixel(u, v)[c];
        }
      }
      for (int c = 0; c < 4; ++c)
        out.pixel(x, y)[c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
    }
  }
  return out;
}

}  // namespace

PhotoOverlay::PhotoOverlay(render::gl::Context& context, const PhotoRequest& request)
    : request_(request),
      photo_(smaller(core::readPicture(request.file), kMostSide)),
      texture_(render::gl::Texture::make2D(context, GL_RGBA8, photo_.width, photo_.height, "photograph",
                                           render::gl::mipLevels(photo_.width, photo_.height))) {
  texture_.upload(GL_RGBA, GL_UNSIGNED_BYTE, std::as_bytes(std::span(photo_.rgba)));
  texture_.generateMipmaps();
  texture_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  if (request.panoramaFromDegrees) texture_.setWrap(GL_REPEAT);
}

const ui::PhotoLayer* PhotoOverlay::layer(const render::View& view, const ViewSettings& settings) {
  if (settings.photo == PhotoView::none) return nullptr;
  const bool isBeside = settings.photo == PhotoView::beside;
  // Beside, the left half shows what the right half sees, as large.
  const double width = isBeside ? 0.5 : 1;
  const auto share = static_cast<float>(settings.photoShare);
  layer_ = {};
  layer_.opacity = settings.photo == PhotoView::overlay ? share : 1;
  layer_.right = settings.photo == PhotoView::wipe ? share : isBeside ? 0.5F : 1;
  layer_.hasGround = isBeside;
  vertices_.clear();
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double x = column / double{kColumns - 1}, y = row / double{kRows - 1};
      const glm::dvec2 at =
          photoPlaceOf(photo_, request_, view, {(1 - width + width * x) * view.width, (1 - y) * view.height});
      vertices_.push_back({static_cast<float>(width * x), static_cast<float>(y), static_cast<float>(at.x),
                           static_cast<float>(at.y)});
    }
  }
  layer_.texture = texture_.id();
  layer_.columns = kColumns;
  layer_.rows = kRows;
  layer_.vertices = vertices_;
  layer_.goesRound = request_.panoramaFromDegrees.has_value();
  return &layer_;
}

}  // namespace skydrop::app
