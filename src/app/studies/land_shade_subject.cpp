#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/hash.h"
#include "skydrop/render/shadows/land_shadow_settings.h"
#include "skydrop/sky/atmosphere.h"
#include "skydrop/terrain/land_shade.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::app {
namespace {

enum class ShadeMethod { swept, rays };
constexpr std::array<std::string_view, 2> kMethodNames = {"swept", "rays"};

struct LandShadeParameters {
  ShadeMethod method = ShadeMethod::swept;
  render::LandShadowSettings swept;
  double rayStepM = 2;
  double aboveM = 0;
  double sunElevationDegrees = 6, sunAzimuthDegrees = 265;
};

void describe(core::SettingsVisitor& visitor, LandShadeParameters& p) {
  visitor.choice("method", p.method, kMethodNames,
                 {.help = "The map that is swept over heights, or a ray for each place."});
  describe(visitor, p.swept);
  visitor.number(
      "rayStepM", p.rayStepM,
      {.unit = "m", .min = 0.1, .max = 100, .help = "First step of a ray; they grow with the way."});
  visitor.number("aboveM", p.aboveM,
                 {.unit = "m",
                  .min = 0,
                  .max = 4000,
                  .help = "Of the places over the land: 0 is its surface, more is air or cloud."});
  visitor.number("sunElevationDegrees", p.sunElevationDegrees,
                 {.unit = "degree", .min = 0.5, .max = 90, .help = "Above the horizon."});
  visitor.number("sunAzimuthDegrees", p.sunAzimuthDegrees,
                 {.unit = "degree", .min = 0, .max = 360, .help = "By compass."});
}

constexpr int kPlaces = 500;
constexpr double kReachM = 2000;  // of them along either axis, within the finest level of every detail
constexpr glm::dvec2 kEye{2500, -1200};
constexpr double kBlockM = 100;  // of a ray's way, at least, is skipped at once where its land is low enough
constexpr std::uint64_t kSeed = 1;

// The share of the sun's disc that is left at places on the shipped land, or in the air over it.
class LandShadeSubject final : public TableSubject<LandShadeParameters> {
  accuracy::Observation compute(const LandShadeParameters& p) override {
    const glm::dvec3 toSun = sky::directionToSun(p.sunElevationDegrees, p.sunAzimuthDegrees);
    const terrain::ShadeAxes axes(toSun);
    accuracy::Observation observation;
    const auto observe = [&](const auto& shareAt) {
      core::RandomStream random{7, 0};
      for (int i = 0; i < kPlaces; ++i) {
        const double x = random.nextUnit(), z = random.nextUnit();
        observation.values.push_back(shareAt(kEye + (glm::dvec2(x, z) * 2.0 - 1.0) * kReachM));
      }
    };
    if (p.method == ShadeMethod::rays) {
      observe([&](glm::dvec2 xz) { return shareByRay(xz, p.aboveM, toSun, axes, p.rayStepM); });
    } else {
      const terrain::LandShade shade = sweep(p);
      observe([&](glm::dvec2 xz) {
        return p.aboveM == 0 ? terrain::shareOfDisc(shade.clearanceAt(0, xz))
                             : shade.sunShare({xz.x, landAt(xz) + p.aboveM, xz.y});
      });
    }
    return observation;
  }

  double work(const LandShadeParameters& p) override {
    if (p.method == ShadeMethod::swept) return sweep(p).topM();
    return compute(p).values.front();
  }

  // Heights are kept from one to the next, as they are while the sun moves.
  terrain::LandShade sweep(const LandShadeParameters& p) {
    const glm::dvec3 toSun = sky::directionToSun(p.sunElevationDegrees, p.sunAzimuthDegrees);
    terrain::ShadeHeights& heights = heights_[static_cast<std::size_t>(p.swept.detail)];
    return terrain::LandShade::make(heights, terrain::shadeKey(shadeLayout(p.swept), kEye, toSun));
  }

  double landAt(glm::dvec2 xz) const { return std::max(land_->height(xz), 0.0); }

  // By the steepest way from the place to land on the ray: the edge that cuts the disc.
  double shareByRay(glm::dvec2 xz, double aboveM, const glm::dvec3& toSun, const terrain::ShadeAxes& axes,
                    double stepM) const {
    const glm::dvec2 way = glm::normalize(glm::dvec2(toSun.x, toSun.z));
    const double from = landAt(xz) + aboveM, top = land_->range().highest;
    double edge = axes.tanLowerLimb;  // tangent of its elevation; what is below the disc hides nothing of it
    double blockEnd = 0;
    bool isClear = false;  // in the block no land can stand above the edge
    for (double t = stepM; from + edge * t <= top && edge < axes.tanUpperLimb;
         t += stepM + t * stepM / 2000) {
      if (t >= blockEnd) {
        blockEnd = t + kBlockM + t / 10;
        const glm::dvec2 near = xz + way * t, far = xz + way * blockEnd;
        const double highest = land_->bounds(glm::min(near, far), glm::max(near, far)).highest;
        isClear = highest - from <= edge * t;
      }
      if (!isClear) edge = std::max(edge, (landAt(xz + way * t) - from) / t);
    }
    return terrain::shareOfDisc((axes.tanUpperLimb + axes.tanLowerLimb - 2 * edge) /
                                (axes.tanUpperLimb - axes.tanLowerLimb));
  }

  std::shared_ptr<const terrain::HeightSource> land_ = terrain::makeNoiseHeightSource({}, kSeed);
  // Of each detail its own: a sweep forgets heights that the last few did not use.
  std::array<terrain::ShadeHeights, render::kLandShadowDetailNames.size()> heights_{
      terrain::ShadeHeights(land_), terrain::ShadeHeights(land_), terrain::ShadeHeights(land_),
      terrain::ShadeHeights(land_)};
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeLandShadeSubject() { return std::make_unique<LandShadeSubject>(); }

}  // namespace skydrop::app
