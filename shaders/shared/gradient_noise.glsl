// Periodic gradient noise in a plane and in space, and its sum over octaves: what skydrop::noise makes textures of. One
// definition for C++, for compute shaders and for noise_scripts/. A lattice is counted modulo its number of cells to a
// period, so every texture tiles for any whole frequency. A place is a texel, and where its centre lies among the cells
// is worked out in whole numbers: exact for sides that are powers of two, however fine the lattice. Beyond that only
// + - *: the same bits wherever arithmetic is IEEE's and nothing is contracted.
// Source: Perlin, "Improving Noise", SIGGRAPH 2002: the fade of fifth order, gradients to the edges of a cube.
// Tarantilis, "Simulating Clouds with Procedural Texturing Techniques Using the GPU", 2004, chapter III: octaves over a
// period, and the cut to clouds.
#ifndef __cplusplus
#include "shared/guards.glsl"
#include "shared/lattice_gradients.glsl"
#endif

// Tells octaves, seeds, and noise of the plane and of space (dimensions 2 and 3) apart.
FN Uint octaveSalt(Uint seed, Uint octave, Uint dimensions) {
  return latticeBits(latticeBits(seed, dimensions * kSliceStride), octave * kRowStride);
}

// The lattice cell of a texel's centre, counted from 0 within the period, and 2 * size times the position inside the
// cell. size <= 2^14 and cells <= 2^24: no product exceeds 32 bits.
FN Uvec2 cellOfTexel(Uint texel, Uint size, Uint cells) {
  Uint twice = size * Uint(2u);
  Uint step = texel * Uint(2u) + Uint(1u);
  Uint whole = cells / twice;
  Uint part = step * (cells - whole * twice);
  Uint carried = part / twice;
  return Uvec2(step * whole + carried, part - carried * twice);
}

FN Uint cellAfter(Uint cell, Uint cells) { return cell + Uint(1u) == cells ? Uint(0u) : cell + Uint(1u); }

// A node's plane a + x gx + y gy over its surroundings: what is left of a node in space once z is given.
// x: gx, y: gy, z: a.
FN Vec3 nodeInPlane(Uint column, Uint row) {
  Uint bits = latticeBits(column, row);
  return Vec3(planeGradientX(bits), planeGradientY(bits), Real(0.0));
}
FN Vec3 nodeInSpace(Uint column, Uint row, Uint nextRow, Real w, Real fadeW) {
  Uint below = latticeBits(column, row);
  Uint above = latticeBits(column, nextRow);
  return Vec3(blend(spaceGradientX(below), spaceGradientX(above), fadeW),
              blend(spaceGradientY(below), spaceGradientY(above), fadeW),
              blend(spaceGradientZ(below) * w, spaceGradientZ(above) * (w - Real(1.0)), fadeW));
}

// Between a western and an eastern node at the place u of [0, 1]: the value at the nodes' own y (x), and its slope by
// y (y).
FN Vec2 alongRow(Vec3 west, Vec3 east, Real u, Real fadeU) {
  return Vec2(blend(west.x * u + west.z, east.x * (u - Real(1.0)) + east.z, fadeU), blend(west.y, east.y, fadeU));
}

// Between a lattice row and the next at the place v of [0, 1].
FN Real betweenRows(Vec2 row, Vec2 nextRow, Real v, Real fadeV) {
  return blend(row.x + v * row.y, nextRow.x + (v - Real(1.0)) * nextRow.y, fadeV);
}

// Noise of a plane within [-1, 1]: mean 0, standard deviation about .305. `cell` lies within the period, `inside`
// in [0, 1).
FN Real gradientNoise2(Uvec2 cell, Vec2 inside, Uint cells, Uint salt) {
  Uint west = cell.x * kColumnStride;
  Uint east = cellAfter(cell.x, cells) * kColumnStride;
  Uint row = cell.y * kRowStride + salt;
  Uint nextRow = cellAfter(cell.y, cells) * kRowStride + salt;
  Real fadeU = smoothStep5(inside.x);
  return betweenRows(alongRow(nodeInPlane(west, row), nodeInPlane(east, row), inside.x, fadeU),
                     alongRow(nodeInPlane(west, nextRow), nodeInPlane(east, nextRow), inside.x, fadeU), inside.y,
                     smoothStep5(inside.y));
}

