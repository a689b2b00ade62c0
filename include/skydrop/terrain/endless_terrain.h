// Endless land around the eye: which chunks exist, in which order they are made, where they sit on the GPU,
// and which patches of mesh are drawn. No GL; docs/terrain-streaming.md is the picture.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "skydrop/core/job_pool.h"
#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/terrain_frame.h"
#include "skydrop/terrain/terrain_streaming_settings.h"
#include "skydrop/terrain/view_volume.h"

namespace skydrop::terrain {

struct StreamingStatistics {
  std::size_t chunksWanted = 0;  // by the view, within the budgets
  std::size_t chunksDrawn = 0;   // of which the finest at each place: what covers the picture
  std::size_t patches = 0, triangles = 0;
  std::size_t queue = 0;          // chunks that wait or are being made
  std::size_t bytes = 0;          // of chunks on the processor's side
  std::size_t uploadedBytes = 0;  // by the last frame
  std::size_t overBudget = 0;     // chunks the view asked for that no budget had room for: drawn coarser
  std::size_t coarsened = 0;      // patches drawn coarser than asked because their chunk is not there (yet)
  std::uint64_t generated = 0,
                cacheHits = 0;  // since the start; a hit is a chunk found again after it was away
  std::uint64_t failures = 0;   // chunks given up after their job threw twice
};

// Owner: the main thread. The pool must outlive it. A frame is a pure function of view, settings and source
// as soon as it is settled.
class EndlessTerrain {
 public:
  // Throws core::RangeError for a source whose storedRange() is not valid.
  EndlessTerrain(std::shared_ptr<const HeightSource> source, core::JobPool& pool,
                 const TerrainStreamingSettings& settings);
  ~EndlessTerrain();
  EndlessTerrain(const EndlessTerrain&) = delete;
  EndlessTerrain& operator=(const EndlessTerrain&) = delete;

  // Takes the settings over at once; a changed number of layers or queue length voids everything on the GPU's
  // side or in the queue, and the next frames send it again.
  void apply(const TerrainStreamingSettings& settings);

  // One frame: takes in what the workers finished, asks for what is missing, cancels what is no longer
  // wanted, and says what to upload (within the budget of a frame) and what to draw. The caller carries out
  // the uploads of every frame, also of one that it does not draw. Valid until the next call. Returns at
  // once, except where the view shows a part of the world of which not even the coarsest chunk is there (the
  // first frame, a leap of tens of kilometres): then it waits for that, up to a quarter of a second.
  const TerrainFrame& update(const ViewVolume& view);

  // update() until everything that the view wants is on the GPU, waiting for workers and without a budget for
  // uploads. Gives up after `limit` (a stalled worker); isSettled() tells. For headless frames.
  const TerrainFrame& settle(const ViewVolume& view,
                             std::chrono::milliseconds limit = std::chrono::minutes(2));

  // What the last update() or settle() returned.
  const TerrainFrame& frame() const;

  // True when the last frame had all that its view wants (what was given up counts as had).
  bool isSettled() const;

  const StreamingStatistics& statistics() const;

  // One line for each chunk that was given up since the last call.
  std::vector<std::string> takeMessages();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace skydrop::terrain
