#include "render/clouds/light_volumes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/trigonometric.hpp>

#include "skydrop/core/thread_priority.h"

namespace skydrop::render {
namespace {

using clouds::LightVolume;

constexpr double kHeightSteps = 2;  // a degree
constexpr int kParting = 4;         // a period is as many times as wide as surroundings
constexpr int kSteps = 4;           // by which the old light turns into the new
constexpr int kParts = 4;           // of a volume, one a frame, where both are near
constexpr double kNearCoverage = 0.15, kNearExtinction = 1.25;
constexpr int kNearDegrees = 6;  // of the sun

std::size_t layerTexels(int side) {
  return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * LightVolume::kRows;
}

// For a tenth of a second at most: about what a place within a cumulus has.
constexpr LightVolume::Texel kEvenLight{0.02f, 0.5f / glm::pi<float>()};

// Texels in halves, sun and sky in turn.
std::vector<std::uint16_t> halvesOf(std::span<const LightVolume::Texel> texels) {
  std::vector<std::uint16_t> halves;
  halves.reserve(2 * texels.size());
  for (const LightVolume::Texel& texel : texels) {
    halves.push_back(glm::packHalf1x16(texel.sun));
    halves.push_back(glm::packHalf1x16(texel.sky));
  }
  return halves;
}

bool isNear(const clouds::LayerMedium& a, const clouds::LayerMedium& b) {
  clouds::LayerMedium alike = b;
  alike.layer.coverage = a.layer.coverage;
  alike.layer.extinction = a.layer.extinction;
  const double thin = std::min(a.layer.extinction, b.layer.extinction),
               thick = std::max(a.layer.extinction, b.layer.extinction);
  return alike == a && std::abs(a.layer.coverage - b.layer.coverage) <= kNearCoverage &&
         thick <= kNearExtinction * thin;
}

}  // namespace

// On the job's thread: keeps the layers of the last solution, which the next may have too.
class LightVolumes::Solver {
 public:
  explicit Solver(std::shared_ptr<const clouds::PackedCloudNoise> noise) : noise_(std::move(noise)) {}

  Solved operator()(const Task& task, const std::stop_token& stop) {
    core::lowerThreadPriority();
    const LightVolumesKey& key = task.key;
    std::vector<std::shared_ptr<const Halves>> layers;
    for (std::size_t i = 0; i < key.layers.size(); ++i) {
      const bool hasLast = last_.side == key.side && i < lastLayers_.size() && lastLayers_[i];
      if (!key.layers[i]) {
        layers.push_back(nullptr);
      } else if (hasLast && last_.sun == key.sun && last_.layers[i] == key.layers[i]) {
        layers.push_back(lastLayers_[i]);
      } else {
        const clouds::CloudField field(noise_, *key.layers[i]);
        layers.push_back(std::make_shared<const Halves>(
            task.around ? withSurroundings(hasLast ? lastLayers_[i].get() : nullptr, field, task, stop)
                        : halvesOf(LightVolume(field, toRoundedSun(key.sun), key.side, stop).texels())));
      }
    }
    if (stop.stop_requested()) return {task, nullptr};  // layers are unsolved, and nobody takes it
    const Solved solved{task, oneUponTheOther(layers, key.side)};
    if (task.around) return solved;
    last_ = key;
    lastLayers_ = std::move(layers);
    return solved;
  }

