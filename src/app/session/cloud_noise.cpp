#include "app/session/cloud_noise.h"

#include <utility>

namespace skydrop::app {
namespace {

using clouds::NoiseTexture;

constexpr int kPartsOfATexture = 8;  // frames that a graphics card is given for it

std::size_t bytesOf(NoiseTexture texture) {
  const clouds::NoiseLayout& layout = clouds::noiseLayout(texture);
  return layout.sliceBytes() * static_cast<std::size_t>(layout.slices());
}

std::size_t allBytes() {
  std::size_t bytes = 0;
  for (const NoiseTexture texture : clouds::kNoiseTextures) bytes += bytesOf(texture);
  return bytes;
}

}  // namespace

CloudNoise::CloudNoise(NoiseStore store, Maker maker)
    : store_(std::move(store)), maker_(maker), thread_([this](std::stop_token stop) { run(stop); }) {}

CloudNoise::~CloudNoise() = default;

std::shared_ptr<const clouds::PackedCloudNoise> CloudNoise::get() const {
  const std::scoped_lock lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  return packed_;
}

std::shared_ptr<const clouds::PackedCloudNoise> CloudNoise::wait() const {
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return packed_ || failure_; });
  }
  return get();
}

double CloudNoise::progress() const {
  return static_cast<double>(doneBytes_) / static_cast<double>(allBytes());
}

std::vector<std::string> CloudNoise::takeMessages() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(messages_, {});
}

void CloudNoise::makePart(render::gl::Context& context) {
  std::unique_lock lock(mutex_);
  if (!wanted_) return;
  const NoiseTexture texture = *wanted_;
  lock.unlock();
  if (!graphics_) graphics_.emplace(context, texture, kSeed);
  const double before = graphics_->progress();
  graphics_->make(clouds::noiseLayout(texture).slices() / kPartsOfATexture);
  const double share = graphics_->progress() - before;
  doneBytes_ += static_cast<std::size_t>(share * static_cast<double>(bytesOf(texture)) + 0.5);
  if (!graphics_->done()) return;
  core::TextureData made = graphics_->read();
  graphics_.reset();
  lock.lock();
  wanted_.reset();
  handedOver_ = std::move(made);
  changed_.notify_all();
}

void CloudNoise::run(std::stop_token stop) {
  try {
    std::array<core::TextureData, clouds::kNoiseTextures.size()> textures;
    bool keeps = true;  // a cache that refuses one texture refuses all: that is reported once
    for (std::size_t i = 0; i < textures.size(); ++i) {
      const NoiseTexture texture = clouds::kNoiseTextures[i];
      StoredNoise found = store_.find(texture, kSeed);
      say(std::move(found.message));
      if (found.fromCache) {
        doneBytes_ += bytesOf(texture);
      } else {
        found.texture = maker_ == Maker::graphics ? madeByGraphics(texture, stop) : make(texture, stop);
      }
      if (stop.stop_requested()) return;
      if (!found.fromCache && keeps) {
        std::string refusal = store_.keep(texture, kSeed, found.texture);
        keeps = refusal.empty();
        say(std::move(refusal));
      }
      textures[i] = std::move(found.texture);
    }
    auto packed = std::make_shared<const clouds::PackedCloudNoise>(
        clouds::packCloudNoise(textures[0], textures[1], textures[2]));
    const std::scoped_lock lock(mutex_);
    packed_ = std::move(packed);
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::current_exception();
  }
  changed_.notify_all();
}

core::TextureData CloudNoise::make(NoiseTexture texture, std::stop_token stop) {
  const clouds::NoiseLayout& layout = clouds::noiseLayout(texture);
  core::TextureData made = clouds::emptyNoise(texture);
  const std::span<std::byte> texels = made.texels;
  for (int slice = 0; slice < layout.slices() && !stop.stop_requested(); ++slice) {
    const std::size_t bytes = layout.sliceBytes();
    clouds::fillNoise(texture, kSeed, slice, texels.subspan(static_cast<std::size_t>(slice) * bytes, bytes));
    doneBytes_ += bytes;
  }
  return made;
}

core::TextureData CloudNoise::madeByGraphics(NoiseTexture texture, std::stop_token stop) {
  std::unique_lock lock(mutex_);
  wanted_ = texture;
  changed_.wait(lock, stop, [this] { return handedOver_.has_value(); });
  return std::exchange(handedOver_, std::nullopt).value_or(core::TextureData());
}

void CloudNoise::say(std::string message) {
  if (message.empty()) return;
  const std::scoped_lock lock(mutex_);
  messages_.push_back(std::move(message));
}

}  // namespace skydrop::app
