#include "skydrop/render/frame/sky_tables.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>
#include <span>

#include "skydrop/sky/sky_curve.h"

namespace skydrop::render {
namespace {

namespace shared = core::shared::f32;

constexpr int kColumns = shared::kSkyColumns, kRows = shared::kSkyRows, kSlices = shared::kSkySlices;
constexpr std::size_t kLayerTexels = static_cast<std::size_t>(kColumns * kRows);
constexpr int kLeft = static_cast<int>(sky::SkyLayer::left), kAir = static_cast<int>(sky::SkyLayer::airEven),
              kSkyHaze = static_cast<int>(sky::SkyLayer::skyHaze),
              kAirHaze = static_cast<int>(sky::SkyLayer::airHaze);
static_assert(kAir == kLeft + 1 && sky::kSkyLayers == kAir + 2 * kSlices);

// Of the sky's own layers on the GPU, where a sky without anything before it shows each kink: texels between
// those of the view, on curves through them. As in shaders/sky/atmosphere.glsl.
constexpr int kFinerColumns = 6, kFinerRows = 3;
constexpr int kSkyWidth = (kColumns - 1) * kFinerColumns + 1;
constexpr int kSkyHeight = (kRows - 2) * kFinerRows + 2;  // nothing between the two rows at the horizon

constexpr float kMeanPhase = 0.25f / std::numbers::pi_v<float>;  // of any phase function, over all directions

// How much each column counts in a mean over all azimuths.
std::array<float, kColumns> azimuthShares() {
  constexpr int kSamples = 256;
  std::array<float, kColumns> shares{};
  for (int i = 0; i < kSamples; ++i) {
    const float at = shared::skyTableColumn(
        std::cos(std::numbers::pi_v<float> * (static_cast<float>(i) + 0.5f) / kSamples));
    const int column = std::clamp(static_cast<int>(at), 0, kColumns - 2);
    const float share = at - static_cast<float>(column);
    shares[static_cast<std::size_t>(column)] += (1 - share) / kSamples;
    shares[static_cast<std::size_t>(column) + 1] += share / kSamples;
  }
  return shares;
}
const std::array<float, kColumns> kAzimuthShares = azimuthShares();

// `count` texels `stride` apart become (count - 1) * finer + 1, `to` apart.
void refine(const glm::vec4* from, int count, int stride, int finer, glm::vec4* to, int toStride) {
  for (int i = 0; i + 1 < count; ++i) {
    const glm::vec4* at = from + i * stride;
    for (int k = 0; k < finer; ++k) {
      to[(i * finer + k) * toStride] = sky::curveThrough(i > 0 ? at - stride : nullptr, at[0], at[stride],
                                                         i + 2 < count ? at + 2 * stride : nullptr,
                                                         static_cast<float>(k) / static_cast<float>(finer));
    }
  }
  to[(count - 1) * finer * toStride] = from[(count - 1) * stride];
}

}  // namespace

void SkyTables::bind(gl::Context& context, const SkyLight& light) {
  assert(light.isShell());
  const std::shared_ptr<const sky::SkyView> moon = light.moon ? light.moon->view : nullptr;
  const bool isWritten = light.view == view_ && moon == moon_ && light.exposure == exposure_;
  if (!isWritten) write(context, light);
  if (!isWritten || light.toGlow().y != glowSine_ || light.air.hazeAnisotropy != anisotropy_) writeAir(light);
  sky_.bind(kSkyTablesUnit);
  air_.bind(kAirTablesUnit);
}

// The rest is the mean over all azimuths of what a layer has, and of the haze's layer that belongs to it
// without its phase function.
void SkyTables::add(const sky::SkyView& view, const glm::dvec3& times, double glow) {
  const std::span<const glm::vec4> of(view.texels);
  const glm::vec4 kept(glm::vec3(times * glow), 0), spread(glm::vec3(times * (1 - glow)), 0);
  const auto addLayers = [&](int even, int haze) {
    for (int row = 0; row < kRows; ++row) {
      const auto at = [&](int layer) { return static_cast<std::size_t>((layer * kRows + row) * kColumns); };
      for (std::size_t c = 0; c < kColumns; ++c) {
        texels_[at(even) + c] += of[at(even) + c] * kept;
        texels_[at(haze) + c] += of[at(haze) + c] * kept;
      }
      if (glow >= 1) continue;
      glm::vec4 mean(0);
      for (std::size_t c = 0; c < kColumns; ++c)
        mean += kAzimuthShares[c] * (of[at(even) + c] + of[at(haze) + c] * kMeanPhase);
      for (std::size_t c = 0; c < kColumns; ++c) texels_[at(even) + c] += mean * spread;
    }
  };
  addLayers(static_cast<int>(sky::SkyLayer::skyEven), kSkyHaze);
  for (int slice = 0; slice < kSlices; ++slice) addLayers(kAir + slice, kAirHaze + slice);
}

const std::vector<glm::vec4>& SkyTables::finer(std::span<const glm::vec4> texels) {
  wide_.resize(static_cast<std::size_t>(kSkyWidth * kRows));
  finer_.resize(static_cast<std::size_t>(kSkyWidth * kSkyHeight));
  for (int row = 0; row < kRows; ++row)
    refine(texels.data() + row * kColumns, kColumns, 1, kFinerColumns, wide_.data() + row * kSkyWidth, 1);
  constexpr int kBelow = shared::kSkyRowsBelow, kAbove = shared::kSkyRowsAbove;
  constexpr int kFirstAbove = (kBelow - 1) * kFinerRows + 1;
  for (int column = 0; column < kSkyWidth; ++column) {
    refine(wide_.data() + column, kBelow, kSkyWidth, kFinerRows, finer_.data() + column, kSkyWidth);
    refine(wide_.data() + kBelow * kSkyWidth + column, kAbove, kSkyWidth, kFinerRows,
           finer_.data() + kFirstAbove * kSkyWidth + column, kSkyWidth);
  }
  return finer_;
}

void SkyTables::write(gl::Context& context, const SkyLight& light) {
  if (!sky_) {
    sky_ = gl::Texture::make2DArray(context, GL_RGBA32F, kSkyWidth, kSkyHeight, kAir, "sky tables");
    air_ =
        gl::Texture::make3D(context, GL_RGBA32F, shared::kAirColumns, shared::kAirRows, kSlices, "air table");
  }
  texels_ = light.view->texels;
  const glm::vec4 night(glm::vec3(light.night * light.exposure), 0);
  for (int layer = 0; layer < sky::kSkyLayers; ++layer) {
    if (layer == kLeft) continue;
    std::ranges::fill(
        std::span(texels_).subspan(static_cast<std::size_t>(layer) * kLayerTexels, kLayerTexels),
        layer == kSkyHaze || layer >= kAirHaze ? glm::vec4(0) : night);
  }
  add(*light.view, light.sunOutside * light.exposure, light.sunGlow);
  if (light.moon) add(*light.moon->view, light.moon->outside * light.exposure, light.moonGlow);
  const std::span<const glm::vec4> all(texels_);
  for (GLint layer = 0; layer < kAir; ++layer) {
    const auto texels = all.subspan(static_cast<std::size_t>(layer) * kLayerTexels, kLayerTexels);
    sky_.uploadLayer(layer, GL_RGBA, GL_FLOAT, std::as_bytes(std::span(finer(texels))));
  }
  view_ = light.view;
  moon_ = light.moon ? light.moon->view : nullptr;
  exposure_ = light.exposure;
}

// Between texels of the view as a sampler mixes them, at each texel of the finer table.
void SkyTables::writeAir(const SkyLight& light) {
  constexpr int kWidth = shared::kAirColumns, kHeight = shared::kAirRows;
  constexpr std::size_t kSlice = static_cast<std::size_t>(kWidth * kHeight);
  airTexels_.resize(kSlice * kSlices);
  glowSine_ = light.toGlow().y;
  anisotropy_ = light.air.hazeAnisotropy;
  const float glowSine = static_cast<float>(glowSine_), g = static_cast<float>(anisotropy_);
  const float glowAcross = std::sqrt(std::max(1 - glowSine * glowSine, 0.0f));
  struct Column {
    float cosAzimuth, share;
    std::size_t first;
  };
  std::array<Column, kWidth> columns{};
  for (int c = 0; c < kWidth; ++c) {
    const float cosAzimuth = shared::airTableCosAzimuth(c), at = shared::skyTableColumn(cosAzimuth);
    const int first = std::min(static_cast<int>(at), kColumns - 2);
    columns[static_cast<std::size_t>(c)] = {cosAzimuth, at - static_cast<float>(first),
                                            static_cast<std::size_t>(first)};
  }
  const std::span<const glm::vec4> air = std::span<const glm::vec4>(texels_).subspan(kAir * kLayerTexels);
  std::array<float, kWidth> phases{};
  for (int row = 0; row < kHeight; ++row) {
    const float at = shared::airTableSkyRow(row);
    const float sine = shared::skyTableSine(at, static_cast<float>(light.view->horizon),
                                            static_cast<float>(light.view->airEnds));
    const float across = std::sqrt(std::max(1 - sine * sine, 0.0f));
    for (std::size_t c = 0; c < kWidth; ++c) {
      const float cosAngle = sine * glowSine + across * glowAcross * columns[c].cosAzimuth;
      phases[c] = shared::henyeyGreenstein(std::clamp(cosAngle, -1.0f, 1.0f), g);
    }
    const auto first = static_cast<std::size_t>(at) * kColumns;
    const bool isBetween = at != std::floor(at);
    for (int slice = 0; slice < kSlices; ++slice) {
      const glm::vec4* even = air.data() + static_cast<std::size_t>(slice) * kLayerTexels + first;
      const glm::vec4* haze = even + kSlices * kLayerTexels;
      glm::vec4* to = airTexels_.data() + static_cast<std::size_t>(slice) * kSlice +
                      static_cast<std::size_t>(row) * kWidth;
      for (std::size_t c = 0; c < kWidth; ++c) {
        const auto mixed = [&](const glm::vec4* of) {
          const glm::vec4* at0 = of + columns[c].first;
          const glm::vec4 lower = glm::mix(at0[0], at0[1], columns[c].share);
          return isBetween ? 0.5f * (lower + glm::mix(at0[kColumns], at0[kColumns + 1], columns[c].share))
                           : lower;
        };
        to[c] = mixed(even) + mixed(haze) * phases[c];
      }
    }
  }
  air_.upload(GL_RGBA, GL_FLOAT, std::as_bytes(std::span<const glm::vec4>(airTexels_)));
}

}  // namespace skydrop::render
