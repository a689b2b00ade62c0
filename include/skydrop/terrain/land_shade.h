// The shade that land throws, for one place of the sun: for every place the height below which other land
// hides the sun.
//
// Along a ray towards the sun, with the horizontal way t and the sun at an elevation e, that height is
//     S(x) = max over t > 0 of H(x + t) - t * tan(e),
// a recurrence over samples along the ray: S(x) = max(H, S)(x + step) - step * tan(e). It is swept once for
// the sun's upper limb (below: no sun) and once for its lower limb (above: all of it), each with the way to
// the edge that throws it: the penumbra of an edge is as wide as the disc is there. The samples stand on the
// rays themselves, in a sheared lattice: `along` is the axis, x or z, that is nearer to the sun's azimuth,
// and `across` the other coordinate where the ray meets along = 0. So the recurrence interpolates nothing,
// and a shadow stays sharp however far it falls.
//
// Three levels, each four times as coarse and wide as the last, around the eye. What lies beyond a level's
// side towards the sun comes from the coarser one; what lies beyond the coarsest casts no shadow. The lattice
// is counted from the world's origin: for one sun, a place has the same samples wherever the eye is. The sea,
// at height 0, is land here. The world is flat, as in all of the program.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <stop_token>
#include <unordered_map>
#include <vector>

#include "skydrop/terrain/chunk_key.h"
#include "skydrop/terrain/height_source.h"
#include "skydrop/terrain/view_volume.h"

namespace skydrop::terrain {

inline constexpr int kShadeLevels = 3;
inline constexpr int kShadeSnap = 32;  // texels in which a level follows the eye

// Heights are samples of chunks: the finest level's texels are cells of chunks of `chunkLevel` (4 m *
// 2^chunkLevel), the next one's of chunkLevel + 2, the last one's of chunkLevel + 4.
struct ShadeLayout {
  std::int32_t chunkLevel = 2;  // 0 .. kMaxChunkLevel
  int side = 512;               // texels, a multiple of kShadeSnap

  double texelM(int level) const { return cellMetres(chunkLevel + 2 * level); }
  // How far from the eye, along either axis of the lattice, a level reaches for certain.
  double reachM(int level) const { return (side / 2 - kShadeSnap) * texelM(level); }

  bool operator==(const ShadeLayout&) const = default;
};

// How the lattice lies for a place of the sun.
struct ShadeAxes {
  bool alongX = true;                         // else along z
  int towardsSun = 1;                         // the sign of the way to the sun along the axis
  double shear = 0;                           // metres across for a metre along, on a ray; -1 .. 1
  double stepM = 1;                           // horizontal way on a ray for a metre along, 1 .. sqrt(2)
  double tanUpperLimb = 0, tanLowerLimb = 0;  // of the elevations of the disc's edges, not below the horizon

  // toSun: unit. A sun in the zenith has no azimuth: any will do.
  explicit ShadeAxes(const glm::dvec3& toSun);

  // (along, across) of a place (x, z).
  glm::dvec2 fromWorld(const glm::dvec2& xz) const {
    const double along = alongX ? xz.x : xz.y;
    return {along, (alongX ? xz.y : xz.x) - shear * along};
  }
};

// What a shade is a function of, beside the land: the sun, and where its levels begin.
struct ShadeKey {
  ShadeLayout layout;
  glm::dvec3 toSun{0, 1, 0};
  // Of each level's first texel, in texels from the world's origin: along, across.
  std::array<std::array<std::int64_t, 2>, kShadeLevels> first{};

  bool operator==(const ShadeKey&) const = default;
};

// Around an eye at (x, z), metres; what is beyond kWorldLimitMetres counts as there. toSun: unit.
ShadeKey shadeKey(const ShadeLayout& layout, const glm::dvec2& eye, const glm::dvec3& toSun);

// The share of the sun's disc above a straight edge; q: where the edge is, -1 the upper limb (nothing is
// left)
// .. 1 the lower one. Within 0.0013 of the circle's segment. As in shaders/shadow/land_shadow_map.glsl.
double shareOfDisc(double q);

// Heights of the land for shades, kept from one to the next. One thread at a time. The source is shared with
// others, which it allows.
class ShadeHeights {
 public:
  explicit ShadeHeights(std::shared_ptr<const HeightSource> source) : source_(std::move(source)) {}

