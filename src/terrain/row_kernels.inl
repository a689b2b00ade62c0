// The body of row_kernels_*.cpp, each of which defines SKYDROP_ROW_KERNELS (the name of its table) first.
// Nothing here may call a function that is not forced inline: an inline function of a header, compiled for a
// wide instruction set, could be the one copy that the linker keeps for the whole program.

#include "skydrop/terrain/chunk_data.h"
#include "terrain/lattice_noise.h"
#include "terrain/row_kernels.h"

namespace skydrop::terrain {
namespace {

constexpr int kMaxCells = kRowSize;

void nodes(std::uint64_t rowSeed, std::int64_t first, std::int64_t stride, int count, NodeRow& out) {
  float* x = out.x.data();
  float* z = out.z.data();
  for (int n = 0; n < count; ++n) {
    const NodeGradient gradient = directionOf(nodeBits(rowSeed, first + n * stride));
    x[n] = gradient.x;
    z[n] = gradient.z;
  }
}

// What a row's z leaves of the lattice cells. In cell c, with u from 0 to 1 and fade f(u):
//     west edge a + b u,  east minus west da + db u,  noise = a + b u + f (da + db u),
// and the same with the derivatives by z (per cell) of a, b, da, db.
struct alignas(64) CellRow {
  float a[kMaxCells], b[kMaxCells], da[kMaxCells], db[kMaxCells];
  float az[kMaxCells], bz[kMaxCells], daz[kMaxCells], dbz[kMaxCells];
};

void foldRow(const OctaveRow& o, CellRow& out) {
  const float w = o.w, f = o.fadeZ, fs = o.fadeSlopeZ, scale = o.amplitude;
  for (int c = 0; c < o.cells; ++c) {
    // A column's value at u = 0 of its own node, its slope by u, and their derivatives by w.
    const float westRise = o.southWestZ[c] * (w - 1.0f) - o.northWestZ[c] * w;
    const float westTurn = o.southWestX[c] - o.northWestX[c];
    const float eastRise = o.southEastZ[c] * (w - 1.0f) - o.northEastZ[c] * w;
    const float eastTurn = o.southEastX[c] - o.northEastX[c];
    const float westA = o.northWestZ[c] * w + f * westRise, westB = o.northWestX[c] + f * westTurn;
    const float eastA = o.northEastZ[c] * w + f * eastRise, eastB = o.northEastX[c] + f * eastTurn;
    const float westAz = o.northWestZ[c] + f * (o.southWestZ[c] - o.northWestZ[c]) + fs * westRise;
    const float eastAz = o.northEastZ[c] + f * (o.southEastZ[c] - o.northEastZ[c]) + fs * eastRise;
    const float westBz = fs * westTurn, eastBz = fs * eastTurn;
    // The east column's node is at u = 1.
    out.a[c] = scale * westA;
    out.b[c] = scale * westB;
    out.da[c] = scale * (eastA - eastB - westA);
    out.db[c] = scale * (eastB - westB);
    out.az[c] = scale * westAz;
    out.bz[c] = scale * westBz;
    out.daz[c] = scale * (eastAz - eastBz - westAz);
    out.dbz[c] = scale * (eastBz - westBz);
  }
}

template <bool kAdd>
SKYDROP_INLINE void put(float& out, float value) {
  out = kAdd ? out + value : value;
}

template <bool kAdd>
SKYDROP_INLINE void sampleAt(const CellRow& cells, int c, float u, float f, float fs, float perMetre,
                             float& v, float& x, float& z) {
  const float d = cells.da[c] + cells.db[c] * u;
  put<kAdd>(v, cells.a[c] + cells.b[c] * u + f * d);
  put<kAdd>(x, (cells.b[c] + f * cells.db[c] + fs * d) * perMetre);
  put<kAdd>(z, (cells.az[c] + cells.bz[c] * u + f * (cells.daz[c] + cells.dbz[c] * u)) * perMetre);
}

// Cells shorter than a vector: the loop over cells is the one that is vectorised, the inner one unrolled.
template <bool kAdd, int kPerCell>
SKYDROP_INLINE void shortCells(const OctaveRow& o, const CellRow& cells, float perMetre, float* __restrict v,
                               float* __restrict x, float* __restrict z) {
  for (int c = 0; c < o.cells; ++c) {
#pragma GCC unroll 4
    for (int k = 0; k < kPerCell; ++k) {
      const int s = c * kPerCell + k;
      sampleAt<kAdd>(cells, c, o.u[k], o.fade[k], o.fadeSlope[k], perMetre, v[s], x[s], z[s]);
    }
  }
}

// Cells of a few vectors, of constant length.
template <bool kAdd, int kPerCell>
SKYDROP_INLINE void mediumCells(const OctaveRow& o, const CellRow& cells, float perMetre, float* v, float* x,
                                float* z) {
  for (int c = 0; c < o.cells; ++c) {
    float* __restrict const cv = v + c * kPerCell;
    float* __restrict const cx = x + c * kPerCell;
    float* __restrict const cz = z + c * kPerCell;
#pragma GCC unroll 1
    for (int k = 0; k < kPerCell; ++k) {
      sampleAt<kAdd>(cells, c, o.u[k], o.fade[k], o.fadeSlope[k], perMetre, cv[k], cx[k], cz[k]);
    }
  }
}

template <bool kAdd>
SKYDROP_INLINE void noise(const OctaveRow& o, JetRow& out) {
  CellRow cells;
  foldRow(o, cells);
  // Without a gradient, what is computed for it is multiplied away.
  const float perMetre = o.carriesGradient ? o.perMetre : 0.0f;
  float* __restrict v = out.v.samples();
  float* __restrict x = out.x.samples();
  float* __restrict z = out.z.samples();
  // Small cells are filled whole: the first and the last may stick out into the padding.
  const int p = o.phase;
  switch (o.perCell) {
    case 1:
      shortCells<kAdd, 1>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 2:
      shortCells<kAdd, 2>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 4:
      shortCells<kAdd, 4>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 8:
      mediumCells<kAdd, 8>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 16:
      mediumCells<kAdd, 16>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    default:
      break;
  }
  for (int c = 0; c < o.cells; ++c) {
    const int first = c * o.perCell - p;
    const int from = first < 0 ? 0 : first;
    const int to = first + o.perCell < kRowSize ? first + o.perCell : kRowSize;
    for (int s = from; s < to; ++s) {
      sampleAt<kAdd>(cells, c, o.u[s - first], o.fade[s - first], o.fadeSlope[s - first], perMetre, v[s],
                     x[s], z[s]);
    }
  }
}

void storeNoise(const OctaveRow& octave, JetRow& out) { noise<false>(octave, out); }
void addNoise(const OctaveRow& octave, JetRow& out) { noise<true>(octave, out); }

SKYDROP_INLINE Jet<float> load(const JetRow& row, int s) {
  return {row.v.samples()[s], row.x.samples()[s], row.z.samples()[s]};
}
SKYDROP_INLINE void store(JetRow& row, int s, Jet<float> value) {
  row.v.samples()[s] = value.v;
  row.x.samples()[s] = value.x;
  row.z.samples()[s] = value.z;
}

void begin(const LandShape<float>& shapeOfCaller, RowState& state) {
  const LandShape<float> shape = shapeOfCaller;
  for (int s = 0; s < kRowSize; ++s) {
    LandFields<Jet<float>> fields{load(state.fields.continent, s),
                                  load(state.fields.range, s),
                                  load(state.fields.crest, s),
                                  load(state.fields.valley, s),
                                  {load(state.fields.hills[0], s), load(state.fields.hills[1], s),
                                   load(state.fields.hills[2], s), load(state.fields.hills[3], s)}};
    const LandState<Jet<float>> land = shape.begin(fields);
    store(state.land.height, s, land.height);
    store(state.land.strength, s, land.strength);
    store(state.land.detail, s, land.detail);
  }
}

// What a row's z leaves of the nodes of gullies: of each cell, its four corners.
struct alignas(64) GullyCellRow {
  struct Corner {
    float phase[kMaxCells], turnsX[kMaxCells], turnsZ[kMaxCells], amplitude[kMaxCells];
  };
  Corner corners[4];  // north west, north east, south west, south east
};

void foldGullies(const GullyRow& o, GullyCellRow& out) {
  for (int i = 0; i < 4; ++i) {
    const bool east = i % 2 != 0, south = i >= 2;
    const GullyNodeRow& nodes = south ? *o.south : *o.north;
    const float* const turnsX = nodes.turnsX.data() + o.firstNode + (east ? 1 : 0);
    const float* const turnsZ = nodes.turnsZ.data() + o.firstNode + (east ? 1 : 0);
    const float* const phase = nodes.phase.data() + o.firstNode + (east ? 1 : 0);
    const float* const amplitude = nodes.amplitude.data() + o.firstNode + (east ? 1 : 0);
    GullyCellRow::Corner& to = out.corners[i];
    for (int c = 0; c < o.cells; ++c) {
      const GullyCorner<float> corner =
          gullyCorner(GullyNode<float>{turnsX[c], turnsZ[c], phase[c], amplitude[c]}, east, south, o.w);
      to.phase[c] = corner.phase;
      to.turnsX[c] = corner.turnsX;
      to.turnsZ[c] = corner.turnsZ;
      to.amplitude[c] = corner.amplitude;
    }
  }
}

SKYDROP_INLINE GullyCorner<float> cornerOf(const GullyCellRow::Corner& row, int c) {
  return {row.phase[c], row.turnsX[c], row.turnsZ[c], row.amplitude[c]};
}

SKYDROP_INLINE void carveSample(const GullyRow& o, const GullyCellRow& cells, int c, int k, float perMetre,
                                float& v, float& x, float& z) {
  const Jet<float> blend =
      gullyBlend(cornerOf(cells.corners[0], c), cornerOf(cells.corners[1], c), cornerOf(cells.corners[2], c),
                 cornerOf(cells.corners[3], c), FadePlace<float>{o.u[k], o.fade[k], o.fadeSlope[k]},
                 FadePlace<float>{o.w, o.fadeZ, o.fadeSlopeZ});
  v = v + blend.v * o.metres;
  x = x + blend.x * perMetre;
  z = z + blend.z * perMetre;
}

// As with noise: cells shorter than a vector, and cells of a few vectors.
template <int kPerCell>
SKYDROP_INLINE void carveShortCells(const GullyRow& o, const GullyCellRow& cells, float perMetre,
                                    float* __restrict v, float* __restrict x, float* __restrict z) {
#pragma GCC unroll 4
  for (int k = 0; k < kPerCell; ++k) {
#pragma GCC ivdep
    for (int c = 0; c < o.cells; ++c) {
      const int s = c * kPerCell + k;
      carveSample(o, cells, c, k, perMetre, v[s], x[s], z[s]);
    }
  }
}
template <int kPerCell>
SKYDROP_INLINE void carveMediumCells(const GullyRow& o, const GullyCellRow& cells, float perMetre, float* v,
                                     float* x, float* z) {
  for (int c = 0; c < o.cells; ++c) {
    float* __restrict const cv = v + c * kPerCell;
    float* __restrict const cx = x + c * kPerCell;
    float* __restrict const cz = z + c * kPerCell;
#pragma GCC unroll 1
    for (int k = 0; k < kPerCell; ++k) carveSample(o, cells, c, k, perMetre, cv[k], cx[k], cz[k]);
  }
}

void gully(const GullyRow& octave, RowState& state) {
  const GullyRow o = octave;
  GullyCellRow cells;
  foldGullies(o, cells);
  const float perMetre = o.carriesGradient ? o.metres * o.perMetre : 0.0f;
  float* __restrict v = state.land.height.v.samples();
  float* __restrict x = state.land.height.x.samples();
  float* __restrict z = state.land.height.z.samples();
  const int p = o.phase;
  switch (o.perCell) {
    case 1:
      carveShortCells<1>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 2:
      carveShortCells<2>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 4:
      carveShortCells<4>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 8:
      carveMediumCells<8>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    case 16:
      carveMediumCells<16>(o, cells, perMetre, v - p, x - p, z - p);
      return;
    default:
      break;
  }
  for (int c = 0; c < o.cells; ++c) {
    const int first = c * o.perCell - p;
    const int from = first < 0 ? 0 : first;
    const int to = first + o.perCell < kRowSize ? first + o.perCell : kRowSize;
    for (int s = from; s < to; ++s) carveSample(o, cells, c, s - first, perMetre, v[s], x[s], z[s]);
  }
}

void gullyNodes(std::uint64_t rowSeed, std::int64_t first, int count, const RowState& state,
                GullyNodeRow& out) {
  for (int n = 0; n < count; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const GullyNode<float> node =
        gullyNode(nodeBits(rowSeed, first + n), state.land.height.x.samples()[n],
                  state.land.height.z.samples()[n], state.land.strength.v.samples()[n]);
    out.turnsX[i] = node.turnsX;
    out.turnsZ[i] = node.turnsZ;
    out.phase[i] = node.phase;
    out.amplitude[i] = node.amplitude;
  }
}

// HeightRange{}.encode and encodeNormal of chunk_data.h in float; off by one code at most, on ties.
void finish(const LandShape<float>& shapeOfCaller, const RowState& state, int count,
            std::uint16_t* __restrict heights, std::uint16_t* __restrict normals) {
  const LandShape<float> shape = shapeOfCaller;
  for (int s = 0; s < count; ++s) {
    LandState<Jet<float>> land;
    land.height = load(state.land.height, s);
    land.strength = load(state.land.strength, s);
    land.detail = load(state.land.detail, s);
    const Jet<float> height = shape.finish(land);

    constexpr auto kLowest = static_cast<float>(HeightRange{}.lowest);
    constexpr auto kStepsPerMetre = static_cast<float>(1.0 / HeightRange{}.step());
    float code = (height.v - kLowest) * kStepsPerMetre + 0.5f;
    code = code > 0.0f ? code : 0.0f;
    code = code < 65535.0f ? code : 65535.0f;
    heights[s] = static_cast<std::uint16_t>(static_cast<std::int32_t>(code));

    const float x = -height.x, z = -height.z;
    const float scale = 127.0f / ((x < 0 ? -x : x) + 1.0f + (z < 0 ? -z : z));
    const auto low = static_cast<std::int32_t>((x + z) * scale + 128.5f);
    const auto high = static_cast<std::int32_t>((x - z) * scale + 128.5f);
    normals[s] = static_cast<std::uint16_t>(low | high << 8);
  }
}

}  // namespace

extern const RowKernels SKYDROP_ROW_KERNELS;
const RowKernels SKYDROP_ROW_KERNELS{nodes, storeNoise, addNoise, begin, gully, finish, gullyNodes};

}  // namespace skydrop::terrain
