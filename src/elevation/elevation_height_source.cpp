#include "skydrop/elevation/elevation_height_source.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "elevation/elevation_source.h"
#include "elevation/mosaic.h"
#include "elevation/row_reader.h"
#include "elevation/surface_kernels.h"
#include "skydrop/core/error.h"
#include "skydrop/terrain/chunk_data.h"

namespace skydrop::elevation {
namespace {

using terrain::ChunkData;
using terrain::ChunkKey;
using terrain::HeightBounds;
using terrain::HeightRange;
using terrain::HeightSample;

// What floats and sums of shares round to may leave the bounds of their parts by this, m.
constexpr double kRounding = 1e-2;

// What is put together of the mosaics, and how much is left for the land beyond them.
struct Sum {
  double height = 0, rest = 1;
  glm::dvec2 gradient{}, restGradient{};

  void add(const Mosaic::Sample& of) {
    const double share = rest * of.weight;
    gradient += (restGradient * of.weight + rest * of.weightGradient) * of.height + share * of.gradient;
    height += share * of.height;
    restGradient = restGradient * (1 - of.weight) - rest * of.weightGradient;
    rest *= 1 - of.weight;
  }
  void addRest(double of, glm::dvec2 ofGradient) {
    height += rest * of;
    gradient += restGradient * of + rest * ofGradient;
    rest = 0;
  }
};

double insideWorld(double metres) {
  return metres == metres ? std::clamp(metres, -terrain::kWorldLimitMetres, terrain::kWorldLimitMetres) : 0.0;
}

class Source final : public ElevationHeightSource {
 public:
  Source(std::vector<std::unique_ptr<Mosaic>> mosaics, std::shared_ptr<const HeightSource> beyond,
         const SurfaceKernels& kernels)
      : mosaics_(std::move(mosaics)), beyond_(std::move(beyond)), kernels_(kernels) {
    const HeightBounds around = beyond_->range();
    // So that the land around begins where the data end, and has no sea where they lie high.
    double edges = mosaics_.back()->meanOfEdges();
    const double middle = std::max(0.0, around.lowest + 0.25 * (around.highest - around.lowest));
    facts_.raisedM = std::floor(std::max(0.0, edges - middle));
    double lowest = around.lowest + facts_.raisedM, highest = around.highest + facts_.raisedM;
    facts_.lowest = 1e9;
    facts_.highest = -1e9;
    for (const auto& mosaic : mosaics_) {
      const Bounds surface = mosaic->ofSurface();
      lowest = std::min(lowest, static_cast<double>(surface.lowest));
      highest = std::max(highest, static_cast<double>(surface.highest));
      for (const Tile& tile : mosaic->tiles()) {
        ++facts_.tiles;
        facts_.cells +=
            static_cast<std::size_t>(tile.raster->width()) * static_cast<std::size_t>(tile.raster->height());
        facts_.voids += tile.survey->voids();
        facts_.lowest = std::min(facts_.lowest, static_cast<double>(tile.survey->all().lowest));
        facts_.highest = std::max(facts_.highest, static_cast<double>(tile.survey->all().highest));
      }
    }
    range_ = {lowest - kRounding, highest + kRounding};
    stored_ = {std::floor(range_.lowest), std::floor(range_.highest) + 1};
    stored_.requireValid();
  }

  HeightSample sample(glm::dvec2 position) const override {
    const glm::dvec2 xz{insideWorld(position.x), insideWorld(position.y)};
    Sum sum;
    for (const auto& mosaic : mosaics_) {
      sum.add(mosaic->at(xz));
      if (sum.rest == 0) break;
    }
    if (sum.rest > 0) {
      const HeightSample around = beyond_->sample(xz);
      sum.addRest(around.height + facts_.raisedM, around.gradient);
    }
    return {sum.height, sum.gradient};
  }

  HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    std::optional<HeightBounds> all;
    bool isCovered = false;
    for (const auto& mosaic : mosaics_) {
      if (const std::optional<Bounds> of = mosaic->bounds({lo, hi})) {
        const double lowest = of->lowest - kRounding, highest = of->highest + kRounding;
        all = all ? HeightBounds{std::min(all->lowest, lowest), std::max(all->highest, highest)}
                  : HeightBounds{lowest, highest};
      }
      isCovered = isCovered || mosaic->covers({lo, hi});
    }
    if (!isCovered || !all) {
      const HeightBounds around = beyond_->bounds(lo, hi);
      const double lowest = around.lowest + facts_.raisedM, highest = around.highest + facts_.raisedM;
      all = all ? HeightBounds{std::min(all->lowest, lowest), std::max(all->highest, highest)}
                : HeightBounds{lowest, highest};
    }
    return *all;
  }