// Noise in space within [-1.04, 1.04]: mean 0, standard deviation about .27.
FN Real gradientNoise3(Uvec3 cell, Vec3 inside, Uint cells, Uint salt) {
  Uint west = cell.x * kColumnStride;
  Uint east = cellAfter(cell.x, cells) * kColumnStride;
  Uint row = cell.y * kRowStride + salt;
  Uint nextRow = cellAfter(cell.y, cells) * kRowStride + salt;
  Uint below = cell.z * kSliceStride;
  Uint above = cellAfter(cell.z, cells) * kSliceStride;
  Real w = inside.z;
  Real fadeU = smoothStep5(inside.x);
  Real fadeW = smoothStep5(w);
  return betweenRows(alongRow(nodeInSpace(west, row + below, row + above, w, fadeW),
                              nodeInSpace(east, row + below, row + above, w, fadeW), inside.x, fadeU),
                     alongRow(nodeInSpace(west, nextRow + below, nextRow + above, w, fadeW),
                              nodeInSpace(east, nextRow + below, nextRow + above, w, fadeW), inside.x, fadeU),
                     inside.y, smoothStep5(inside.y));
}

// Octaves of doubling frequency, their weights amplitude * persistence^i, as a value in [0, 1] around .5. `texel` and
// `size` in texels; `halfTexel` is 1 / (2 size).
FN Real octaveNoise2(Uvec2 texel, Uvec2 size, Vec2 halfTexel, Uint seed, Uint octaves, Uint frequency, Real amplitude,
                     Real persistence) {
  Real sum = Real(0.0);
  Real weight = amplitude;
  Uint cells = frequency;
  for (Uint i = Uint(0u); i < octaves; ++i) {
    Uvec2 x = cellOfTexel(texel.x, size.x, cells);
    Uvec2 y = cellOfTexel(texel.y, size.y, cells);
    sum += weight * gradientNoise2(Uvec2(x.x, y.x), Vec2(Real(x.y) * halfTexel.x, Real(y.y) * halfTexel.y), cells,
                                   octaveSalt(seed, i, Uint(2u)));
    weight *= persistence;
    cells = cells * Uint(2u);
  }
  return saturate(Real(0.5) + Real(0.5) * sum);
}

FN Real octaveNoise3(Uvec3 texel, Uvec3 size, Vec3 halfTexel, Uint seed, Uint octaves, Uint frequency, Real amplitude,
                     Real persistence) {
  Real sum = Real(0.0);
  Real weight = amplitude;
  Uint cells = frequency;
  for (Uint i = Uint(0u); i < octaves; ++i) {
    Uvec2 x = cellOfTexel(texel.x, size.x, cells);
    Uvec2 y = cellOfTexel(texel.y, size.y, cells);
    Uvec2 z = cellOfTexel(texel.z, size.z, cells);
    sum += weight * gradientNoise3(Uvec3(x.x, y.x, z.x),
                                   Vec3(Real(x.y) * halfTexel.x, Real(y.y) * halfTexel.y, Real(z.y) * halfTexel.z),
                                   cells, octaveSalt(seed, i, Uint(3u)));
    weight *= persistence;
    cells = cells * Uint(2u);
  }
  return saturate(Real(0.5) + Real(0.5) * sum);
}

// Noise cut to clouds: 0 up to the cutoff, 1 - density^(255 (value - cutoff)) above. logDensity is the natural
// logarithm of the density; -infinity makes a step.
FN Real cutToClouds(Real value, Real cutoff, Real logDensity) {
  return value > cutoff ? Real(1.0) - exp(logDensity * (Real(255.0) * (value - cutoff))) : Real(0.0);
}
