#include "skydrop/terrain/endless_terrain.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>

#include "skydrop/core/job_queue.h"
#include "skydrop/core/lru_cache.h"
#include "terrain/chunk_selection.h"
#include "terrain/patch_bounds.h"
#include "terrain/patch_selection.h"

namespace skydrop::terrain {
namespace {

// Bytes of a chunk on the GPU.
constexpr std::size_t kArrayLayerBytes = kSampleBytes;

// Chunk rectangles whose conservative bounds are remembered: some hundred views' worth.
constexpr std::size_t kRememberedBounds = 1 << 15;

// A frame after a leap waits this long for land; then it is drawn with whatever there is.
constexpr std::chrono::milliseconds kLongestWaitForLand{250};

std::size_t bytesOf(double mebibytes) { return static_cast<std::size_t>(mebibytes * 1048576.0); }

struct MadeChunk {
  std::shared_ptr<const ChunkData> data;
  std::shared_ptr<const PatchBounds> bounds;
  std::size_t bytes() const { return byteSize(*data) + sizeof(PatchBounds); }
};

using ChunkJobs = core::JobQueue<ChunkKey, MadeChunk, ChunkKeyHash>;

ChunkJobs::Make chunkMaker(std::shared_ptr<const HeightSource> source) {
  return [source = std::move(source)](const ChunkKey& key, std::stop_token stop) {
    auto data = std::make_shared<ChunkData>(makeChunk(*source, key, stop));
    if (data->empty()) return MadeChunk{};  // stopped
    auto bounds = std::make_shared<PatchBounds>(*data);
    return MadeChunk{std::move(data), std::move(bounds)};
  };
}

// The layers of the GPU, lent out one by one.
class ArrayLayerPool {
 public:
  // Gives its layer back when it dies.
  class Lease {
   public:
    Lease(std::shared_ptr<std::vector<ArrayLayer>> free, ArrayLayer layer)
        : free_(std::move(free)), layer_(layer) {}
    Lease(Lease&& other) noexcept = default;
    Lease& operator=(Lease&&) = delete;
    ~Lease() {
      if (free_) free_->push_back(layer_);
    }
    ArrayLayer layer() const { return layer_; }

   private:
    std::shared_ptr<std::vector<ArrayLayer>> free_;
    ArrayLayer layer_;
  };

  explicit ArrayLayerPool(int count) : free_(std::make_shared<std::vector<ArrayLayer>>()) {
    for (int layer = count; layer-- > 0;) free_->push_back(layer);
  }
  bool empty() const { return free_->empty(); }
  Lease take() {
    const ArrayLayer layer = free_->back();
    free_->pop_back();
    return Lease(free_, layer);
  }

 private:
  std::shared_ptr<std::vector<ArrayLayer>> free_;
};

}  // namespace

struct EndlessTerrain::State {
  State(std::shared_ptr<const HeightSource> heightSource, core::JobPool& jobPool,
        const TerrainStreamingSettings& initial)
      : source(std::move(heightSource)),
        pool(jobPool),
        relief(measureRelief(*source)),
        cache(0),
        remembered(kRememberedBounds),
        layers(0),
        resident(0) {
    frame.heightRange = source->storedRange();
    frame.heightRange.requireValid();
    take(initial);
  }

  void take(const TerrainStreamingSettings& next) {
    const int count = std::max(1, static_cast<int>(bytesOf(next.gpuMiB) / kArrayLayerBytes));
    if (count != layerCount) {
      resident.clear();
      layerCount = count;
      layers = ArrayLayerPool(count);
      resident.setBudget(static_cast<std::size_t>(count));
    }
    if (!jobs || next.queueLimit != settings.queueLimit) {
      jobs.reset();
      jobs = std::make_unique<ChunkJobs>(pool, chunkMaker(source), static_cast<std::size_t>(next.queueLimit));
    }
    cache.setBudget(bytesOf(next.cacheMiB));
    settings = next;
  }

  HeightBounds boundsOf(const ChunkKey& key) {
    if (const HeightBounds* known = remembered.find(key)) return *known;
    const glm::dvec2 origin = chunkOrigin(key);
    const HeightBounds bounds = source->bounds(origin, origin + chunkMetres(key.level));
    remembered.insert(key, bounds, 1);
    return bounds;
  }