 private:
  // Of the last solution, or in even light, but for a square around the place of the task.
  static Halves withSurroundings(const Halves* last, const clouds::CloudField& field, const Task& task,
                                 const std::stop_token& stop) {
    const int side = task.key.side, cells = std::max(side / kParting, LightVolume::kMinPart);
    Halves all = last ? *last : halvesOf(std::vector<LightVolume::Texel>(layerTexels(side), kEvenLight));
    const double cellM = clouds::weatherPeriod(field.medium()) / side;
    const auto firstOf = [&](double place) {
      const double turns = place / (cellM * side);
      return static_cast<int>((turns - std::floor(turns)) * side) - cells / 2;
    };
    const glm::ivec2 first(firstOf(task.around->x), firstOf(task.around->y));
    const Halves part =
        halvesOf(LightVolume::part(field, toRoundedSun(task.key.sun), side, first, cells, stop));
    for (std::size_t i = 0; i < part.size() / 2; ++i) {  // x fastest, then row, then z
      const auto wide = static_cast<std::size_t>(cells);
      const std::size_t x = i % wide, row = i / wide % LightVolume::kRows, z = i / wide / LightVolume::kRows;
      const auto wrapped = [&](int begin, std::size_t by) {
        return static_cast<std::size_t>((begin + static_cast<int>(by)) & (side - 1));
      };
      const std::size_t into =
          (wrapped(first.y, z) * LightVolume::kRows + row) * static_cast<std::size_t>(side) +
          wrapped(first.x, x);
      all[2 * into] = part[2 * i];
      all[2 * into + 1] = part[2 * i + 1];
    }
    return all;
  }

  static std::shared_ptr<const Halves> oneUponTheOther(
      const std::vector<std::shared_ptr<const Halves>>& layers, int side) {
    if (layers.size() == 1 && layers[0]) return layers[0];
    const std::size_t slice = 2 * layerTexels(side) / static_cast<std::size_t>(side);
    auto all = std::make_shared<Halves>(2 * layerTexels(side) * layers.size(), std::uint16_t{0});
    auto into = all->begin();
    for (std::size_t z = 0; z < static_cast<std::size_t>(side); ++z) {
      for (const auto& layer : layers) {
        if (layer) std::copy_n(layer->begin() + static_cast<std::ptrdiff_t>(z * slice), slice, into);
        into += static_cast<std::ptrdiff_t>(slice);
      }
    }
    return all;
  }

