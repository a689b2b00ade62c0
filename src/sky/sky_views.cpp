#include "skydrop/sky/sky_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <glm/trigonometric.hpp>

namespace skydrop::sky {
namespace {

namespace f64 = core::shared::f64;

// Heights grow by this share of themselves and half the haze's height, so that no layer is skipped.
constexpr double kHeightGrowth = 1.15;
// Elevations are 0.125 degrees apart at the horizon, 0.3 at -6 degrees, 4 at the zenith: twilight halves
// within one.
constexpr double kLevelDegrees = 3, kPerLevel = 24;
// Above, where skies change with the height in another way and nobody flies, they are made as they are asked
// for.
constexpr double kHighestCornerM = 60000;
constexpr std::size_t kMostCorners = 32;  // of 100 KB
constexpr std::size_t kMostAirs = 3;

double heightOnGrid(const Atmosphere& air, double heightM) {
  return std::log1p(std::max(heightM, 0.0) / (0.5 * air.hazeHeight)) / std::log(kHeightGrowth);
}

double heightOf(const Atmosphere& air, int place) {
  return 0.5 * air.hazeHeight * std::expm1(place * std::log(kHeightGrowth));
}

double elevationOnGrid(double sine) {
  return kPerLevel * std::asinh(glm::degrees(std::asin(std::clamp(sine, -1.0, 1.0))) / kLevelDegrees);
}

double sineOf(int place) {
  const double degrees = kLevelDegrees * std::sinh(place / kPerLevel);
  return std::sin(glm::radians(std::clamp(degrees, -90.0, 90.0)));
}

bool isSame(const Atmosphere& a, const Atmosphere& b) {
  return a.rayleigh == b.rayleigh && a.rayleighHeight == b.rayleighHeight && a.haze == b.haze &&
         a.hazeHeight == b.hazeHeight && a.hazeAlbedo == b.hazeAlbedo &&
         a.hazeAnisotropy == b.hazeAnisotropy && a.ozone == b.ozone;
}

}  // namespace

std::shared_ptr<SkyViews> SkyViews::of(const Atmosphere& air) {
  static std::mutex mutex;
  static std::deque<std::shared_ptr<SkyViews>> newest;
  // The newest is the first. What was asked for stays: frames in one air outlast tables made beside them.
  const auto find = [&]() -> std::shared_ptr<SkyViews> {
    const auto found =
        std::ranges::find_if(newest, [&](const auto& views) { return isSame(views->tables().air(), air); });
    if (found == newest.end()) return nullptr;
    std::rotate(newest.begin(), found, found + 1);
    return newest.front();
  };
  {
    const std::lock_guard lock(mutex);
    if (auto found = find()) return found;
  }
  // Without the lock: others ask for airs that are there meanwhile.
  auto made = std::make_shared<SkyViews>(air);
  const std::lock_guard lock(mutex);
  if (auto found = find()) return found;
  newest.push_front(std::move(made));
  if (newest.size() > kMostAirs) newest.pop_back();
  return newest.front();
}

int SkyViews::make(Corner& corner, const Node& node, int rows) {
  const int last = std::min(corner.rows + rows, core::shared::f32::kSkyRows), made = last - corner.rows;
  if (made <= 0) return 0;
  makeSkyRows(tables_, heightOf(tables_.air(), node.first), sineOf(node.second), corner.rows, last,
              corner.view);
  corner.rows = last;
  return made;
}

SkyViews::Corner& SkyViews::cornerAt(const Node& node) {
  if (!corners_.contains(node) && corners_.size() >= kMostCorners)
    corners_.erase(std::ranges::min_element(corners_, {}, [](const auto& one) { return one.second.used; }));
  Corner& corner = corners_[node];
  corner.used = ++uses_;
  return corner;
}

std::shared_ptr<const SkyView> SkyViews::view(double heightM, double sine) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < newest_.size(); ++i) {
    const Newest& one = newest_[i];
    if (!one.view || one.heightM != heightM || one.sine != sine) continue;
    oldest_ = 1 - i;
    return one.view;
  }
  Newest& made = newest_[oldest_];
  made = {heightM, sine,
          std::make_shared<const SkyView>(heightM > kHighestCornerM ? makeSkyView(tables_, heightM, sine)
                                                                    : mixed(heightM, sine))};
  oldest_ = 1 - oldest_;
  return made.view;
}

std::vector<std::pair<SkyViews::Node, float>> SkyViews::nodesOf(const Place& place) const {
  const double height = heightOnGrid(tables_.air(), place.heightM), elevation = elevationOnGrid(place.sine);
  const int row = static_cast<int>(std::floor(height)), column = static_cast<int>(std::floor(elevation));
  const auto v = static_cast<float>(height - row), u = static_cast<float>(elevation - column);
  std::vector<std::pair<Node, float>> nodes{{{row, column}, (1 - v) * (1 - u)},
                                            {{row, column + 1}, (1 - v) * u},
                                            {{row + 1, column}, v * (1 - u)},
                                            {{row + 1, column + 1}, v * u}};
  std::erase_if(nodes, [](const auto& node) { return node.second <= 0; });
  return nodes;
}

int SkyViews::missingRows(const Place& place) {
  if (place.heightM > kHighestCornerM) return 0;  // made as it is asked for, whatever was
  const std::lock_guard lock(mutex_);
  int rows = 0;
  for (const auto& [node, share] : nodesOf(place)) {
    const auto found = corners_.find(node);
    rows += core::shared::f32::kSkyRows - (found == corners_.end() ? 0 : found->second.rows);
  }
  return rows;
}

int SkyViews::makeSome(const Place& place, int rows) {
  if (place.heightM > kHighestCornerM) return 0;
  const std::lock_guard lock(mutex_);
  int made = 0;
  for (const auto& [node, share] : nodesOf(place)) {
    if (made >= rows) break;
    made += make(cornerAt(node), node, rows - made);
  }
  return made;
}

SkyView SkyViews::mixed(double heightM, double sine) {
  SkyView mixed;
  mixed.horizon = f64::horizonSine(std::max(heightM, kLeastEyeM));
  mixed.texels.resize(static_cast<std::size_t>(kSkyLayers * f64::kSkyRows * f64::kSkyColumns));
  for (const auto& [node, share] : nodesOf({heightM, sine})) {
    Corner& corner = cornerAt(node);
    make(corner, node, f64::kSkyRows);
    for (std::size_t i = 0; i < mixed.texels.size(); ++i) mixed.texels[i] += corner.view.texels[i] * share;
  }
  return mixed;
}

void SkyViews::prepare(double heightM, double sine, int rows) {
  if (heightM > kHighestCornerM) return;
  const std::lock_guard lock(mutex_);
  const double height = heightOnGrid(tables_.air(), heightM), elevation = elevationOnGrid(sine);
  const double rises = goesOn_ ? height - lastHeight_ : 0, climbs = goesOn_ ? elevation - lastElevation_ : 0;
  lastHeight_ = height;
  lastElevation_ = elevation;
  goesOn_ = true;
  const int row = static_cast<int>(std::floor(height)), column = static_cast<int>(std::floor(elevation));
  const auto ahead = [](int at, double moves) { return moves > 0 ? at + 2 : at - 1; };
  const auto work = [&](const Node& node) {
    if (rows > 0 && node.first >= 0) rows -= make(cornerAt(node), node, rows);
  };
  for (int i = 0; i < 2 && climbs != 0; ++i) work({row + i, ahead(column, climbs)});
  for (int i = 0; i < 2 && rises != 0; ++i) work({ahead(row, rises), column + i});
}

}  // namespace skydrop::sky
