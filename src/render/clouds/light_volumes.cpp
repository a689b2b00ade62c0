#include "render/clouds/light_volumes.h"

#include <algorithm>
#include <cmath>
#include <glm/packing.hpp>
#include <glm/trigonometric.hpp>

#include "skydrop/core/thread_priority.h"

namespace skydrop::render {
namespace {

using clouds::LightVolume;
using Halves = std::vector<std::uint32_t>;

constexpr std::size_t kSlice = std::size_t{LightVolume::kSide} * LightVolume::kRows;  // of one z
constexpr double kHeightSteps = 2;                                                    // a degree

Halves halvesOf(const LightVolume& volume) {
  Halves halves;
  halves.reserve(volume.texels().size());
  for (const LightVolume::Texel& texel : volume.texels())
    halves.push_back(glm::packHalf2x16(glm::vec2(texel.sun, texel.sky)));
  return halves;
}

}  // namespace

glm::ivec2 roundedSun(const glm::dvec3& toSun) {
  if (!(toSun.y > 0)) return {0, 0};
  const double height = glm::degrees(std::asin(std::min(toSun.y, 1.0))),
               azimuth = glm::degrees(std::atan2(toSun.z, toSun.x));
  return {std::max(1, static_cast<int>(std::lround(height * kHeightSteps))),
          static_cast<int>(std::lround(azimuth))};
}

glm::dvec3 toRoundedSun(const glm::ivec2& sun) {
  const double height = glm::radians(sun.x / kHeightSteps), azimuth = glm::radians(double(sun.y));
  return {std::cos(height) * std::cos(azimuth), std::sin(height), std::cos(height) * std::sin(azimuth)};
}

LightVolumesKey lightVolumesKey(const clouds::LayerMedium& medium, const glm::dvec3& toSun) {
  return {{medium}, roundedSun(toSun)};
}

LightVolumesKey lightVolumesKey(std::span<const DrawnLayer> layers, const glm::dvec3& toSun) {
  LightVolumesKey key{{}, roundedSun(toSun)};
  for (const DrawnLayer& drawn : layers) {
    if (!drawn.isThere) {
      key.layers.emplace_back();
      continue;
    }
    const LayerRange range = rangeOf(drawn.medium);
    key.layers.emplace_back(range.most);
    clouds::CloudLayerSettings& solved = key.layers.back()->layer;
    solved.anisotropy = drawn.medium.layer.anisotropy;
    solved.forwardShare = drawn.medium.layer.forwardShare;
    solved.coverage = 0.5 * (range.leastCoverage + range.most.layer.coverage);
    // A range has the extinction to an octave's quarter, which is enough for where there is cloud.
    constexpr double kExtinctions = 16;  // an octave
    const double extinction = drawn.medium.layer.extinction;
    if (extinction > 0)
      solved.extinction = std::exp2(std::round(std::log2(extinction) * kExtinctions) / kExtinctions);
  }
  return key;
}

LightVolumes::LightVolumes(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise)
    : context_(context),
      job_([noise = std::move(noise), last = Solved{}](const LightVolumesKey& key,
                                                       std::stop_token stop) mutable {
        core::lowerThreadPriority();
        Solved solved{key, {}};
        for (std::size_t i = 0; i < key.layers.size(); ++i) {
          const bool isKept =
              i < last.layers.size() && last.key.sun == key.sun && last.key.layers[i] == key.layers[i];
          if (isKept || !key.layers[i]) {
            solved.layers.push_back(isKept ? last.layers[i] : nullptr);
            continue;
          }
          const clouds::CloudField field(noise, *key.layers[i]);
          solved.layers.push_back(
              std::make_shared<const Halves>(halvesOf(LightVolume(field, toRoundedSun(key.sun), stop))));
        }
        last = solved;
        return solved;
      }) {}

bool LightVolumes::update(const LightVolumesKey& key, bool waits) {
  if (shown_ == key) return true;
  if (asked_ != key) {
    job_.request(key);
    asked_ = key;
  }
  if (waits) job_.wait();
  if (const std::optional<Solved> solved = job_.take()) upload(*solved);
  return shown_ && shown_->layers.size() == key.layers.size();
}

void LightVolumes::upload(const Solved& solved) {
  const auto count = static_cast<int>(solved.layers.size());
  if (!texture_ || texture_.height() != count * LightVolume::kRows) {
    texture_ = gl::Texture::make3D(context_, GL_RG16F, LightVolume::kSide, count * LightVolume::kRows,
                                   LightVolume::kSide, "light in clouds");
    texture_.setWrap(GL_REPEAT);
  }
  Halves all(kSlice * LightVolume::kSide * solved.layers.size(), 0);
  auto into = all.begin();
  for (std::size_t z = 0; z < LightVolume::kSide; ++z) {
    for (const auto& layer : solved.layers) {
      if (layer) std::copy_n(layer->begin() + static_cast<std::ptrdiff_t>(z * kSlice), kSlice, into);
      into += kSlice;
    }
  }
  texture_.upload(GL_RG, GL_HALF_FLOAT, std::as_bytes(std::span(all)));
  shown_ = solved.key;
}

}  // namespace skydrop::render
