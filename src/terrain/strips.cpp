#include "skydrop/terrain/strips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <shared_mutex>
#include <unordered_map>
#include <utility>

#include "skydrop/core/deterministic_math.h"
#include "skydrop/core/hash.h"
#include "skydrop/core/settings_table.h"
#include "skydrop/terrain/chunk_data.h"

namespace skydrop::terrain {
namespace {

namespace dmath = core::dmath;

constexpr int kTries = 48;
constexpr double kShoulder = 10;        // m around what is mown that are level too
constexpr double kLeastHeight = 5;      // m above the sea
constexpr double kApproachRise = 0.04;  // m a metre
constexpr double kApproachClear = 8;    // m that the land may stand above it
constexpr std::size_t kMostRemembered = 4096;

struct Cell {
  std::int64_t x = 0, z = 0;
  bool operator==(const Cell&) const = default;
};
struct CellHash {
  std::size_t operator()(const Cell& c) const {
    return core::hashCombine(core::mix64(static_cast<std::uint64_t>(c.x)), static_cast<std::uint64_t>(c.z));
  }
};

std::int64_t cellOf(double metres) { return static_cast<std::int64_t>(std::floor(metres / kStripCell)); }

bool isFar(const glm::dvec2& xz) {  // beyond the world, or not finite
  return !(std::abs(xz.x) < kWorldLimitMetres && std::abs(xz.y) < kWorldLimitMetres);
}

// How much of the strip's plane the land is at a place, and the gradient of that share.
struct Share {
  double value = 0;
  glm::dvec2 gradient{0};
};
Share shareOf(const Strip& strip, const glm::dvec2& xz) {
  const glm::dvec2 at = strip.local(xz);
  const double past = std::max(std::abs(at.x) - strip.halfLength - kShoulder, 0.0);
  const double aside = std::max(std::abs(at.y) - strip.halfWidth - kShoulder, 0.0);
  const double away = std::sqrt(past * past + aside * aside);
  if (away >= kStripMargin) return {};
  if (away <= 0) return {1, {0, 0}};
  const double t = away / kStripMargin;
  const double fall = -30 * t * t * (1 - t) * (1 - t) / kStripMargin / away;
  const glm::dvec2 right(-strip.along.y, strip.along.x);
  return {1 - t * t * t * (10 + t * (6 * t - 15)),
          fall * (strip.along * std::copysign(past, at.x) + right * std::copysign(aside, at.y))};
}

double reachOf(const Strip& strip) {  // of the changed land, from the middle
  const double l = strip.halfLength + kShoulder + kStripMargin,
               w = strip.halfWidth + kShoulder + kStripMargin;
  return std::sqrt(l * l + w * w);
}

class LandWithStrips final : public HeightSource, public Strips {
 public:
  LandWithStrips(std::shared_ptr<const HeightSource> land, const StripSettings& settings, std::uint64_t seed)
      : land_(std::move(land)), settings_(settings), seed_(core::hashCombine(seed, 0x7374726970ull)) {}

  HeightSample sample(glm::dvec2 xz) const override {
    const HeightSample plain = land_->sample(xz);
    if (isFar(xz)) return plain;
    const std::optional<Strip> strip = of({cellOf(xz.x), cellOf(xz.y)});
    return strip ? blended(*strip, xz, plain) : plain;
  }

  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    HeightBounds b = land_->bounds(lo, hi);
    forEach(lo, hi, [&](const Strip& strip) {
      const double rise = std::abs(strip.slope) * (strip.halfLength + kShoulder + kStripMargin);
      b.lowest = std::min(b.lowest, strip.height - rise);
      b.highest = std::max(b.highest, strip.height + rise);
    });
    return b;
  }
  HeightBounds range() const override { return land_->range(); }
  HeightRange storedRange() const override { return land_->storedRange(); }

  bool fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const override {
    if (!land_->fillChunk(key, stop, out)) return false;
    const glm::dvec2 origin = chunkOrigin(key);
    const double cell = cellMetres(key.level);
    const int reach = normalReach(key.level);
    const glm::dvec2 lo = origin - glm::dvec2(reach * cell),
                     hi = origin + glm::dvec2((kChunkSamples - 1 + reach) * cell);
    const auto isInside = [](int i) { return i >= 0 && i < kChunkSamples; };
    forEach(lo, hi, [&](const Strip& strip) {
      const double around = reachOf(strip);
      const auto first = [&](double at, double from) {
        return std::max(static_cast<int>(std::ceil((at - around - from) / cell)), -reach);
      };
      const auto last = [&](double at, double from) {
        return std::min(static_cast<int>(std::floor((at + around - from) / cell)), kChunkSamples - 1 + reach);
      };
      for (int row = first(strip.middle.y, origin.y); row <= last(strip.middle.y, origin.y); ++row) {
        for (int column = first(strip.middle.x, origin.x); column <= last(strip.middle.x, origin.x);
             ++column) {
          const glm::dvec2 xz = origin + glm::dvec2(column, row) * cell;
          if (shareOf(strip, xz).value <= 0) continue;
          const HeightSample s = blended(strip, xz, land_->sample(xz));
          out.normals[static_cast<std::size_t>(normalIndex(column, row))] = encodeNormal(s.gradient);
          if (!isInside(row) || !isInside(column)) continue;
          out.heights[static_cast<std::size_t>(sampleIndex(column, row))] = out.heightRange.encode(s.height);
        }
      }
    });
    return true;
  }