  // Waits for chunks without which a part of the view would be empty, if it may.
  void run(const ViewVolume& view, std::size_t uploadBudget,
           std::optional<std::chrono::milliseconds> waitForLand) {
    const ChunkBounds bounds = [this](const ChunkKey& key) { return boundsOf(key); };
    frame.lod = makeLodDistances(relief, view.pixelsPerRadian, settings);
    frame.farDistanceM = settings.farDistanceM;
    frame.seaFloorDepthM = settings.seaFloorDepthM;
    frame.layerCount = layerCount;
    frame.base = chunkOrigin(chunkAt({view.position.x, view.position.z}));
    frame.chunks.clear();

    wanted = selectChunks(view, frame.lod, settings.farDistanceM, bounds);
    dropWhatNoBudgetHolds();
    takeInFinished();
    requestMissing();
    if (waitForLand) waitForCoarsest(*waitForLand);
    sendToGpu(uploadBudget);

    const UsableChunks usable = usableChunks();
    PatchSelection selection = selectPatches(view, frame.lod, settings.farDistanceM, -settings.seaFloorDepthM,
                                             frame.base, usable, bounds);
    frame.patches = std::move(selection.patches);
    count(selection.coarsened);
  }

  // The least urgent chunks go: their ancestors, which stand before them, are drawn in their place.
  void dropWhatNoBudgetHolds() {
    const std::size_t chunkBytes = cache.statistics().entries > 0
                                       ? cache.statistics().bytes / cache.statistics().entries
                                       : kArrayLayerBytes + sizeof(ChunkData) + sizeof(PatchBounds);
    const std::size_t room =
        std::min(static_cast<std::size_t>(layerCount), bytesOf(settings.cacheMiB) / chunkBytes);
    statistics.overBudget = wanted.size() > room ? wanted.size() - room : 0;
    if (wanted.size() > room) wanted.resize(room);
    // After the chunk below, those come first that nothing can be drawn in place of.
    std::stable_partition(wanted.begin() + (wanted.empty() ? 0 : 1), wanted.end(),
                          [this](const WantedChunk& chunk) {
                            return isCoarsestInView(chunk) && !resident.contains(chunk.key);
                          });
    keys.clear();
    for (const WantedChunk& chunk : wanted) keys.push_back(chunk.key);
    for (const ChunkKey& key : keys) {
      if (!lastWanted.contains(key) && cache.contains(key)) ++statistics.cacheHits;
    }
    lastWanted.clear();
    lastWanted.insert(keys.begin(), keys.end());
    cache.setWorkingSet(keys);
    resident.setWorkingSet(keys);
  }

  void takeInFinished() {
    for (ChunkJobs::Result& result : jobs->drain()) {
      if (result.value) {
        ++statistics.generated;
        const std::size_t bytes = result.value->bytes();
        cache.insert(result.key, std::move(*result.value), bytes);
      } else {
        ++statistics.failures;
        messages.push_back("terrain: chunk " + std::to_string(result.key.x) + " " +
                           std::to_string(result.key.z) + " of level " + std::to_string(result.key.level) +
                           " is drawn coarser: " + result.failure);
      }
    }
  }

  void requestMissing() {
    std::vector<ChunkKey> missing;
    for (const ChunkKey& key : keys) {
      if (!cache.contains(key)) missing.push_back(key);
    }
    jobs->want(missing);
    statistics.queue = jobs->pending();
  }

  static bool isCoarsestInView(const WantedChunk& chunk) {
    return chunk.key.level == kMaxChunkLevel && chunk.inView;
  }

  void waitForCoarsest(std::chrono::milliseconds limit) {
    const auto end = std::chrono::steady_clock::now() + limit;
    const auto isMissing = [this](const WantedChunk& chunk) {
      return isCoarsestInView(chunk) && !cache.contains(chunk.key) && !jobs->hasGivenUp(chunk.key);
    };
    while (std::any_of(wanted.begin(), wanted.end(), isMissing) && std::chrono::steady_clock::now() < end) {
      jobs->waitForResult(end);
      takeInFinished();
      requestMissing();
    }
  }

  void sendToGpu(std::size_t budget) {
    frame.uploads.clear();
    settled = true;
    std::size_t sent = 0;
    for (const ChunkKey& key : keys) {
      if (resident.contains(key)) continue;
      const MadeChunk* made = cache.peek(key);
      if (made == nullptr) {
        settled = settled && jobs->hasGivenUp(key);
        continue;
      }
      // One chunk may always pass, however small the budget.
      if (sent > 0 && sent + kArrayLayerBytes > budget) {
        settled = false;
        continue;
      }
      if (layers.empty()) resident.makeRoom(1);
      ArrayLayerPool::Lease lease = layers.take();
      frame.uploads.push_back({lease.layer(), made->data});
      resident.insert(key, std::move(lease), 1);
      sent += kArrayLayerBytes;
    }
    statistics.uploadedBytes = sent;
  }

