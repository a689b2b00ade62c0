#include <array>
#include <cmath>
#include <map>
#include <span>

#include "app/studies/subjects.h"
#include "app/studies/table_subject.h"
#include "skydrop/core/hash.h"
#include "skydrop/noise/noise_generator.h"

namespace skydrop::app {
namespace {

enum class TexelKind { bits8, bits16, float32 };
constexpr std::array<std::string_view, 3> kTexelNames = {"bits8", "bits16", "float32"};

struct NoiseTextureParameters {
  std::int64_t side = 128;
  TexelKind texels = TexelKind::bits8;
};

void describe(core::SettingsVisitor& visitor, NoiseTextureParameters& p) {
  visitor.integer("side", p.side,
                  {.unit = "texel", .min = 16, .max = 1024, .help = "Of the volume; a power of two."});
  visitor.choice("texels", p.texels, kTexelNames, {.help = "What keeps a value."});
}

constexpr noise::NoiseSettings kSettings{.octaves = 3, .frequency = 4};
constexpr int kPlaces = 2000;
constexpr int kGrid = 4096;  // places are the middles of so many parts of the period along each axis

glm::ivec3 placeOf(int index) {
  core::RandomStream random{11, static_cast<std::uint64_t>(index) * 3};
  const auto axis = [&] { return static_cast<int>(random.nextUnit() * kGrid); };
  const int x = axis(), y = axis(), z = axis();
  return {x, y, z};
}

double kept(TexelKind kind, double value) {
  if (kind == TexelKind::float32) return value;
  const double steps = kind == TexelKind::bits8 ? 255 : 65535;
  return std::round(value * steps) / steps;
}

// Trilinear, as a sampler does it, with weights that are exact: texel(x, y, z) with wrapped indices.
template <class Texel>
double filtered(int side, const glm::ivec3& place, const Texel& texel) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    glm::ivec3 at(0);
    for (int k = 0; k < 3; ++k) {
      const double position = (place[k] + 0.5) * side / kGrid - 0.5;
      const double whole = std::floor(position), share = position - whole;
      const bool isFar = (corner >> k & 1) != 0;
      weight *= isFar ? share : 1 - share;
      at[k] = (static_cast<int>(whole) + side + (isFar ? 1 : 0)) % side;
    }
    if (weight > 0) sum += weight * texel(at);
  }
  return sum;
}

class NoiseTextureSubject final : public TableSubject<NoiseTextureParameters> {
  accuracy::Observation compute(const NoiseTextureParameters& p) override {
    const noise::NoiseGenerator generator(kSettings, sizeOf(p));
    accuracy::Observation observation;
    for (int i = 0; i < kPlaces; ++i) {
      observation.values.push_back(filtered(static_cast<int>(p.side), placeOf(i), [&](const glm::ivec3& at) {
        return kept(p.texels, generator.valueAt(at.x, at.y, at.z));
      }));
    }
    return observation;
  }

  // Reads from a texture that lies in memory.
  double work(const NoiseTextureParameters& p) override {
    const core::TextureData& texture = textureOf(p);
    const auto read = [&](const auto* texels) {
      double sum = 0;
      const auto side = static_cast<std::size_t>(p.side);
      for (int i = 0; i < kPlaces; ++i) {
        sum += filtered(static_cast<int>(p.side), placeOf(i), [&](const glm::ivec3& at) {
          return static_cast<double>(
              texels[(static_cast<std::size_t>(at.z) * side + static_cast<std::size_t>(at.y)) * side +
                     static_cast<std::size_t>(at.x)]);
        });
      }
      return sum;
    };
    const void* bytes = texture.texels.data();
    if (p.texels == TexelKind::bits8) return read(static_cast<const std::uint8_t*>(bytes));
    if (p.texels == TexelKind::bits16) return read(static_cast<const std::uint16_t*>(bytes));
    return read(static_cast<const float*>(bytes));
  }

  static noise::NoiseSize sizeOf(const NoiseTextureParameters& p) {
    const auto side = static_cast<int>(p.side);
    return {side, side, side};
  }

  const core::TextureData& textureOf(const NoiseTextureParameters& p) {
    core::TextureData& texture = textures_[{p.side, p.texels}];
    if (texture.texels.empty()) {
      const core::TexelFormat formats[] = {core::TexelFormat::r8, core::TexelFormat::r16,
                                           core::TexelFormat::r32f};
      texture =
          noise::makeNoise(kSettings, sizeOf(p), {.format = formats[static_cast<std::size_t>(p.texels)]});
    }
    return texture;
  }

  std::map<std::pair<std::int64_t, TexelKind>, core::TextureData> textures_;
};

}  // namespace

std::unique_ptr<accuracy::Subject> makeNoiseTextureSubject() {
  return std::make_unique<NoiseTextureSubject>();
}

}  // namespace skydrop::app