  HeightBounds range() const override { return range_; }
  HeightRange storedRange() const override { return stored_; }

  bool fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const override;

  ElevationFacts facts() const override { return facts_; }
  bool hasData(glm::dvec2 xz) const override {
    return std::any_of(mosaics_.begin(), mosaics_.end(),
                       [&](const auto& mosaic) { return mosaic->at(xz).weight == 1; });
  }
  std::size_t keptBytes() const override {
    std::size_t bytes = 0;
    for (const auto& mosaic : mosaics_) bytes += mosaic->keptBytes();
    return bytes;
  }
  std::uint64_t faults() const override {
    std::uint64_t count = 0;
    for (const auto& mosaic : mosaics_) count += mosaic->faults();
    return count;
  }

 private:
  std::vector<std::unique_ptr<Mosaic>> mosaics_;  // never empty
  std::shared_ptr<const HeightSource> beyond_;
  ElevationFacts facts_;
  HeightBounds range_;
  HeightRange stored_;
  const SurfaceKernels& kernels_;
};

ChunkCoding codingOf(const HeightRange& range) {
  return {static_cast<float>(range.lowest), static_cast<float>(range.step())};
}

}  // namespace

bool Source::fillChunk(const ChunkKey& key, std::stop_token stop, ChunkData& out) const {
  const glm::dvec2 origin = terrain::chunkOrigin(key);
  const double cell = terrain::cellMetres(key.level);
  const int reach = terrain::normalReach(key.level), side = terrain::kChunkSamples + 2 * reach;
  const double margin = (reach + 1) * cell, size = terrain::chunkMetres(key.level);
  const WorldRect rect{origin - glm::dvec2(margin, margin),
                       origin + glm::dvec2(size + margin, size + margin)};
  std::vector<RowReader> readers;
  bool isCovered = false;
  for (const auto& mosaic : mosaics_) {
    if (isCovered || !mosaic->bounds(rect)) continue;
    readers.emplace_back(*mosaic, kernels_, rect);
    isCovered = mosaic->covers(rect);
  }

  // Whatever of the land around is missing, all of its chunk is made: a row of it needs rows beside it.
  ChunkData around;
  std::vector<std::uint16_t> aroundHeights;
  if (!isCovered) {
    around.heightRange = beyond_->storedRange();
    around.heights.resize(out.heights.size());
    around.normals.resize(out.normals.size());
    if (!beyond_->fillWideChunk(key, stop, around, aroundHeights)) return false;
  }
  const ChunkCoding coding = codingOf(out.heightRange), codingAround = codingOf(around.heightRange);
  const auto land = std::make_unique<LandRow>();
  std::array<std::uint16_t, kRowSize> heights;
  for (int row = -reach; row < terrain::kChunkSamples + reach; ++row) {
    if (stop.stop_requested()) return false;
    *land = {};
    std::fill_n(land->rest, kRowSize, 1.0F);
    for (RowReader& reader : readers) {
      if (reader.read(origin + cell * glm::dvec2(-reach, row), cell, side))
        kernels_.add(side, reader.row(), *land);
    }
    const auto normals = static_cast<std::size_t>(terrain::normalIndex(-reach, row));
    if (!isCovered)
      kernels_.addAround(side, codingAround, static_cast<float>(facts_.raisedM),
                         aroundHeights.data() + (row + reach) * side, around.normals.data() + normals, *land);
    kernels_.finish(side, coding, *land, heights.data(), out.normals.data() + normals);
    if (row >= 0 && row < terrain::kChunkSamples)
      std::copy_n(heights.data() + reach, terrain::kChunkSamples,
                  out.heights.data() + terrain::sampleIndex(0, row));
  }
  return true;
}

std::shared_ptr<const ElevationHeightSource> makeElevationHeightSource(
    const std::vector<std::shared_ptr<const Raster>>& rasters, const ElevationSettings& settings,
    std::shared_ptr<const terrain::HeightSource> beyond) {
  return makeElevationHeightSource(rasters, settings, std::move(beyond), bestSurfaceKernels());
}

std::shared_ptr<const ElevationHeightSource> makeElevationHeightSource(
    const std::vector<std::shared_ptr<const Raster>>& rasters, const ElevationSettings& settings,
    std::shared_ptr<const terrain::HeightSource> beyond, const SurfaceKernels& kernels) {
  if (!(settings.blendM >= 1 && settings.blendM <= 1e5))
    throw core::RangeError("the distance over which elevation data end must be 1 to 100000 m");
  return std::make_shared<Source>(
      makeMosaics(LocalPlane({settings.latitude, settings.longitude}), rasters, settings.blendM),
      std::move(beyond), kernels);
}

}  // namespace skydrop::elevation
