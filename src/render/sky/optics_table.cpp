#include "render/sky/optics_table.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/trigonometric.hpp>

#include "skydrop/core/assets.h"
#include "skydrop/core/dds.h"
#include "skydrop/core/error.h"
#include "skydrop/core/shared_optics.h"
#include "skydrop/sky/atmosphere.h"

namespace skydrop::render {

gl::Texture opticsTable(gl::Context& context, const std::string& name, bool isVolume) {
  const std::string path = core::assetPath("optics/" + name);
  const core::TextureData table = core::readDds(path);
  if (table.format != core::TexelFormat::rgba32f)
    throw core::DataError(path, "format",
                          std::string(core::texelFormatName(table.format)) + " instead of RGBA floats");
  if (table.isVolume() != isVolume)
    throw core::DataError(path, "depth", isVolume ? "not a volume" : "a volume instead of a texture");
  for (std::size_t at = 0; at < table.texels.size(); at += sizeof(float)) {
    float value = 0;
    std::memcpy(&value, &table.texels[at], sizeof value);
    if (!(value >= 0 && value <= 65504))
      throw core::DataError(path, "texel " + std::to_string(at / (4 * sizeof(float))),
                            "out of range 0 to 65504");
  }
  gl::Texture texture =
      isVolume ? gl::Texture::make3D(context, GL_RGBA16F, table.width, table.height, table.depth, name)
               : gl::Texture::make2D(context, GL_RGBA16F, table.width, table.height, name);
  texture.upload(GL_RGBA, GL_FLOAT, table.texels);
  return texture;
}

bool isLightBelowHorizon(const FrameInput& frame) {
  const double horizon = core::shared::f64::horizonSine(std::max(frame.view.position.y, 0.0));
  return frame.toSun.y < horizon - std::sin(sky::kSunRadiusRad);
}

bool isFartherThan(const View& view, const glm::dvec3& direction, double degrees) {
  const glm::dvec3 forward = view.forward();
  double widest = 0;
  for (const double x : {0, view.width}) {
    for (const double y : {0, view.height})
      widest = std::max(widest, core::shared::f64::angleBetween(forward, rayDirection(view, {x, y})));
  }
  return core::shared::f64::angleBetween(forward, direction) > widest + glm::radians(degrees);
}

}  // namespace skydrop::render