  // Only what this view wants, so that a settled frame does not depend on what happens to be left over; and
  // only with all ancestors, which stand before their descendants in the list.
  UsableChunks usableChunks() {
    UsableChunks usable;
    std::vector<ChunkKey> inOrder = keys;
    std::stable_sort(inOrder.begin(), inOrder.end(),
                     [](const ChunkKey& a, const ChunkKey& b) { return a.level > b.level; });
    for (const ChunkKey& key : inOrder) {
      const ArrayLayerPool::Lease* lease = resident.peek(key);
      const MadeChunk* made = cache.peek(key);
      if (lease == nullptr || made == nullptr) continue;
      if (key.level < kMaxChunkLevel && !usable.contains(parentOf(key))) continue;
      usable.emplace(key, UsableChunk{lease->layer(), made->bounds.get()});
      frame.chunks.push_back({key, lease->layer()});
    }
    return usable;
  }

  void count(std::size_t coarsened) {
    statistics.chunksWanted = wanted.size();
    statistics.chunksDrawn = static_cast<std::size_t>(
        std::count_if(wanted.begin(), wanted.end(), [](const WantedChunk& chunk) { return chunk.finest; }));
    statistics.patches = frame.patches.size();
    statistics.triangles = frame.patches.size() * kTrianglesPerPatch;
    statistics.bytes = cache.statistics().bytes;
    statistics.coarsened = coarsened;
  }

  std::shared_ptr<const HeightSource> source;
  core::JobPool& pool;
  ReliefErrors relief;
  TerrainStreamingSettings settings;
  core::LRUCache<ChunkKey, MadeChunk, ChunkKeyHash> cache;          // bytes
  core::LRUCache<ChunkKey, HeightBounds, ChunkKeyHash> remembered;  // counts entries
  int layerCount = 0;
  ArrayLayerPool layers;
  core::LRUCache<ChunkKey, ArrayLayerPool::Lease, ChunkKeyHash> resident;  // counts entries
  std::unique_ptr<ChunkJobs> jobs;
  std::vector<WantedChunk> wanted;
  std::vector<ChunkKey> keys;  // of wanted
  std::unordered_set<ChunkKey, ChunkKeyHash> lastWanted;
  TerrainFrame frame;
  StreamingStatistics statistics;
  std::vector<std::string> messages;
  bool settled = false;
};

EndlessTerrain::EndlessTerrain(std::shared_ptr<const HeightSource> source, core::JobPool& pool,
                               const TerrainStreamingSettings& settings)
    : state_(std::make_unique<State>(std::move(source), pool, settings)) {}

EndlessTerrain::~EndlessTerrain() = default;

void EndlessTerrain::apply(const TerrainStreamingSettings& settings) { state_->take(settings); }

const TerrainFrame& EndlessTerrain::update(const ViewVolume& view) {
  state_->run(view, bytesOf(state_->settings.uploadMiBPerFrame), kLongestWaitForLand);
  return state_->frame;
}

const TerrainFrame& EndlessTerrain::settle(const ViewVolume& view, std::chrono::milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  std::vector<ChunkUpload> uploads;
  while (true) {
    state_->run(view, std::numeric_limits<std::size_t>::max(), std::nullopt);
    for (ChunkUpload& upload : state_->frame.uploads) uploads.push_back(std::move(upload));
    if (state_->settled || std::chrono::steady_clock::now() >= end) break;
    state_->jobs->waitForResult(end);
  }
  state_->frame.uploads = std::move(uploads);
  state_->statistics.uploadedBytes = state_->frame.uploads.size() * kArrayLayerBytes;
  return state_->frame;
}

const TerrainFrame& EndlessTerrain::frame() const { return state_->frame; }
bool EndlessTerrain::isSettled() const { return state_->settled; }
const StreamingStatistics& EndlessTerrain::statistics() const { return state_->statistics; }
std::vector<std::string> EndlessTerrain::takeMessages() { return std::exchange(state_->messages, {}); }

}  // namespace skydrop::terrain
