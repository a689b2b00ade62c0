// The trees of the land as collision asks for them: the same places, kinds and sizes as are drawn, by the
// same hash (shaders/shared/woods.glsl), without any list in memory. Immutable: any thread. No libm function
// but sqrt: the same bits everywhere.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "skydrop/core/settings.h"
#include "skydrop/core/shared_woods.h"
#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::terrain {

class Places;
struct PlacesAround;

struct WoodsSettings {
  double density = 1;     // share of the trees of the woods that there are, [0, 1]
  bool obstacles = true;  // they stand in the way of the aircraft

  bool operator==(const WoodsSettings&) const = default;
};

void describe(core::SettingsVisitor& visitor, WoodsSettings& settings);

inline constexpr double kTallestTreeM = core::shared::f64::kTallestTreeM;
// No tree stands nearer to what is mown of a strip: beside it, and before its ends, m.
inline constexpr double kClearBesideStripM = 40, kClearBeforeStripM = 400;

// The share of the ground that crowns of the woods cover at a place, [0, 1], whether trees are drawn or not
// (shared::forestDensity without the land's curvature). land: of that place. 0 where there is no place.
double forestShare(const HeightSample& land, const glm::dvec2& xz, bool alpineBelts);

struct StandingTree {
  glm::dvec3 foot{0};  // world, m
  core::shared::f64::Tree shape{};
};

class Woods {
 public:
  // density: WoodsSettings::density. alpineBelts: plants grow as high as on the earth
  // (shared::alpineBeltHeight), for land of elevation data. places: of the same land, in whose fields and
  // beside whose ways nothing stands; null: there are none.
  Woods(std::shared_ptr<const HeightSource> ground, double density, bool alpineBelts,
        std::shared_ptr<const Places> places = nullptr);

  const HeightSource& ground() const { return *ground_; }
  double density() const { return density_; }
  bool hasAlpineBelts() const { return alpineBelts_; }
  const std::shared_ptr<const Places>& places() const { return places_; }

  // Those whose stems are within so many metres (at most 1000) of a place, row by row from the north-west;
  // none beyond kWorldLimitMetres or for what is not finite. About 6 us a tree of a dense wood.
  std::vector<StandingTree> around(const glm::dvec2& xz, double radiusM) const;

  // A tree within reachM (m) of one of the points, if there is any: its crown or its trunk. All points within
  // 20 m of the first. Points higher than kTallestTreeM + reachM above the land cost one height.
  std::optional<StandingTree> touching(std::span<const glm::dvec3> points, double reachM) const;

  // The strips near a place, around which nothing stands.
  std::vector<Strip> clearings(const glm::dvec2& xz, double radiusM) const;

 private:
  struct Cells;
  std::optional<StandingTree> standing(std::int64_t cellX, std::int64_t cellZ,
                                       std::span<const Strip> clearings, const PlacesAround& settled) const;
  Cells cellsAround(const glm::dvec2& xz, double radiusM) const;

  std::shared_ptr<const HeightSource> ground_;
  double density_;
  bool alpineBelts_;
  std::shared_ptr<const Places> places_;
};

}  // namespace skydrop::terrain
