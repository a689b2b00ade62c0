"""Periodic gradient noise as numpy arrays: what shaders/shared/gradient_noise.glsl says, in 32-bit floats.

Lattice cells are counted modulo an octave's number of cells, so every texture tiles; where a texel's centre lies among
them is worked out in whole numbers. Sources of the formulas are named in the shader file; a test holds the two
together bit for bit.
"""
import numpy as np

F, U = np.float32, np.uint32
COLUMN_STRIDE, ROW_STRIDE, SLICE_STRIDE = U(0x9E3779B1), U(0x85EBCA77), U(0xC2B2AE3D)


def lattice_bits(column, row):
    """The last rounds of lowbias32 (Wellons, 2018) on arrays of uint32."""
    bits = np.atleast_1d(column + row).astype(U)
    bits = bits ^ (bits >> U(16))
    bits = bits * U(0x7FEB352D)
    bits = bits ^ (bits >> U(15))
    bits = bits * U(0x846CA68B)
    return bits ^ (bits >> U(16))


def octave_salt(seed, octave, dimensions):
    def word(value):
        return np.array([value & 0xFFFFFFFF], U)

    return lattice_bits(lattice_bits(word(seed), word(dimensions * int(SLICE_STRIDE))), word(octave * int(ROW_STRIDE)))


def cells_of_texels(size, cells):
    """Of each texel along a side: its lattice cell, the next one, and the position inside it."""
    exact = (2 * np.arange(size, dtype=np.uint64) + np.uint64(1)) * np.uint64(cells)
    cell, inside = exact // np.uint64(2 * size), exact % np.uint64(2 * size)
    return cell.astype(U), ((cell + np.uint64(1)) % np.uint64(cells)).astype(U), inside.astype(F) * F(0.5 / size)


def fade(t):
    return t * t * t * (t * (t * F(6) - F(15)) + F(10))


def blend(a, b, t):
    return a + t * (b - a)


def sign(bits):
    return np.where(bits & U(1), F(-1), F(1))


def plane_gradient(bits):
    """Eight directions, 45 degrees apart, of length sqrt(2)."""
    diagonal, vertical = (bits & U(0x20000000)) != 0, (bits & U(0x80000000)) != 0
    root = F(1.41421356)
    x = sign(bits >> U(30)) * np.where(diagonal, F(1), np.where(vertical, F(0), root))
    y = np.where(diagonal, sign(bits >> U(31)), sign(bits >> U(30)) * np.where(vertical, root, F(0)))
    return x, y


def space_gradient(bits):
    """To the middles of a cube's twelve edges, four of them twice (Perlin 2002)."""
    h = bits >> U(28)
    first, second = sign(h), sign(h >> U(1))
    twice = (h & U(13)) == 12
    x = np.where(h < 8, first, np.where(twice, second, F(0)))
    y = np.where(h < 8, np.where(h < 4, second, F(0)), first)
    z = np.where((h < 4) | twice, F(0), second)
    return x, y, z


def _sum_of_corners(node, x, y):
    """Nodes at the four corners of each texel's cell, blended along x, then along y."""
    (west, east, u), (row, next_row, v) = x, y
    u, v = u[None, :], v[:, None]

    def along(lattice_row):
        wx, wy, wo = node(west[None, :] * COLUMN_STRIDE, lattice_row[:, None] * ROW_STRIDE)
        ex, ey, eo = node(east[None, :] * COLUMN_STRIDE, lattice_row[:, None] * ROW_STRIDE)
        return blend(wx * u + wo, ex * (u - F(1)) + eo, fade(u)), blend(wy, ey, fade(u))

    (a, slope_a), (b, slope_b) = along(row), along(next_row)
    return blend(a + v * slope_a, b + (v - F(1)) * slope_b, fade(v))


def gradient_noise_plane(width, height, cells, salt):
    def node(column, row):
        x, y = plane_gradient(lattice_bits(column, row + salt))
        return x, y, F(0)

    return _sum_of_corners(node, cells_of_texels(width, cells), cells_of_texels(height, cells))


def gradient_noise_slice(size, z, cells, salt):
    """Slice z of a volume of size (width, height, slices)."""
    below, above, w = (part[z:z + 1] for part in cells_of_texels(size[2], cells))

    def node(column, row):
        bx, by, bz = space_gradient(lattice_bits(column, row + salt + below * SLICE_STRIDE))
        ax, ay, az = space_gradient(lattice_bits(column, row + salt + above * SLICE_STRIDE))
        return blend(bx, ax, fade(w)), blend(by, ay, fade(w)), blend(bz * w, az * (w - F(1)), fade(w))

    return _sum_of_corners(node, cells_of_texels(size[0], cells), cells_of_texels(size[1], cells))


def _octaves(noise, shape, octaves, frequency, amplitude, persistence, seed, dimensions):
    total, weight = np.zeros(shape, F), F(amplitude)
    for i in range(octaves):
        total = total + weight * noise(frequency * 2**i, octave_salt(seed, i, dimensions))
        weight = weight * F(persistence)
    return np.clip(F(0.5) + F(0.5) * total, F(0), F(1))


def plane(width, height, octaves=6, frequency=6, amplitude=0.7, persistence=0.5, seed=0):
    """Values in [0, 1], indexed [y, x]."""
    return _octaves(lambda cells, salt: gradient_noise_plane(width, height, cells, salt), (height, width), octaves,
                    frequency, amplitude, persistence, seed, 2)


def volume(width, height, slices, octaves=6, frequency=6, amplitude=0.7, persistence=0.5, seed=0):
    """Values in [0, 1], indexed [z, y, x]."""
    size = (width, height, slices)
    return np.stack([_octaves(lambda cells, salt, z=z: gradient_noise_slice(size, z, cells, salt), (height, width),
                              octaves, frequency, amplitude, persistence, seed, 3) for z in range(slices)])


def cut_to_clouds(values, cutoff, density):
    """0 up to the cutoff, 1 - density^(255 (value - cutoff)) above."""
    above = values.astype(np.float64) - cutoff
    return np.where(above > 0, 1 - np.power(float(density), 255 * np.maximum(above, 0)), 0).astype(F)