  std::shared_ptr<const clouds::PackedCloudNoise> noise_;
  LightVolumesKey last_;
  std::vector<std::shared_ptr<const Halves>> lastLayers_;
};

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

int volumeSide(clouds::LightCells cells) {
  return cells == clouds::LightCells::coarse ? LightVolume::kSide / 2 : LightVolume::kSide;
}

LightVolumesKey lightVolumesKey(const clouds::LayerMedium& medium, const glm::dvec3& toSun,
                                clouds::LightCells cells) {
  return {{medium}, roundedSun(toSun), volumeSide(cells)};
}

LightVolumesKey lightVolumesKey(std::span<const DrawnLayer> layers, const glm::dvec3& toSun,
                                clouds::LightCells cells) {
  LightVolumesKey key{{}, roundedSun(toSun), volumeSide(cells)};
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

bool isNear(const LightVolumesKey& a, const LightVolumesKey& b) {
  if (a.side != b.side || a.layers.size() != b.layers.size()) return false;
  for (std::size_t i = 0; i < a.layers.size(); ++i) {
    if (a.layers[i].has_value() != b.layers[i].has_value()) return false;
    if (a.layers[i] && !isNear(*a.layers[i], *b.layers[i])) return false;
  }
  const glm::dvec3 sunA = toRoundedSun(a.sun), sunB = toRoundedSun(b.sun);
  const double cosine = glm::dot(sunA, sunB);
  return (a.sun.x > 0) == (b.sun.x > 0) && cosine >= std::cos(glm::radians(double{kNearDegrees}));
}

LightVolumes::LightVolumes(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise)
    : context_(context), job_(Solver(std::move(noise))) {}

void LightVolumes::update(const LightVolumesKey& key, const glm::dvec2& eyeInField, bool waits) {
  if (waits) {
    if (!isWhole(key)) {
      ask(key, std::nullopt);
      job_.wait();
      if (std::optional<Solved> solved = job_.take()) show(std::move(*solved));
    } else if (stepsLeft_ > 0) {
      show(*target_);
    }
    return;
  }
  if (std::optional<Solved> solved = job_.take()) turnInto(std::move(*solved));
  const std::size_t layers = key.layers.size();
  if (!texture_ || texture_.height() != static_cast<GLsizei>(layers) * LightVolume::kRows) showEven(layers);
  if (!target_ || target_->task.key != key) {
    const bool isFar = !target_ || !isNear(target_->task.key, key);
    if (!asked_ || asked_->key != key) ask(key, isFar ? std::optional(eyeInField) : std::nullopt);
  } else if (target_->task.around) {
    ask(key, std::nullopt);
  }
  blend();
}

bool LightVolumes::isWhole(const LightVolumesKey& key) const {
  return target_ && !target_->task.around && target_->task.key == key;
}

void LightVolumes::ask(const LightVolumesKey& key, const std::optional<glm::dvec2>& around) {
  Task task{key, around};
  if (asked_ == task && job_.isBusy()) return;
  job_.request(task);
  asked_ = std::move(task);
}

void LightVolumes::showEven(std::size_t layers) {
  const auto rows = static_cast<GLsizei>(layers) * LightVolume::kRows;
  texture_ = {};
  texture_ = gl::Texture::make3D(context_, GL_RG16F, 1, rows, 1, "even light in clouds");
  texture_.setWrap(GL_REPEAT);
  const std::vector<glm::vec2> texels(static_cast<std::size_t>(rows),
                                      glm::vec2(kEvenLight.sun, kEvenLight.sky));
  texture_.upload(GL_RG, GL_FLOAT, std::as_bytes(std::span(texels)));
  target_.reset();
  now_ = {};
  stepsLeft_ = 0;
}

void LightVolumes::show(Solved solved) {
  const LightVolumesKey& key = solved.task.key;
  const auto rows = static_cast<GLsizei>(key.layers.size()) * LightVolume::kRows;
  if (!texture_ || texture_.height() != rows || texture_.width() != key.side) {
    texture_ = {};
    texture_ = gl::Texture::make3D(context_, GL_RG16F, key.side, rows, key.side, "light in clouds");
    texture_.setWrap(GL_REPEAT);
  }
  texture_.upload(GL_RG, GL_HALF_FLOAT, std::as_bytes(std::span(*solved.texels)));
  now_ = {};
  stepsLeft_ = 0;
  target_ = std::move(solved);
}

void LightVolumes::turnInto(Solved solved) {
  if (!target_ || target_->texels->size() != solved.texels->size() ||
      target_->task.key.side != solved.task.key.side) {
    show(std::move(solved));
    return;
  }
  if (stepsLeft_ == 0) now_ = *target_->texels;
  parts_ = isNear(target_->task.key, solved.task.key) ? kParts : 1;
  part_ = 0;
  stepsLeft_ = kSteps;
  target_ = std::move(solved);
}

// Light is never negative, and so the bits of halves follow it: steps between bits are steps of the light,
// even in its logarithm.
void LightVolumes::blend() {
  if (stepsLeft_ == 0) return;
  const int side = target_->task.key.side, slices = side / parts_, first = part_ * slices;
  const std::size_t ofSlice = now_.size() / static_cast<std::size_t>(side),
                    count = ofSlice * static_cast<std::size_t>(slices);
  const std::span<std::uint16_t> now =
      std::span(now_).subspan(ofSlice * static_cast<std::size_t>(first), count);
  const std::uint16_t* to = target_->texels->data() + ofSlice * static_cast<std::size_t>(first);
  for (std::size_t i = 0; i < count; ++i) {
    const int left = to[i] - now[i];
    // From and to darkness there is no way by logarithms.
    now[i] = static_cast<std::uint16_t>(now[i] == 0 ? to[i] : now[i] + left / stepsLeft_);
  }
  texture_.uploadSlices(first, slices, GL_RG, GL_HALF_FLOAT,
                        std::as_bytes(std::span<const std::uint16_t>(now)));
  if (++part_ < parts_) return;
  part_ = 0;
  if (--stepsLeft_ == 0) now_ = {};
}

}  // namespace skydrop::render
