#include "app/window/noise_work.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <utility>

#include "app/measure/stopwatch.h"
#include "skydrop/core/error.h"
#include "skydrop/core/message.h"
#include "skydrop/core/output_file.h"

namespace skydrop::app {

core::TextureData viewable(const core::TextureData& texture) {
  core::TextureData view(core::TexelFormat::r8, texture.width, texture.height, texture.depth);
  const std::size_t stride = core::texelBytes(texture.format);
  for (std::size_t i = 0; i < view.texels.size(); ++i) {
    const std::byte* texel = texture.texels.data() + i * stride;
    switch (texture.format) {
      case core::TexelFormat::r16:
        view.texels[i] = texel[1];  // the upper half
        break;
      case core::TexelFormat::r32f:
      case core::TexelFormat::rgba32f: {
        float value = 0;
        std::memcpy(&value, texel, sizeof value);
        value = value > 0 ? std::min(value, 1.0f) : 0;  // NaN ends at 0
        view.texels[i] = static_cast<std::byte>(value * 255 + 0.5f);
        break;
      }
      default:
        view.texels[i] = texel[0];
    }
  }
  return view;
}

std::array<float, 64> histogramOf(const core::TextureData& texture) {
  std::array<std::size_t, 64> counts{};
  for (const std::byte texel : texture.texels) ++counts[std::to_integer<std::size_t>(texel) / 4];
  std::array<float, 64> shares{};
  for (std::size_t i = 0; i < counts.size(); ++i)
    shares[i] = static_cast<float>(counts[i]) / static_cast<float>(texture.texels.size());
  return shares;
}

NoiseWork::NoiseWork() = default;
NoiseWork::~NoiseWork() = default;

void NoiseWork::make(const NoiseOrder& order) {
  if (job_) pool_.cancel(*job_);
  current_ = order;
  std::uint64_t number = 0;
  {
    const std::scoped_lock lock(shared_->mutex);
    number = ++shared_->newest;
    shared_->progress = 0;
    shared_->made.reset();
    shared_->failure.clear();
  }
  job_ = pool_.submit(0, [shared = shared_, order, number](std::stop_token stop) {
    const auto ifNewest = [&](auto&& write) {
      const std::scoped_lock lock(shared->mutex);
      if (shared->newest == number) write();
    };
    try {
      const Stopwatch watch;
      noise::MakeOptions options{
          .format = core::TexelFormat::r8, .postProcess = order.recipe.postProcess, .stop = stop};
      options.progress = [&](double share) { ifNewest([&] { shared->progress = share; }); };
      NoiseSample sample{order, noise::makeNoise(order.recipe.settings, order.size, options), {}, 0};
      if (sample.texture.width == 0) return;
      sample.seconds = watch.seconds();
      sample.histogram = histogramOf(sample.texture);
      ifNewest([&] { shared->made = std::move(sample); });
    } catch (const std::exception& error) {
      ifNewest([&] { shared->failure = error.what(); });
    }
  });
}

double NoiseWork::progress() const {
  const std::scoped_lock lock(shared_->mutex);
  return shared_->progress;
}

std::optional<NoiseSample> NoiseWork::take() {
  const std::scoped_lock lock(shared_->mutex);
  if (!shared_->failure.empty()) {
    current_.reset();
    throw core::DataError("noise", "", std::exchange(shared_->failure, {}));
  }
  if (shared_->made) current_.reset();
  return std::exchange(shared_->made, std::nullopt);
}

bool NoiseWork::save(const NoiseOrder& order, core::TexelFormat format, core::DdsHeader header,
                     const std::filesystem::path& file) {
  if (saving_) return false;
  saving_ = pool_
                .submit(1,
                        [shared = shared_, order, format, header, file](std::stop_token stop) {
                          std::string line;
                          try {
                            core::OutputFile output(file);  // refused before the work
                            const core::TextureData texture = noise::makeNoise(
                                order.recipe.settings, order.size,
                                {.format = format, .postProcess = order.recipe.postProcess, .stop = stop});
                            if (texture.width == 0) return;
                            std::vector<std::byte> bytes = core::encodeDds(texture, header);
                            noise::putRecipe(bytes, order.recipe);
                            output.write(bytes);
                            line = "Saved " + core::printable(file.string());
                          } catch (const std::exception& error) {
                            line = error.what();
                          }
                          const std::scoped_lock lock(shared->mutex);
                          shared->saved = line;
                        })
                .has_value();
  return saving_;
}

std::optional<std::string> NoiseWork::takeSaved() {
  const std::scoped_lock lock(shared_->mutex);
  if (shared_->saved) saving_ = false;
  return std::exchange(shared_->saved, std::nullopt);
}

}  // namespace skydrop::app
