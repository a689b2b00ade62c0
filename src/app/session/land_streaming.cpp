#include "app/session/land_streaming.h"

#include <utility>

#include "app/session/ground.h"
#include "skydrop/terrain/strips.h"

namespace skydrop::app {
namespace {

constexpr double kStripSeenM = 8000;  // 40 m are then two pixels of 640 at a slant

}  // namespace

LandStreaming::LandStreaming(render::Renderer& renderer, std::shared_ptr<const terrain::HeightSource> ground,
                             int workers, const terrain::TerrainStreamingSettings& settings)
    : renderer_(renderer),
      owner_(renderer.group().name),
      ground_(std::move(ground)),
      workerCount_(workers),
      workers_(workers),
      terrain_(ground_, workers_, settings) {
  auto pass = std::make_unique<render::TerrainPass>(renderer.context(), hasAlpineBelts(*ground_));
  pass_ = pass.get();
  renderer.add(std::move(pass));
}

void LandStreaming::wear(std::vector<std::shared_ptr<const elevation::AerialImage>> images,
                         const elevation::GeoPlace& origin, const terrain::GroundPictureSettings& settings) {
  images_ = std::move(images);
  origin_ = origin;
  worn_ = settings;
  if (images_.empty()) return;
  const terrain::GroundPicture picture = elevation::makeGroundPicture(images_, origin_, worn_);
  render::gl::GpuResourceTracker& resources = renderer_.context().resources();
  resources.setOwner(owner_);
  pass_->wear(picture);
  resources.setOwner("");
  pass_->setWorn(worn_);
}

void LandStreaming::apply(const terrain::GroundPictureSettings& settings) {
  if (images_.empty()) return;
  if (settings.edgeM != worn_.edgeM || settings.megatexels != worn_.megatexels)
    return wear(std::move(images_), origin_, settings);
  worn_ = settings;
  pass_->setWorn(settings);
}

const terrain::TerrainFrame& LandStreaming::update(const render::View& view) {
  layStrip(view);
  return take(terrain_.update(volumeOf(view)));
}

void LandStreaming::settle(const render::View& view) {
  layStrip(view);
  take(terrain_.settle(volumeOf(view)));
}

terrain::ViewVolume LandStreaming::volumeOf(const render::View& view) const {
  terrain::ViewVolume volume = render::viewVolume(view);
  for (const render::View& other : renderer_.viewsBeside(view))
    volume.beside.push_back(render::viewVolume(other));
  return volume;
}

void LandStreaming::layStrip(const render::View& view) {
  if (const terrain::Strips* strips = ground_->strips())
    pass_->lay(strips->nearest({view.position.x, view.position.z}, kStripSeenM));
}

// What is uploaded counts for whoever made this.
const terrain::TerrainFrame& LandStreaming::take(const terrain::TerrainFrame& frame) {
  render::gl::GpuResourceTracker& resources = renderer_.context().resources();
  resources.setOwner(owner_);
  pass_->take(frame);
  resources.setOwner("");
  return frame;
}

void LandStreaming::writeTo(core::FrameStatistics& statistics) const {
  const terrain::StreamingStatistics& land = terrain_.statistics();
  statistics.threads += workerCount_;
  statistics.terrain.chunksDrawn = static_cast<std::int64_t>(land.chunksDrawn);
  statistics.terrain.triangles = static_cast<std::int64_t>(land.triangles);
  statistics.terrain.generated = static_cast<std::int64_t>(land.generated);
  statistics.terrain.cacheHits = static_cast<std::int64_t>(land.cacheHits);
  statistics.terrain.queue = static_cast<std::int64_t>(land.queue);
  statistics.terrain.bytes = static_cast<std::int64_t>(land.bytes);
  statistics.terrain.coarsened = static_cast<std::int64_t>(land.coarsened + land.overBudget);
}

}  // namespace skydrop::app
