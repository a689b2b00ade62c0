#include "skydrop/render/frame/sky_tables.h"

#include <cassert>
#include <span>

namespace skydrop::render {
namespace {

namespace shared = core::shared::f32;

constexpr int kColumns = shared::kSkyColumns, kRows = shared::kSkyRows, kSlices = shared::kSkySlices;
constexpr std::size_t kLayerTexels = static_cast<std::size_t>(kColumns * kRows);
constexpr int kLeft = static_cast<int>(sky::SkyLayer::left), kAir = static_cast<int>(sky::SkyLayer::airEven),
              kSkyHaze = static_cast<int>(sky::SkyLayer::skyHaze),
              kAirHaze = static_cast<int>(sky::SkyLayer::airHaze);
static_assert(kAir == kLeft + 1 && sky::kSkyLayers == kAir + 2 * kSlices);

}  // namespace

void SkyTables::bind(gl::Context& context, const SkyLight& light) {
  assert(light.isShell());
  if (light.view != view_ || light.exposure != exposure_) write(context, light);
  sky_.bind(kSkyTablesUnit);
  air_.bind(kAirTablesUnit);
}

void SkyTables::write(gl::Context& context, const SkyLight& light) {
  if (!sky_) {
    sky_ = gl::Texture::make2DArray(context, GL_RGBA32F, kColumns, kRows, kAir, "sky tables");
    air_ = gl::Texture::make3D(context, GL_RGBA32F, kColumns, kRows, 2 * kSlices, "air tables");
  }
  texels_ = light.view->texels;
  const glm::vec4 scale(glm::vec3(light.sunOutside * light.exposure), 0);
  const glm::vec4 night(glm::vec3(light.night * light.exposure), 0);
  for (int layer = 0; layer < sky::kSkyLayers; ++layer) {
    if (layer == kLeft) continue;
    const glm::vec4 added = layer == kSkyHaze || layer >= kAirHaze ? glm::vec4(0) : night;
    const auto texels =
        std::span(texels_).subspan(static_cast<std::size_t>(layer) * kLayerTexels, kLayerTexels);
    for (glm::vec4& texel : texels) texel = texel * scale + added;
  }
  const std::span<const glm::vec4> all(texels_);
  for (GLint layer = 0; layer < kAir; ++layer) {
    const auto texels = all.subspan(static_cast<std::size_t>(layer) * kLayerTexels, kLayerTexels);
    sky_.uploadLayer(layer, GL_RGBA, GL_FLOAT, std::as_bytes(texels));
  }
  air_.upload(GL_RGBA, GL_FLOAT, std::as_bytes(all.subspan(kAir * kLayerTexels)));
  view_ = light.view;
  exposure_ = light.exposure;
}

}  // namespace skydrop::render
