#include "render/clouds/weather_layers.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <utility>

#include "skydrop/clouds/occupancy.h"
#include "skydrop/core/thread_priority.h"
#include "skydrop/game/flown_clouds.h"
#include "skydrop/game/snapshot.h"

namespace skydrop::render {
namespace {

// Of ranges: coverage of the medium, and m of base and top. Half of the latter is what the occupancy has to
// spare; a range of cover has a twelfth more occupied cells than its least needs.
constexpr double kCoverageStep = 1.0 / 16, kWideCoverageStep = 1.0 / 4, kHeightStepM = 50;
constexpr double kUsualCoverage = 0.5, kUsualHeightM = 2000;  // that clear air is measured at
constexpr double kExtinctionSteps = 4;                        // an octave
constexpr std::array kAheadSeconds = {1.0, 3.0, 8.0, 20.0};   // that the next ranges are looked for
constexpr std::size_t kKept = 6 * WeatherLayers::kMost;
constexpr int kSide = clouds::SkyCover::kSide;

std::shared_ptr<const LayerWork> workOut(const std::shared_ptr<const clouds::PackedCloudNoise>& noise,
                                         const LayerRange& range) {
  // Strides are those of one cover and height, so that steps stay where they are when the range changes.
  clouds::LayerMedium usual = range.most;
  usual.layer.coverage = kUsualCoverage;
  usual.layer.cloudHeight = kUsualHeightM;
  clouds::LayerMedium least = range.most;
  least.layer.coverage = range.leastCoverage;
  const clouds::Occupancy occupancy(*noise, range.most, 0.5 * kHeightStepM + 1);
  const auto distances = occupancy.distances();
  return std::make_shared<const LayerWork>(LayerWork{range,
                                                     {distances.begin(), distances.end()},
                                                     occupancy.isEmpty(),
                                                     clouds::measureClearAir(noise, usual),
                                                     clouds::SkyCover(noise, least),
                                                     clouds::SkyCover(noise, range.most)});
}

}  // namespace

LayerRange rangeOf(const clouds::LayerMedium& medium) {
  LayerRange range{medium, 0};
  clouds::CloudLayerSettings& layer = range.most.layer;
  // Of sheets, whose coverage goes beyond what the map can use, fewer are enough.
  const double wide = medium.layer.coverage > 1 ? kWideCoverageStep : kCoverageStep;
  const double step = std::max(std::ceil(medium.layer.coverage / wide), 1.0);
  layer.coverage = step * wide;
  layer.anisotropy = clouds::CloudLayerSettings().anisotropy;  // how light scatters is none of a range
  layer.forwardShare = clouds::CloudLayerSettings().forwardShare;
  range.leastCoverage = (step - 1) * wide;
  const auto rounded = [](double heightM) { return std::round(heightM / kHeightStepM) * kHeightStepM; };
  layer.cloudHeight = rounded(medium.layer.cloudHeight);
  layer.thickness = std::max(rounded(medium.layer.cloudHeight + medium.layer.thickness) - layer.cloudHeight,
                             0.5 * kHeightStepM);
  if (medium.layer.extinction > 0) {
    const double octave = std::round(std::log2(medium.layer.extinction) * kExtinctionSteps);
    layer.extinction = std::exp2(octave / kExtinctionSteps);
  }
  return range;
}

double placeInRange(const LayerRange& range, const clouds::LayerMedium& medium) {
  return std::clamp(
      (medium.layer.coverage - range.leastCoverage) / (range.most.layer.coverage - range.leastCoverage), 0.0,
      1.0);
}

double DrawnLayer::skyShare(const glm::dvec2& place) const {
  return isThere ? std::lerp(work->least.share(place), work->most.share(place), share) : 1;
}

double overcastOf(const std::vector<DrawnLayer>& layers) {
  double open = 1;
  for (const DrawnLayer& layer : layers) {
    const double cover = layer.isThere ? layer.cover : 0;
    open *= 1 - cover * cover * cover;
  }
  return 1 - open;
}

WeatherLayers::WeatherLayers(gl::Context& context, std::shared_ptr<const clouds::PackedCloudNoise> noise)
    : context_(context), noise_(std::move(noise)) {}

bool WeatherLayers::hasWeather(const FrameInput& frame) {
  const weather::Moment& moment = frame.game->weather;
  const auto isClouded = [&](const weather::Forecast* forecast) {
    return forecast ? weather::hasClouds(*forecast) : weather::hasClouds(*moment.settings);
  };
  return moment &&
         (isClouded(moment.forecast.get()) || (moment.handover && isClouded(moment.handover->from.get())));
}

namespace {

// The states that a weather is mixed from: those of its sites, or of all hours of a forecast; while one takes
// over from another, those of both.
template <class Visit>
void forEachState(const weather::Moment& moment, const Visit& visit) {
  const auto visitLooked = [&](weather::State state) {
    weather::lookLow(state, moment.lowLook);
    visit(state);
  };
  const auto visitAll = [&](const weather::Forecast* forecast) {
    if (forecast) {
      for (const weather::Timeline* site : {&forecast->near, &forecast->far})
        for (const weather::TimedState& timed : site->states()) visitLooked(timed.state);
    } else {
      visitLooked(weather::stateOf(moment.settings->sites[0]));
      if (moment.settings->secondSite) visitLooked(weather::stateOf(moment.settings->sites[1]));
    }
  };
  visitAll(moment.forecast.get());
  if (moment.handover) visitAll(moment.handover->from.get());
}

// Layers that may be volumes at some place or time.
std::vector<std::size_t> volumesOf(const weather::Moment& moment) {
  std::array<bool, WeatherLayers::kMost> isVolume{};
  forEachState(moment, [&](const weather::State& state) {
    for (std::size_t i = 0; i < isVolume.size(); ++i)
      isVolume[i] = isVolume[i] || (state.layers[i].cover > 0 && game::isVolume(state.layers[i].genus));
  });
  std::vector<std::size_t> volumes;
  for (std::size_t i = 0; i < isVolume.size(); ++i) {
    if (isVolume[i]) volumes.push_back(i);
  }
  return volumes;
}

bool shellsMayOverlap(const weather::Moment& moment) {
  struct Shell {
    double low, high;
  };
  std::vector<Shell> shells;
  for (const std::size_t i : volumesOf(moment)) {
    Shell shell{1e9, -1e9};
    forEachState(moment, [&](const weather::State& state) {
      const weather::Layer& layer = state.layers[i];
      if (layer.cover > 0) shell = {std::min(shell.low, layer.baseM), std::max(shell.high, layer.topM)};
    });
    const bool overlaps = std::ranges::any_of(
        shells, [&](const Shell& other) { return shell.low < other.high && other.low < shell.high; });
    if (overlaps) return true;
    shells.push_back(shell);
  }
  return false;
}

}  // namespace

std::vector<DrawnLayer> WeatherLayers::mediaOf(const weather::Moment& moment, const glm::dvec2& place) {
  const weather::State state = moment.at(place);
  std::vector<DrawnLayer> layers;
  for (const std::size_t i : volumesOf(moment)) {
    const weather::Layer& layer = state.layers[i];
    DrawnLayer drawn;
    drawn.medium = game::cloudLayerOf(layer);
    drawn.cover = layer.cover;
    drawn.isThere = layer.cover > 0 && layer.density > 0 && game::isVolume(layer.genus);
    layers.push_back(std::move(drawn));
  }
  return layers;
}

void WeatherLayers::update(const FrameInput& frame) {
  const weather::Moment& moment = frame.game->weather;
  const glm::dvec2 place(frame.view.position.x, frame.view.position.z);
  const bool isSame = moment.settings == moment_.settings && moment.seed == moment_.seed &&
                      moment.seconds == moment_.seconds && moment.forecast == moment_.forecast &&
                      moment.clock == moment_.clock && moment.handover == moment_.handover &&
                      moment.lowLook == moment_.lowLook && place == place_;
  if (isSame) return;
  const bool isOther = moment.settings != moment_.settings || moment.forecast != moment_.forecast ||
                       moment.handover != moment_.handover || moment.lowLook != moment_.lowLook;
  moment_ = moment;
  place_ = place;
  if (isOther) mayOverlap_ = shellsMayOverlap(moment);
  const std::vector<DrawnLayer> before = std::exchange(layers_, mediaOf(moment, place));
  fields_.clear();
  for (DrawnLayer& layer : layers_) {
    fields_.emplace_back(noise_, layer.medium);
    if (!layer.isThere) continue;
    const LayerRange range = rangeOf(layer.medium);
    layer.work = get(range);
    layer.share = placeInRange(range, layer.medium);
    layer.skyMean = std::lerp(layer.work->least.meanShare(), layer.work->most.meanShare(), layer.share);
    layer.isThere = !layer.work->isEmpty;
  }
  upload(before);
  if (!frame.followsLast) return;
  const glm::dvec3 velocity = frame.game->aircraft.present ? frame.game->aircraft.velocity : glm::dvec3(0);
  for (const double ahead : kAheadSeconds) {
    weather::Moment later = moment;
    later.seconds += ahead;
    for (const DrawnLayer& layer : mediaOf(later, place + ahead * glm::dvec2(velocity.x, velocity.z))) {
      if (layer.isThere) prepare(rangeOf(layer.medium));
    }
  }
}

WeatherLayers::Work WeatherLayers::find(const LayerRange& range) const {
  const auto found = std::ranges::find_if(kept_, [&](const Work& work) { return work->range == range; });
  return found == kept_.end() ? nullptr : *found;
}

void WeatherLayers::keep(Work work) {
  std::erase(kept_, work);
  kept_.push_back(std::move(work));
  if (kept_.size() > kKept) kept_.erase(kept_.begin());
}

WeatherLayers::Work WeatherLayers::get(const LayerRange& range) {
  Work work = find(range);
  if (!work && pendingRange_ == range) {
    work = pending_.get();
    pendingRange_.reset();
  }
  if (!work) work = workOut(noise_, range);
  keep(work);
  return work;
}

void WeatherLayers::prepare(const LayerRange& range) {
  if (find(range) || pendingRange_ == range) return;
  if (pendingRange_) {
    if (pending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    keep(pending_.get());
  }
  pendingRange_ = range;
  pending_ = std::async(std::launch::async, [noise = noise_, range] {
    core::lowerThreadPriority();
    return workOut(noise, range);
  });
}

void WeatherLayers::upload(const std::vector<DrawnLayer>& before) {
  using clouds::Occupancy;
  const auto count = static_cast<int>(layers_.size());
  const auto workOf = [](const DrawnLayer& layer) { return layer.work.get(); };
  constexpr std::size_t kSlice = std::size_t{Occupancy::kSide} * Occupancy::kRows;
  if (count > 0 && !std::ranges::equal(before, layers_, {}, workOf, workOf)) {
    if (distances_.height() != count * Occupancy::kRows) {
      distances_ = gl::Texture::make3D(context_, GL_R8UI, Occupancy::kSide, count * Occupancy::kRows,
                                       Occupancy::kSide, "cloud occupancies");
    }
    std::vector<std::uint8_t> all(kSlice * Occupancy::kSide * layers_.size(), Occupancy::kFarthest);
    auto into = all.begin();
    for (std::size_t z = 0; z < Occupancy::kSide; ++z) {
      for (const DrawnLayer& layer : layers_) {
        if (layer.work) {
          std::copy_n(layer.work->distances.begin() + static_cast<std::ptrdiff_t>(z * kSlice), kSlice, into);
        }
        into += kSlice;
      }
    }
    distances_.upload(GL_RED_INTEGER, GL_UNSIGNED_BYTE, std::as_bytes(std::span(all)));
  }
  const auto skyOf = [](const DrawnLayer& layer) { return std::pair(layer.work.get(), layer.share); };
  if (count == 0 || (skyShares_ && std::ranges::equal(before, layers_, {}, skyOf, skyOf))) return;
  if (!skyShares_) {
    skyShares_ = gl::Texture::make2D(context_, GL_RGBA32F, kSide, kSide, "sky light below layers");
    skyShares_.setWrap(GL_REPEAT);
  }
  std::vector<glm::vec4> shares(std::size_t{kSide} * kSide, glm::vec4(1));
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    if (!layers_[l].isThere) continue;
    const std::vector<float>&least = layers_[l].work->least.shares(), &most = layers_[l].work->most.shares();
    const auto share = static_cast<float>(layers_[l].share);
    for (std::size_t i = 0; i < shares.size(); ++i)
      shares[i][static_cast<int>(l)] = std::lerp(least[i], most[i], share);
  }
  skyShares_.upload(GL_RGBA, GL_FLOAT, std::as_bytes(std::span(shares)));
}

}  // namespace skydrop::render
