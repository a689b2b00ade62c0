// Triangles at equal error: the patches of this program against rings of fixed detail, as the thesis
// (R. A. Bhatia) draws its land: whole chunks of 960 m around the eye, meshes that skip 1, 2, 4, 8 or 16
// samples by the chunk's distance.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "bench/expectation.h"
#include "skydrop/core/hash.h"
#include "skydrop/terrain/chunk_grid.h"
#include "skydrop/terrain/endless_terrain.h"
#include "skydrop/terrain/noise_height_source.h"

namespace skydrop::bench {
namespace {

using namespace terrain;

constexpr double kPi = 3.14159265358979323846;
constexpr int kWidth = 1920, kHeight = 1080, kPoses = 12, kPlaces = 4000;
constexpr double kNearestM = 30;  // of the places at which errors are measured

struct Pose {
  glm::dvec3 eye{0};
  double yaw = 0;
  ViewVolume view;
};

Pose randomPose(const HeightSource& land, core::RandomStream& random) {
  Pose pose;
  const glm::dvec2 at{4e4 * (random.nextUnit() - 0.5), 4e4 * (random.nextUnit() - 0.5)};
  pose.eye = {at.x, std::max(land.height(at), 0.0) + 30 * std::pow(20.0, random.nextUnit()), at.y};
  pose.yaw = 2 * kPi * random.nextUnit();
  const double pitch = -0.1;
  const glm::dvec3 forward{std::cos(pose.yaw) * std::cos(pitch), std::sin(pitch),
                           std::sin(pose.yaw) * std::cos(pitch)};
  const glm::dvec3 right{-std::sin(pose.yaw), 0.0, std::cos(pose.yaw)};
  const glm::dmat3 worldToView = glm::transpose(glm::dmat3(right, glm::cross(right, forward), -forward));
  pose.view = makeViewVolume(pose.eye, worldToView, kPi / 3, kWidth, kHeight);
  return pose;
}

// The height at a place on the mesh of a level: triangles between samples of the land, cut from north-east to
// south-west.
double meshHeight(const HeightSource& land, glm::dvec2 place, int level) {
  const double cell = cellMetres(level);
  const glm::dvec2 corner = glm::floor(place / cell) * cell, inside = (place - corner) / cell;
  const double ne = land.height(corner + glm::dvec2(cell, 0)), sw = land.height(corner + glm::dvec2(0, cell));
  if (inside.x + inside.y <= 1) {
    const double nw = land.height(corner);
    return nw + (ne - nw) * inside.x + (sw - nw) * inside.y;
  }
  const double se = land.height(corner + cell);
  return se + (sw - se) * (1 - inside.x) + (ne - se) * (1 - inside.y);
}

// A place in view and what meshes of each level show there, in pixels of vertical error.
struct Place {
  double lambda = 0;         // of this program's detail
  double chunkDistance = 0;  // from the eye to the nearest corner or edge of its chunk
  std::array<double, kTopPatchLevel + 1> offPixels{};  // signed
};

double nearestOfChunk(const HeightSource& land, const Pose& pose, const ChunkKey& chunk) {
  const glm::dvec2 origin = chunkOrigin(chunk);
  return nearestDistance(pose.view,
                         boxOf(origin, origin + kChunkMetres, land.bounds(origin, origin + kChunkMetres)));
}

std::vector<Place> placesOf(const HeightSource& land, const Pose& pose, const LodDistances& lod,
                            double farthest, core::RandomStream& random) {
  std::vector<Place> places;
  for (int i = 0; i < kPlaces; ++i) {
    const double distance = kNearestM * std::pow(farthest / kNearestM, random.nextUnit());
    const double angle = pose.yaw + (random.nextUnit() - 0.5) * 1.6;
    const glm::dvec2 at =
        glm::dvec2(pose.eye.x, pose.eye.z) + distance * glm::dvec2(std::cos(angle), std::sin(angle));
    const double height = land.height(at);
    if (height < 0) continue;
    const double away = glm::distance(pose.eye, glm::dvec3(at.x, height, at.y));
    Place place;
    place.lambda = lod.lambda(away);
    place.chunkDistance = nearestOfChunk(land, pose, chunkAt(at));
    for (std::size_t level = 0; level < place.offPixels.size(); ++level) {
      place.offPixels[level] =
          (meshHeight(land, at, static_cast<int>(level)) - height) / away * pose.view.pixelsPerRadian;
    }
    places.push_back(place);
  }
  return places;
}

double ownError(const Place& place) {
  const auto level = static_cast<std::size_t>(place.lambda);
  const double fine = place.offPixels[level], coarse = place.offPixels[level + 1];
  return std::abs(fine + (coarse - fine) * (place.lambda - static_cast<double>(level)));
}

// Ring k begins k doublings beyond `firstRing`.
int ringOf(double distance, double firstRing) {
  int ring = 0;
  while (ring + 1 < kLodCount && distance >= firstRing * (1 << ring)) ++ring;
  return ring;
}

std::size_t ringTriangles(const HeightSource& land, const Pose& pose, double firstRing, double farthest) {
  std::size_t triangles = 0;
  const ChunkKey lo = chunkAt(glm::dvec2(pose.eye.x, pose.eye.z) - farthest);
  const ChunkKey hi = chunkAt(glm::dvec2(pose.eye.x, pose.eye.z) + farthest);
  for (std::int64_t z = lo.z; z <= hi.z; ++z) {
    for (std::int64_t x = lo.x; x <= hi.x; ++x) {
      const ChunkKey chunk{x, z, 0};
      const glm::dvec2 origin = chunkOrigin(chunk);
      const Box box = boxOf(origin, origin + kChunkMetres, land.bounds(origin, origin + kChunkMetres));
      if (nearestGroundDistance(pose.view, box) > farthest || !mayBeVisible(pose.view, box)) continue;
      const int cells = kChunkCells >> ringOf(nearestDistance(pose.view, box), firstRing);
      triangles += static_cast<std::size_t>(2 * cells * cells);
    }
  }
  return triangles;
}

// The rings' first radius is the smallest with which their error, over the same places, is no larger than
// this program's; both are counted up to the view distance, where rings end.
void trianglesAgainstRings(benchmark::State& state) {
  const TerrainStreamingSettings settings;
  const double farthest = settings.viewDistanceM;
  const auto land = makeNoiseHeightSource({}, 1);
  for (auto _ : state) {
    core::JobPool pool;
    EndlessTerrain terrain(land, pool, settings);
    core::RandomStream random{3, 0};
    std::vector<Pose> poses;
    std::vector<Place> places;
    std::size_t own = 0, all = 0;  // within the view distance; up to the horizon
    for (int i = 0; i < kPoses; ++i) {
      poses.push_back(randomPose(*land, random));
      const TerrainFrame& frame = terrain.settle(poses.back().view);
      all += frame.patches.size() * kTrianglesPerPatch;
      own += kTrianglesPerPatch * static_cast<std::size_t>(std::count_if(
                                      frame.patches.begin(), frame.patches.end(),
                                      [&](const PatchDraw& p) { return p.distanceM < farthest; }));
      const std::vector<Place> more = placesOf(*land, poses.back(), frame.lod, farthest, random);
      places.insert(places.end(), more.begin(), more.end());
    }
    // The value that 99.9 % of the places keep below: the very worst is an accident of where they lie.
    const auto worst = [&](const auto& errorOf) {
      std::vector<double> errors;
      for (const Place& place : places) errors.push_back(errorOf(place));
      const auto nth = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() * 999 / 1000);
      std::nth_element(errors.begin(), nth, errors.end());
      return *nth;
    };
    const double ownPixels = worst(ownError);
    const auto ringPixels = [&](double firstRing) {
      return worst([&](const Place& place) {
        return std::abs(place.offPixels[static_cast<std::size_t>(ringOf(place.chunkDistance, firstRing))]);
      });
    };
    double enough = farthest, tooLittle = 1;
    while (enough > 1.02 * tooLittle) {
      const double middle = std::sqrt(enough * tooLittle);
      (ringPixels(middle) <= ownPixels ? enough : tooLittle) = middle;
    }
    std::size_t rings = 0;
    for (const Pose& pose : poses) rings += ringTriangles(*land, pose, enough, farthest);
    state.counters["ownPixels"] = ownPixels;
    state.counters["ringPixels"] = ringPixels(enough);
    state.counters["firstRingM"] = enough;
    state.counters["ownTriangles"] = static_cast<double>(own / kPoses);
    state.counters["ringTriangles"] = static_cast<double>(rings / kPoses);
    state.counters["ownToHorizon"] = static_cast<double>(all / kPoses);
    state.counters["ratio"] = static_cast<double>(own) / static_cast<double>(rings);
    expect(2 * own <= rings, "more than half the triangles of fixed rings of the same error");
  }
}
BENCHMARK(trianglesAgainstRings)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace skydrop::bench
