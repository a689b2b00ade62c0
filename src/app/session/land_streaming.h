// The land of a scene while it is flown over: the threads that make it, what of it is there, and the pass
// that draws it. Main thread, on the context's thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skydrop/core/frame_statistics.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/elevation/aerial_image.h"
#include "skydrop/render/frame/renderer.h"
#include "skydrop/render/terrain/terrain_pass.h"
#include "skydrop/terrain/endless_terrain.h"

namespace skydrop::app {

class LandStreaming {
 public:
  // Adds the pass to the renderer, which must outlive this. workers: threads, at least 1.
  LandStreaming(render::Renderer& renderer, std::shared_ptr<const terrain::HeightSource> ground, int workers,
                const terrain::TerrainStreamingSettings& settings);

  // From now on the land wears these images: around a world's origin at the place. Reads all of them, which
  // takes some hundredths of a second a megatexel. Throws core::DataError.
  void wear(std::vector<std::shared_ptr<const elevation::AerialImage>> images,
            const elevation::GeoPlace& origin, const terrain::GroundPictureSettings& settings);
  // The images are read again where the settings ask for another picture of them.
  void apply(const terrain::GroundPictureSettings& settings);

  const terrain::EndlessTerrain& terrain() const { return terrain_; }
  const terrain::HeightSource& ground() const { return *ground_; }
  int workerCount() const { return workerCount_; }

  void apply(const terrain::TerrainStreamingSettings& settings) { terrain_.apply(settings); }

  // Before a frame of this view is drawn: asks for what it shows and hands the pass what is there.
  const terrain::TerrainFrame& update(const render::View& view);
  // The same, and waits until all of it is there.
  void settle(const render::View& view);

  // A line for each part of the land that could not be made since the last call.
  std::vector<std::string> takeMessages() { return terrain_.takeMessages(); }
  // Threads are added to those that are counted already.
  void writeTo(core::FrameStatistics& statistics) const;

 private:
  terrain::ViewVolume volumeOf(const render::View& view) const;
  void layStrip(const render::View& view);
  const terrain::TerrainFrame& take(const terrain::TerrainFrame& frame);

  render::Renderer& renderer_;
  std::string owner_;  // the group of passes that it was made with
  std::shared_ptr<const terrain::HeightSource> ground_;
  int workerCount_;
  core::JobPool workers_;
  terrain::EndlessTerrain terrain_;
  render::TerrainPass* pass_;  // the renderer's
  std::vector<std::shared_ptr<const elevation::AerialImage>> images_;
  elevation::GeoPlace origin_;
  terrain::GroundPictureSettings worn_;
};

}  // namespace skydrop::app
