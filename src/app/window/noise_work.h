// Noise textures for the tool, made and saved on a worker: the newest order counts, and no frame waits. Main
// thread.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "skydrop/core/dds.h"
#include "skydrop/core/job_pool.h"
#include "skydrop/noise/noise_generator.h"
#include "skydrop/noise/noise_recipe.h"

namespace skydrop::app {

struct NoiseOrder {
  noise::NoiseRecipe recipe;
  noise::NoiseSize size;

  bool operator==(const NoiseOrder&) const = default;
};

// A texture to look at.
struct NoiseSample {
  NoiseOrder order;
  core::TextureData texture;          // r8
  std::array<float, 64> histogram{};  // share of the texels in each of equal ranges of [0, 1]
  double seconds = 0;                 // that it took
};

// Any texture as r8: its only or its red channel, in steps of 1/255; floats are clamped.
core::TextureData viewable(const core::TextureData& texture);

// Counts the texels of an r8 texture.
std::array<float, 64> histogramOf(const core::TextureData& texture);

class NoiseWork {
 public:
  NoiseWork();
  ~NoiseWork();

  // In place of whatever is being made.
  void make(const NoiseOrder& order);
  // What is being made; nothing while there is no work.
  const std::optional<NoiseOrder>& current() const { return current_; }
  double progress() const;  // of it, 0 .. 1
  // What was finished since the last call. Throws core::DataError where it could not be made.
  std::optional<NoiseSample> take();

  // The texture at full precision, to a DDS file. One at a time: false while one is being saved.
  bool save(const NoiseOrder& order, core::TexelFormat format, core::DdsHeader header,
            const std::filesystem::path& file);
  bool isSaving() const { return saving_; }
  // How that ended, a line, once: what was written or why it was not.
  std::optional<std::string> takeSaved();

 private:
  // What the jobs hand over.
  struct Shared {
    std::mutex mutex;
    std::uint64_t newest = 0;
    double progress = 0;
    std::optional<NoiseSample> made;
    std::string failure;
    std::optional<std::string> saved;
  };

  std::shared_ptr<Shared> shared_ = std::make_shared<Shared>();
  std::optional<NoiseOrder> current_;
  std::optional<core::JobId> job_;
  bool saving_ = false;
  core::JobPool pool_{2};  // a texture is made while another is saved
};

}  // namespace skydrop::app
