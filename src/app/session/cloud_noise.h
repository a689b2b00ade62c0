// The noise that the clouds of a scene are made of, prepared beside the main thread: from the cache, or made
// and put there. What the processor would have to make for a second, a graphics card makes in a few frames.
#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/session/noise_store.h"
#include "app/session/preparation.h"
#include "skydrop/clouds/cloud_field.h"
#include "skydrop/render/clouds/noise_maker.h"

namespace skydrop::app {

// Main thread. The thread that it starts ends with it, within the time of a slice (20 ms).
class CloudNoise final : public Preparation {
 public:
  // One set of textures for all scenes: skies differ by their settings and by where one flies, not by noise
  // that would have to be made for each.
  static constexpr std::uint32_t kSeed = 0;

  // Begins at once. maker: of what is not in the cache.
  CloudNoise(NoiseStore store, Maker maker);
  ~CloudNoise() override;
  CloudNoise(const CloudNoise&) = delete;
  CloudNoise& operator=(const CloudNoise&) = delete;

  // Null until it is there. Throws what ended the thread early.
  std::shared_ptr<const clouds::PackedCloudNoise> get() const;
  // Waits for it. For Maker::processor; with a graphics card the caller goes on and calls makePart().
  std::shared_ptr<const clouds::PackedCloudNoise> wait() const;

  std::string_view title() const override { return "Making the clouds"; }
  double progress() const override;
  bool isReady() const override { return get() != nullptr; }
  void waitUntilReady() const override { wait(); }
  // An eighth of the texture that is wanted, if any is.
  void makePart(render::gl::Context& context) override;
  void putResult(PreparedResources& resources) const override { resources.put(get()); }
  // A damaged file, a cache that cannot be written.
  std::vector<std::string> takeMessages() override;

 private:
  void run(std::stop_token stop);
  // Empty when it was stopped before.
  core::TextureData make(clouds::NoiseTexture texture, std::stop_token stop);
  core::TextureData madeByGraphics(clouds::NoiseTexture texture, std::stop_token stop);
  void say(std::string message);

  const NoiseStore store_;
  const Maker maker_;
  std::atomic<std::size_t> doneBytes_ = 0;

  mutable std::mutex mutex_;  // of what follows
  mutable std::condition_variable_any changed_;
  std::optional<clouds::NoiseTexture> wanted_;   // from the graphics card
  std::optional<core::TextureData> handedOver_;  // what it made of that
  std::vector<std::string> messages_;
  std::shared_ptr<const clouds::PackedCloudNoise> packed_;
  std::exception_ptr failure_;

  std::optional<render::NoiseMaker> graphics_;  // makePart()'s
  std::jthread thread_;                         // last: it works with all of the above
};

}  // namespace skydrop::app
