#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/terrain/chunk_data.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::app {
namespace {

enum class LandPart { octaves, storage, normals };
constexpr std::array<std::string_view, 3> kPartNames = {"octaves", "storage", "normals"};
enum class HeightStorage { exact, float32, sixteenBits, eightBits };
constexpr std::array<std::string_view, 4> kStorageNames = {"exact", "float32", "sixteenBits", "eightBits"};
enum class NormalMethod { analytic, differences, twoBytes };
constexpr std::array<std::string_view, 3> kNormalNames = {"analytic", "differences", "twoBytes"};

struct LandParameters {
  LandPart what = LandPart::octaves;
  std::int64_t details = 5;
  HeightStorage storage = HeightStorage::exact;
  NormalMethod normals = NormalMethod::twoBytes;
  double spacingM = 4;
};

void describe(core::SettingsVisitor& visitor, LandParameters& p) {
  visitor.choice("what", p.what, kPartNames, {.help = "Heights by octaves or storage, or normals."});
  visitor.integer(
      "details", p.details,
      {.unit = "1", .min = 0, .max = 5, .help = "Octaves that are summed of those finer than hills."});
  visitor.choice("storage", p.storage, kStorageNames, {.help = "What keeps a height."});
  visitor.choice("normals", p.normals, kNormalNames, {.help = "Where a normal comes from."});
  visitor.number("spacingM", p.spacingM,
                 {.unit = "m", .min = 1e-4, .max = 64, .help = "Between the heights of a difference."});
}

// Where the land is looked at: a square of 4.8 km around the start.
constexpr int kSide = 96;
constexpr double kSpacingM = 50;
constexpr std::uint64_t kSeed = 1;

double stored(HeightStorage storage, double height) {
  const terrain::HeightRange range;
  constexpr double kCodes = 256;
  switch (storage) {
    case HeightStorage::exact:
      return height;
    case HeightStorage::float32:
      return static_cast<float>(height);
    case HeightStorage::sixteenBits:
      return range.decode(range.encode(height));
    case HeightStorage::eightBits: {
      const double step = (range.highest - range.lowest) / (kCodes - 1);
      return range.lowest + std::round((height - range.lowest) / step) * step;
    }
  }
  return height;
}

class LandSubject final : public TableSubject<LandParameters> {
  accuracy::Observation compute(const LandParameters& p) override {
    prepare(p);
    accuracy::Observation observation;
    observation.unit = "m";
    for (int row = 0; row < kSide; ++row) {
      for (int column = 0; column < kSide; ++column) {
        const glm::dvec2 at = glm::dvec2(column - kSide / 2, row - kSide / 2) * kSpacingM;
        if (p.what == LandPart::normals) {
          observation.directions.push_back(normalAt(p, at));
        } else {
          observation.values.push_back(stored(p.storage, source_->height(at)));
        }
      }
    }
    return observation;
  }

  double work(const LandParameters& p) override {
    prepare(p);
    if (p.what == LandPart::octaves) return terrain::makeChunk(*source_, {}).bounds.highest;
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const glm::dvec2 at = glm::dvec2(i % kSide, i / kSide) * kSpacingM;
      sum += p.what == LandPart::normals ? normalAt(p, at).x : stored(p.storage, at.x * 0.1 + at.y * 0.01);
    }
    return sum;
  }

  void prepare(const LandParameters& p) {
    if (source_ && details_ == p.details) return;
    details_ = p.details;
    source_ = terrain::makeCoarsenedNoiseHeightSource({}, kSeed, static_cast<std::size_t>(p.details));
  }

  glm::dvec3 normalAt(const LandParameters& p, glm::dvec2 at) const {
    if (p.normals == NormalMethod::differences) {
      const double h = p.spacingM;
      terrain::HeightSample sample;
      sample.gradient = {
          (source_->height(at + glm::dvec2(h, 0)) - source_->height(at - glm::dvec2(h, 0))) / (2 * h),
          (source_->height(at + glm::dvec2(0, h)) - source_->height(at - glm::dvec2(0, h))) / (2 * h)};
      return terrain::normalOf(sample);
    }
    const terrain::HeightSample sample = source_->sample(at);
    if (p.normals == NormalMethod::analytic) return terrain::normalOf(sample);
    return terrain::decodeNormal(terrain::encodeNormal(sample.gradient));
  }

  std::shared_ptr<const terrain::HeightSource> source_;
  std::int64_t details_ = 0;
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeLandSubject() { return std::make_unique<LandSubject>(); }

}  // namespace skydrop::app