  const Strips* strips() const override { return this; }

  std::optional<Strip> at(const glm::dvec2& xz) const override {
    if (isFar(xz)) return {};
    std::optional<Strip> strip = of({cellOf(xz.x), cellOf(xz.y)});
    if (strip && !strip->contains(xz)) strip.reset();
    return strip;
  }

  std::optional<Strip> nearest(const glm::dvec2& xz, double reach) const override {
    std::optional<Strip> best;
    if (isFar(xz)) return best;
    const double within = std::min(reach, 60000.0);
    double least = within;
    // Ring by ring: a cell of ring n is at least n - 1 cells away.
    const Cell here{cellOf(xz.x), cellOf(xz.y)};
    for (std::int64_t ring = 0; static_cast<double>(ring - 1) * kStripCell < least; ++ring) {
      for (std::int64_t dz = -ring; dz <= ring; ++dz) {
        const std::int64_t step = std::abs(dz) == ring ? 1 : std::max<std::int64_t>(2 * ring, 1);
        for (std::int64_t dx = -ring; dx <= ring; dx += step) {
          const std::optional<Strip> strip = of({here.x + dx, here.z + dz});
          if (!strip) continue;
          const glm::dvec2 way = strip->middle - xz;
          const double distance = std::sqrt(way.x * way.x + way.y * way.y);
          if (distance <= least) least = distance, best = strip;
        }
      }
    }
    return best;
  }

 private:
  static HeightSample blended(const Strip& strip, const glm::dvec2& xz, const HeightSample& plain) {
    const Share share = shareOf(strip, xz);
    if (share.value <= 0) return plain;
    const double plane = strip.heightAt(strip.local(xz).x);
    const double apart = plane - plain.height;
    return {
        plain.height + share.value * apart,
        plain.gradient + share.value * (strip.slope * strip.along - plain.gradient) + apart * share.gradient};
  }

  // Every strip whose ground may reach into the rectangle.
  template <class F>
  void forEach(const glm::dvec2& lo, const glm::dvec2& hi, const F& f) const {
    if (isFar(lo) || isFar(hi)) return;
    for (std::int64_t z = cellOf(lo.y); z <= cellOf(hi.y); ++z) {
      for (std::int64_t x = cellOf(lo.x); x <= cellOf(hi.x); ++x) {
        const std::optional<Strip> strip = of({x, z});
        if (!strip) continue;
        const double around = reachOf(*strip);
        if (strip->middle.x + around < lo.x || strip->middle.x - around > hi.x ||
            strip->middle.y + around < lo.y || strip->middle.y - around > hi.y)
          continue;
        f(*strip);
      }
    }
  }

  std::optional<Strip> of(const Cell& cell) const {
    {
      const std::shared_lock lock(mutex_);
      const auto found = found_.find(cell);
      if (found != found_.end()) return found->second;
    }
    const std::optional<Strip> strip = search(cell);
    const std::unique_lock lock(mutex_);
    if (found_.size() >= kMostRemembered) found_.clear();
    return found_.emplace(cell, strip).first->second;
  }

  std::optional<Strip> search(const Cell& cell) const {
    core::RandomStream random{core::hashCombine(core::hashCombine(seed_, static_cast<std::uint64_t>(cell.x)),
                                                static_cast<std::uint64_t>(cell.z)),
                              0};
    if (random.nextUnit() >= settings_.density) return {};
    Strip strip;
    strip.halfLength = 0.5 * settings_.length;
    strip.halfWidth = 0.5 * settings_.width;
    const double inset = reachOf(strip);  // it lies inside its cell, so a place knows its strip by the cell
    for (int i = 0; i < kTries; ++i) {
      const double x = random.nextUnit(), z = random.nextUnit(), turn = random.nextUnit();
      strip.middle = {static_cast<double>(cell.x) * kStripCell + inset + x * (kStripCell - 2 * inset),
                      static_cast<double>(cell.z) * kStripCell + inset + z * (kStripCell - 2 * inset)};
      strip.along = {dmath::sin(turn * dmath::kTwoPi), -dmath::cos(turn * dmath::kTwoPi)};
      if (fit(strip)) return strip;
    }
    return {};
  }

