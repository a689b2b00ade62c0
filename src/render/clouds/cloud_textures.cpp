#include "render/clouds/cloud_textures.h"

#include <algorithm>
#include <future>
#include <numeric>
#include <span>
#include <vector>

#include "skydrop/clouds/occupancy.h"

namespace skydrop::render {
namespace {

using clouds::Occupancy;

constexpr GLuint kBaseUnit = 0, kDetailUnit = 1, kWeatherUnit = 2,
                 kOccupancyUnit = 3;  // as in shaders/clouds

gl::Texture volume(gl::Context& context, const std::vector<float>& texels, int side, std::string_view label) {
  // 32-bit floats are the fastest to filter on a software renderer, and exact.
  gl::Texture texture = gl::Texture::make3D(context, GL_R32F, side, side, side, label);
  texture.upload(GL_RED, GL_FLOAT, std::as_bytes(std::span(texels)));
  texture.setWrap(GL_REPEAT);
  return texture;
}

}  // namespace

CloudTextures::CloudTextures(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise,
                             const clouds::CloudSettings& settings)
    : noise_(std::move(noise)),
      meanDetail_(std::accumulate(noise_->detail.begin(), noise_->detail.end(), 0.0) /
                  static_cast<double>(noise_->detail.size())),
      base_(volume(context, noise_->base, noise_->shapeSide, "cloud base")),
      detail_(volume(context, noise_->detail, noise_->detailSide, "cloud detail")),
      weather_(gl::Texture::make2D(context, GL_RGBA32F, noise_->weatherSide, noise_->weatherSide, "weather")) {
  std::vector<glm::vec4> map;  // coverage, type, reach of anvils
  map.reserve(noise_->weather.size());
  for (std::size_t i = 0; i < noise_->weather.size(); ++i) {
    const glm::vec3& texel = noise_->weather[i];
    map.emplace_back(texel.x, texel.z, noise_->anvils.empty() ? texel.x : noise_->anvils[i], 0);
  }
  weather_.upload(GL_RGBA, GL_FLOAT, std::as_bytes(std::span(map)));
  weather_.setWrap(GL_REPEAT);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    layers_[i].distances = gl::Texture::make3D(context, GL_R8UI, Occupancy::kSide, Occupancy::kRows,
                                               Occupancy::kSide, "cloud occupancy");
    layers_[i].skyShares = gl::Texture::make2D(context, GL_R32F, clouds::SkyCover::kSide,
                                               clouds::SkyCover::kSide, "sky light below clouds");
    layers_[i].skyShares.setWrap(GL_REPEAT);
    rebuild(settings, i);
  }
}

void CloudTextures::rebuild(const clouds::CloudSettings& settings, std::size_t layer) {
  Layer& l = layers_[layer];
  // Beside the occupancy, which takes as long as the rest together.
  std::future<void> rest = std::async(std::launch::async, [&] {
    l.clearAir = clouds::measureClearAir(noise_, settings, layer);
    l.skyCover.emplace(noise_, settings, layer);
  });
  const Occupancy occupancy(*noise_, settings, layer);
  rest.get();
  l.isEmpty = occupancy.isEmpty();
  l.field.emplace(noise_, settings, layer);
  l.distances.upload(GL_RED_INTEGER, GL_UNSIGNED_BYTE, std::as_bytes(occupancy.distances()));
  l.skyShares.upload(GL_RED, GL_FLOAT, std::as_bytes(std::span(l.skyCover->shares())));
}

void CloudTextures::bind(std::size_t layer) const {
  base_.bind(kBaseUnit);
  detail_.bind(kDetailUnit);
  weather_.bind(kWeatherUnit);
  layers_[layer].distances.bind(kOccupancyUnit);
}

}  // namespace skydrop::render
