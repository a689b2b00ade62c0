// What the land makes of its rows.
#include <condition_variable>
#include <glm/trigonometric.hpp>
#include <mutex>
#include <string>

#include "app/session/run_config.h"
#include "app/settings_probe_parts.h"
#include "skydrop/core/image.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/core/shared.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/elevation/elevation_height_source.h"
#include "skydrop/terrain/analytic_height_sources.h"
#include "skydrop/terrain/endless_terrain.h"
#include "skydrop/terrain/places.h"
#include "skydrop/terrain/strips.h"
#include "skydrop/terrain/woods.h"
#include "support/temporary_folder.h"

namespace skydrop::app {
namespace {

using core::StateHasher;

// The nearest strips of a gentle land, and the land on them.
std::uint64_t stripHeights(const Settings& settings) {
  StateHasher h;
  const auto ground = terrain::makeLandWithStrips(probedLand(), settings.strips, 1);
  for (int x = -4; x <= 4; ++x) {
    for (int z = -4; z <= 4; ++z) {
      const auto strip = ground->strips()->nearest({x * 6000.0, z * 6000.0}, 8000);
      h.add(std::uint64_t{strip.has_value()});
      if (!strip) continue;
      h.add(strip->middle.x), h.add(strip->halfLength), h.add(strip->halfWidth);
      h.add(ground->height(strip->world(strip->halfLength, strip->halfWidth)));
    }
  }
  return h.value();
}

// How many trees stand in some woods.
std::uint64_t standingTrees(const Settings& settings) {
  StateHasher h;
  const terrain::Woods woods(probedLand(), settings.woods.density, false);
  h.add(std::uint64_t{woods.around({-1600, -3300}, 60).size()});
  return h.value();
}

// How many buildings and blocks of fields some villages have.
std::uint64_t builtPlaces(const Settings& settings) {
  StateHasher h;
  const terrain::Places places(probedLand(), settings.villages);
  for (const auto& village : places.around({0, 2000}, 9000).villages) {
    h.add(std::uint64_t{village->parts.size()});
    for (const std::uint32_t row : village->blocks) h.add(std::uint64_t{row});
  }
  return h.value();
}

// A hill of elevation data by Bern, and what is around it.
const std::string& elevationFile() {
  static const test::TemporaryFolder folder;
  static const std::string file =
      folder.write("hill.asc",
                   "ncols 4\nnrows 3\nxllcorner 2600000\nyllcorner 1199000\n"
                   "cellsize 500\n500 520 540 500\n600 900 700 560\n480 500 520 500\n");
  return file;
}

std::uint64_t elevationHeights(const Settings& settings) {
  const auto land = elevation::makeElevationHeightSource({elevation::openRaster(elevationFile())},
                                                         settings.elevation, terrain::makeFlatSource(0));
  core::StateHasher h;
  for (double x = -5000; x < 6000; x += 300) h.add(land->height({x, -x / 3}));
  return h.value();
}

std::uint64_t originPlace(const Settings& settings) {
  const elevation::GeoPlace place =
      elevation::LocalPlane({settings.elevation.latitude, settings.elevation.longitude})
          .placeOf({1000, 2000});
  core::StateHasher h;
  h.add(place.latitude);
  h.add(place.longitude);
  return h.value();
}

// An aerial image of 12 km around Bern, laid out.
std::uint64_t groundPictures(const Settings& settings) {
  static const test::TemporaryFolder folder;
  static const auto image = [] {
    core::Image picture(512, 512);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
      picture.rgba[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 255 : i / 512 % 200);
    core::writePng(folder.path() / "image.png", picture);
    return elevation::openAerialImage(folder.path() / "image.png",
                                      elevation::ImageCorners{2594000, 1194000, 2606000, 1206000});
  }();
  const terrain::GroundPicture picture =
      elevation::makeGroundPicture({image}, {46.95, 7.44}, settings.aerialImage);
  core::StateHasher h;
  for (const std::uint8_t byte : picture.levels[1].rgba) h.add(static_cast<std::uint64_t>(byte));
  return h.value();
}

// What the land wears of an image, by the formulas of the shader.
std::uint64_t wornGround(const Settings& settings) {
  namespace shared = core::shared::f64;
  const terrain::GroundPictureSettings& worn = settings.aerialImage;
  core::StateHasher h;
  for (double distance = 10; distance < 20000; distance *= 1.3) {
    const double share = shared::groundPictureShare(0.8, distance, worn.share, worn.nearShare, worn.nearM);
    h.add(shared::pictured({0.1, 0.2, 0.1}, {0.3, 0.3, 0.2}, share, worn.gain).x);
  }
  return h.value();
}
// Where a flight over the file begins.
std::uint64_t elevationRun(const Settings& settings) {
  CommandLine line;
  line.verb = Verb::simulate;
  line.elevationFiles = {elevationFile()};
  line.set = {std::string("elevation.atCentre=") + (settings.elevation.atCentre ? "true" : "false")};
  const auto run = prepareRun(line);
  core::StateHasher h;
  h.add(run->settings.elevation.latitude);
  return h.value();
}

std::uint64_t heights(const Settings& settings) {
  const auto source = terrain::makeNoiseHeightSource(settings.terrain, 1);
  StateHasher h;
  for (int z = -20; z < 20; ++z)
    for (int x = -20; x < 20; ++x) h.add(source->height({x * 1003.0, z * 1003.0}));
  return h.value();
}

terrain::ViewVolume volume(const glm::dvec3& eye, int width, int height) {
  const double pitch = glm::radians(-10.0);
  const glm::dmat3 toView = glm::transpose(glm::dmat3(
      glm::dvec3(1, 0, 0), {0, std::cos(pitch), std::sin(pitch)}, {0, -std::sin(pitch), std::cos(pitch)}));
  return terrain::makeViewVolume(eye, toView, glm::radians(60.0), width, height);
}
terrain::ViewVolume small() { return volume({0, 900, 0}, 320, 180); }
terrain::ViewVolume large() { return volume({0, 900, 0}, 1920, 1080); }

void add(StateHasher& h, const terrain::EndlessTerrain& endless) {
  const terrain::StreamingStatistics& s = endless.statistics();
  for (const std::size_t count : {s.chunksWanted, s.chunksDrawn, s.patches, s.overBudget})
    h.add(static_cast<std::uint64_t>(count));
  for (const terrain::PatchDraw& patch : endless.frame().patches) h.add(patch.distanceM);
}

// One terrain for all, so that chunks are made once.
terrain::EndlessTerrain& sharedTerrain() {
  static core::JobPool pool(2);
  static terrain::EndlessTerrain endless(probedLand(), pool, terrain::TerrainStreamingSettings());
  return endless;
}

// What is drawn when everything that the view wants is there.
std::uint64_t settled(const Settings& settings, const terrain::ViewVolume& view) {
  terrain::EndlessTerrain& endless = sharedTerrain();
  endless.apply(settings.streaming);
  endless.settle(view);
  StateHasher h;
  add(h, endless);
  for (const double level : endless.frame().lod.morph) h.add(level);
  return h.value();
}
std::uint64_t detail(const Settings& settings) { return settled(settings, large()); }
std::uint64_t budget(const Settings& settings) { return settled(settings, small()); }

// Above the deepest sea around.
std::uint64_t seaFloor(const Settings& settings) {
  static const glm::dvec2 deepest = [] {
    glm::dvec2 place(0);
    double lowest = 0;
    for (int z = -100; z < 100; ++z) {
      for (int x = -100; x < 100; ++x) {
        const double height = probedLand()->height({x * 500.0, z * 500.0});
        if (height < lowest) lowest = height, place = {x * 500.0, z * 500.0};
      }
    }
    return place;
  }();
  return settled(settings, volume({deepest.x, 300, deepest.y}, 320, 180));
}

// What the first frame sends to the GPU when all chunks are there already.
std::uint64_t uploads(const Settings& settings) {
  static core::JobPool pool(2);
  static terrain::EndlessTerrain endless(probedLand(), pool, settings.streaming);
  terrain::TerrainStreamingSettings other = settings.streaming;
  other.gpuMiB = 120;
  endless.apply(other);
  endless.settle(small());
  endless.apply(settings.streaming);  // a changed number of layers empties them all
  endless.update(small());
  return endless.statistics().uploadedBytes;
}

// What is kept of a flight over five views.
std::uint64_t kept(const Settings& settings) {
  terrain::EndlessTerrain& endless = sharedTerrain();
  endless.apply(settings.streaming);
  for (int i = 0; i < 5; ++i) endless.settle(volume({i * 50000.0, 900, 0}, 320, 180));
  return endless.statistics().bytes;
}

// Land whose making waits until the end.
class HeldUpSource final : public terrain::HeightSource {
 public:
  terrain::HeightSample sample(glm::dvec2 xz) const override { return probedLand()->sample(xz); }
  terrain::HeightBounds bounds(glm::dvec2 lo, glm::dvec2 hi) const override {
    return probedLand()->bounds(lo, hi);
  }
  terrain::HeightBounds range() const override { return probedLand()->range(); }
  bool fillChunk(const terrain::ChunkKey&, std::stop_token stop, terrain::ChunkData&) const override {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any().wait(lock, stop, [] { return false; });
    return false;
  }
};

std::uint64_t waitingChunks(const Settings& settings) {
  core::JobPool pool(1);
  terrain::EndlessTerrain endless(std::make_shared<HeldUpSource>(), pool, settings.streaming);
  endless.update(small());
  return endless.statistics().queue;
}
}  // namespace

std::vector<Probe> landProbes() {
  return {
      {"strips.", stripHeights, {"strips.density=0.5"}},
      {"woods.density", standingTrees},
      {"villages.density", builtPlaces},
      {"villages.fields", builtPlaces},
      {"terrain.", heights},
      {"aerialImage.edgeM", groundPictures},
      {"aerialImage.share", wornGround},
      {"aerialImage.near", wornGround},
      {"aerialImage.gain", wornGround},
      {"elevation.atCentre", elevationRun},
      {"elevation.blendM", elevationHeights},
      {"elevation.", originPlace},
      {"streaming.uploadMiBPerFrame", uploads},
      {"streaming.queueLimit", waitingChunks, {"streaming.texelPixels=0.5"}},
      {"streaming.cacheMiB", kept, {"streaming.gpuMiB=128", "streaming.texelPixels=0.5"}},
      {"streaming.gpuMiB", budget, {"streaming.texelPixels=0.5"}},
      {"streaming.seaFloorDepthM", seaFloor},
      {"streaming.viewDistanceM", detail},
      {"streaming.pixelError", detail, {"streaming.cellPixels=200"}},
      {"streaming.cellPixels", detail, {"streaming.pixelError=20", "streaming.texelPixels=0.5"}},
      {"streaming.texelPixels", detail, {"streaming.cacheMiB=1024", "streaming.gpuMiB=128"}},
  };
}

}  // namespace skydrop::app