  // Lays the plane through the land, and says whether that is gentle enough.
  bool fit(Strip& strip) const {
    const HeightSample middle = land_->sample(strip.middle);
    if (middle.height < kLeastHeight || isSteep(middle)) return false;
    constexpr int kLong = 6, kWide = 2;
    std::array<HeightSample, static_cast<std::size_t>((2 * kLong + 1) * (2 * kWide + 1))> samples;
    const double length = strip.halfLength + kShoulder + kStripMargin,
                 width = strip.halfWidth + kShoulder + kStripMargin;
    double sum = 0, moment = 0, squares = 0;
    std::size_t count = 0;
    for (int i = -kLong; i <= kLong; ++i) {
      for (int j = -kWide; j <= kWide; ++j) {
        const double along = length * i / kLong;
        const HeightSample s = land_->sample(strip.world(along, width * j / kWide));
        if (s.height < kLeastHeight || isSteep(s)) return false;
        samples[count++] = s;
        sum += s.height, moment += s.height * along, squares += along * along;
      }
    }
    strip.height = sum / static_cast<double>(count);
    strip.slope = std::clamp(moment / squares, -kMostStripSlope, kMostStripSlope);
    count = 0;
    for (int i = -kLong; i <= kLong; ++i) {
      const double plane = strip.heightAt(length * i / kLong);
      for (int j = -kWide; j <= kWide; ++j) {
        if (std::abs(samples[count++].height - plane) > kMostCut) return false;
      }
    }
    const bool from = isApproachFree(strip), back = isApproachFree(strip.reversed());
    if (!from && !back) return false;
    strip.bothWays = from && back;
    if (!from) strip = strip.reversed();
    return true;
  }

  static bool isSteep(const HeightSample& s) {
    return s.gradient.x * s.gradient.x + s.gradient.y * s.gradient.y > kMostStripGround * kMostStripGround;
  }

  bool isApproachFree(const Strip& strip) const {
    for (double before = 100; before <= kStripApproach; before += 100) {
      const double land = std::max(land_->height(strip.world(-strip.halfLength - before, 0)), 0.0);
      if (land > strip.heightAt(-strip.halfLength) + kApproachClear + kApproachRise * before) return false;
    }
    return true;
  }

  std::shared_ptr<const HeightSource> land_;
  StripSettings settings_;
  std::uint64_t seed_;
  mutable std::shared_mutex mutex_;
  mutable std::unordered_map<Cell, std::optional<Strip>, CellHash> found_;
};

}  // namespace

bool Strip::contains(const glm::dvec2& xz) const {
  const glm::dvec2 at = local(xz);
  return std::abs(at.x) <= halfLength && std::abs(at.y) <= halfWidth;
}

double Strip::headingRad() const {
  const double heading = dmath::atan2(along.x, -along.y);
  return heading < 0 ? heading + dmath::kTwoPi : heading;
}

Strip Strip::reversed() const {
  Strip other = *this;
  other.along = -along;
  other.slope = -slope;
  return other;
}

void describe(core::SettingsVisitor& v, StripSettings& s) {
  v.number("length", s.length,
           {.unit = "m",
            .min = 200,
            .max = 1500,
            .help = "Of what is mown: longer ones fit in fewer places.",
            .takesEffect = core::TakesEffect::restart,
            .aliases = "runway, airstrip"});
  v.number("width", s.width,
           {.unit = "m",
            .min = 10,
            .max = 120,
            .help = "Of what is mown.",
            .takesEffect = core::TakesEffect::restart,
            .aliases = "runway, airstrip"});
  v.number("density", s.density,
           {.unit = "1",
            .min = 0,
            .max = 1,
            .help = "Share of the land's squares of 8 km that have a strip where one fits; 0 for none.",
            .takesEffect = core::TakesEffect::restart,
            .aliases = "runway, airstrip"});
}

std::shared_ptr<const HeightSource> makeLandWithStrips(std::shared_ptr<const HeightSource> land,
                                                       const StripSettings& settings, std::uint64_t seed) {
  StripSettings checked = settings;
  const core::SettingsTable table(checked);
  for (const core::Field& field : table.fields()) core::setField(field, field.get());
  return std::make_shared<LandWithStrips>(std::move(land), settings, seed);
}

}  // namespace skydrop::terrain
