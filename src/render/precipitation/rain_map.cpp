#include "skydrop/render/precipitation/rain_map.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <string>

#include "render/precipitation/falling.h"
#include "skydrop/core/shared_precipitation.h"
#include "skydrop/game/flown_clouds.h"

namespace skydrop::render {

RainMap::RainMap(gl::Context& context, const clouds::PackedCloudNoise& noise) {
  const int step = std::max(noise.weatherSide / kSide, 1);
  side_ = noise.weatherSide / step;
  texels_.resize(static_cast<std::size_t>(side_ * side_));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(texels_.size() * 2);
  for (int y = 0; y < side_; ++y) {
    for (int x = 0; x < side_; ++x) {
      glm::vec2 sum(0);
      for (int j = 0; j < step; ++j) {
        for (int i = 0; i < step; ++i) {
          const int from = (y * step + j) * noise.weatherSide + x * step + i;
          sum += glm::vec2(noise.weather[static_cast<std::size_t>(from)]);
        }
      }
      const glm::vec2 texel = glm::round(sum * (255.0f / static_cast<float>(step * step)));
      texels_[static_cast<std::size_t>(y * side_ + x)] = texel / 255.0f;
      bytes.push_back(static_cast<std::uint8_t>(texel.x));
      bytes.push_back(static_cast<std::uint8_t>(texel.y));
    }
  }
  const GLsizei levels = std::bit_width(static_cast<unsigned>(side_));
  texture_ = gl::Texture::make2D(context, GL_RG8, side_, side_, "rain map", levels);
  texture_.upload(GL_RG, GL_UNSIGNED_BYTE, std::as_bytes(std::span(bytes)));
  texture_.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  texture_.setWrap(GL_REPEAT);
  texture_.generateMipmaps();
}

void RainMap::place(const clouds::LayerMedium& medium, const core::WindSettings& wind, double seconds) {
  periodM_ = clouds::weatherPeriod(medium);
  coverage_ = std::min(medium.layer.coverage, 1.0);  // decks have more, without gaps
  drift_ = core::windDrift(wind, seconds);
}

double RainMap::shareAt(const glm::dvec2& xz) const {
  const glm::dvec2 periods = (xz - drift_) / periodM_;
  const glm::dvec2 at = (periods - glm::floor(periods)) * static_cast<double>(side_) - 0.5;
  const glm::dvec2 cell = glm::floor(at), inside = at - cell;
  const auto texel = [&](int x, int y) {
    const int i = (static_cast<int>(cell.x) + x + side_) % side_;
    const int j = (static_cast<int>(cell.y) + y + side_) % side_;
    return glm::dvec2(texels_[static_cast<std::size_t>(j * side_ + i)]);
  };
  const glm::dvec2 mapped = glm::mix(glm::mix(texel(0, 0), texel(1, 0), inside.x),
                                     glm::mix(texel(0, 1), texel(1, 1), inside.x), inside.y);
  return core::shared::f64::rainShareOfMap(mapped.x, mapped.y, coverage_);
}

void RainMap::bind(gl::Shader& shader, const glm::dvec3& eye) const {
  texture_.bind(kUnit);
  const glm::dvec2 periods = (glm::dvec2(eye.x, eye.z) - drift_) / periodM_;
  shader.setVec4("rainMapPlace", glm::vec4(glm::vec2(periods - glm::floor(periods)),
                                           static_cast<float>(1 / periodM_), static_cast<float>(coverage_)));
}

std::optional<std::string> RainMapPass::skipReason(const FrameInput& frame) const {
  if (frame.warmsUp) return std::nullopt;
  const std::optional<weather::State> state = weatherOf(frame);
  if (auto reason = whyDry(state)) return reason;
  if (weather::fallsEverywhere(*weather::feedingLayer(*state))) return "it falls everywhere";
  return std::nullopt;
}

void RainMapPass::draw(FrameContext& context) {
  const std::optional<weather::State> state = weatherOf(context.frame);
  const weather::Layer* feeding = state ? weather::feedingLayer(*state) : nullptr;
  if (feeding) map_.place(game::cloudLayerOf(*feeding), wind_, context.frame.simulatedSeconds);
  context.resources.publish(map_);
}

}  // namespace skydrop::render