  // `count` heights of a line of samples of a level of detail (4 m * 2^detail apart; a coarser one than
  // chunks have leaves samples of theirs out), m, not below the sea. `line` along x (else z), from `first` on
  // along the other axis, all in samples from the origin. False if a stop was requested.
  bool read(std::int32_t detail, bool lineOfX, std::int64_t line, std::int64_t first, int count, float* out,
            const std::stop_token& stop);
  // Forgets what the last few calls of this have not used.
  void endUse();
  std::size_t bytes() const;

 private:
  struct Chunk {
    std::vector<std::uint16_t> codes;  // none: all of it is sea
    int lastUse = 0;
  };
  const Chunk* chunk(const ChunkKey& key, const std::stop_token& stop);

  std::shared_ptr<const HeightSource> source_;
  std::unordered_map<ChunkKey, Chunk, ChunkKeyHash> chunks_;
  int use_ = 0;
};

// Immutable once made: any thread.
class LandShade {
 public:
  // Takes the heights that it needs, which the first time is most of the work (docs/land-shadows.md). Empty
  // levels if a stop was requested.
  static LandShade make(ShadeHeights& heights, const ShadeKey& key, const std::stop_token& stop = {});

  const ShadeKey& key() const { return key_; }
  const ShadeAxes& axes() const { return axes_; }

  // side * side values of a level, index = along * side + across: how the land there stands to the sun, 0 ..
  // 65535 for -2 .. 2 times half the width of the penumbra (at an edge half of what it changes by from a
  // texel to the next, where that is more), 0 in its middle: shareOfDisc of it is the share of the sun that
  // is left.
  const std::vector<std::uint16_t>& clearances(int level) const { return levels_[level].clearances; }
  // That of a place (x, z) within the level, -2 .. 2, as the GPU filters it.
  double clearanceAt(int level, const glm::dvec2& xz) const;

  // side * side heights of a level, m, indexed alike, from which and below which air has none of the sun
  // (umbra; where none is so dark, below the land or the sea) and less than all of it (penumbra, at least the
  // land).
  const std::vector<float>& umbra(int level) const { return levels_[level].umbra; }
  const std::vector<float>& penumbra(int level) const { return levels_[level].penumbra; }

  // Above this, m, all air has all of the sun.
  double topM() const { return topM_; }

  // The share of the sun that land leaves at a place (x, y, z), [0, 1]; 1 beyond the coarsest level.
  double sunShare(const glm::dvec3& place) const;

  // Boxes around all the land that is not fully in the sun, and the shaded air above it. Empty: none is.
  const std::vector<Box>& shaded() const { return shaded_; }

  // Of itself, and of the heights that are kept for the next one.
  std::size_t bytes() const;

 private:
  struct Level {
    std::vector<float> umbra, penumbra;
    std::vector<float>
        ways;  // m, level, to the edge that throws the penumbra; of levels that a finer one begins with
    std::vector<std::uint16_t> clearances;
  };
  struct Limbs {
    double umbra, penumbra, way;
  };

  LandShade(const ShadeKey& key) : key_(key), axes_(key.toSun) {}
  bool sweep(int level, ShadeHeights& heights, const std::stop_token& stop);
  void noteShaded(int level, const std::vector<float>& ground, const std::vector<float>& clearance,
                  const std::vector<float>& halfWidth);
  // Of land and shade, at texels of a level (along, across), clamped to it.
  Limbs at(int level, double along, double across) const;

  ShadeKey key_;
  ShadeAxes axes_;
  std::array<Level, kShadeLevels> levels_;
  std::vector<Box> shaded_;
  std::size_t heightBytes_ = 0;
  double topM_ = 0;
};

}  // namespace skydrop::terrain
