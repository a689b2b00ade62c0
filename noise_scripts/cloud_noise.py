"""The noise that clouds are made of, as numpy arrays: what shaders/shared/cloud_noise.glsl says, in 32-bit floats.

A place is in periods, [0, 1) in each direction; lattice cells are counted modulo an octave's number of cells, so every
texture tiles. Sources of the formulas stand in the shader file; a test holds the two together.
"""
import numpy as np

F = np.float32
SHAPE_SALT, DETAIL_SALT, WEATHER_SALT = 0x5F3759DF, 0x2545F491, 0x9E3779B9
SEED_STRIDE = 0x85EBCA6B


def _u32(value):
    return np.uint32(value & 0xFFFFFFFF)


def hash3(x, y, z):
    """pcg3d of Jarzynski and Olano (2020) on arrays of uint32."""
    x, y, z = (v * _u32(1664525) + _u32(1013904223) for v in (x, y, z))
    for shifted in (False, True):
        x = x + y * z
        y = y + z * x
        z = z + x * y
        if not shifted:
            x, y, z = (v ^ (v >> _u32(16)) for v in (x, y, z))
    return x, y, z


def _units(bits):
    return [(b >> _u32(8)).astype(F) * F(2.0**-24) for b in bits]


def lattice_bits(x, y, z, cells, salt):
    n = _u32(cells)
    return hash3(x % n + _u32(salt), y % n + _u32(salt * 3), z % n + _u32(salt * 7))


def _cell_and_rest(place, cells):
    at = place * F(cells)
    whole = np.floor(at)
    return whole.astype(np.uint32), at - whole


def worley3(place, cells, salt):
    """Inverted: 1 at the feature points, 0 a cell's diagonal away from the nearest."""
    (cx, ix), (cy, iy), (cz, iz) = (_cell_and_rest(p, cells) for p in place)
    ix, iy, iz = ix + F(1), iy + F(1), iz + F(1)
    back = _u32(cells - 1)
    nearest = np.full(np.broadcast_shapes(ix.shape, iy.shape, iz.shape), F(3))
    for z in range(3):
        for y in range(3):
            for x in range(3):
                bits = lattice_bits(cx + back + _u32(x), cy + back + _u32(y), cz + back + _u32(z), cells, salt)
                fx, fy, fz = _units(bits)
                dx, dy, dz = F(x) + fx - ix, F(y) + fy - iy, F(z) + fz - iz
                nearest = np.minimum(nearest, dx * dx + dy * dy + dz * dz)
    return F(1) - np.sqrt(nearest / F(3))


def worley2(place, cells, salt):
    (cx, ix), (cy, iy) = (_cell_and_rest(p, cells) for p in place[:2])
    ix, iy = ix + F(1), iy + F(1)
    back = _u32(cells - 1)
    nearest = np.full(np.broadcast_shapes(ix.shape, iy.shape), F(2))
    zero = np.zeros_like(cx)
    for y in range(3):
        for x in range(3):
            fx, fy, _ = _units(lattice_bits(cx + back + _u32(x), cy + back + _u32(y), zero, cells, salt))
            dx, dy = F(x) + fx - ix, F(y) + fy - iy
            nearest = np.minimum(nearest, dx * dx + dy * dy)
    return F(1) - np.sqrt(nearest / F(2))


def _fade(t):
    return t * t * t * (t * (t * F(6) - F(15)) + F(10))


def _mix(a, b, t):
    return a * (F(1) - t) + b * t


def perlin3(place, cells, salt):
    """Gradient noise: mean 0, standard deviation about .3."""
    (cx, x), (cy, y), (cz, z) = (_cell_and_rest(p, cells) for p in place)

    def slope(dx, dy, dz):
        gx, gy, gz = _units(lattice_bits(cx + _u32(dx), cy + _u32(dy), cz + _u32(dz), cells, salt))
        one, two = F(1), F(2)
        return (gx * two - one) * (x - F(dx)) + (gy * two - one) * (y - F(dy)) + (gz * two - one) * (z - F(dz))

    u, v, w = _fade(x), _fade(y), _fade(z)
    low = _mix(_mix(slope(0, 0, 0), slope(1, 0, 0), u), _mix(slope(0, 1, 0), slope(1, 1, 0), u), v)
    high = _mix(_mix(slope(0, 0, 1), slope(1, 0, 1), u), _mix(slope(0, 1, 1), slope(1, 1, 1), u), v)
    return _mix(low, high, w)


def perlin_fbm3(place, cells, salt):
    total = sum(F(0.5**i) * perlin3(place, cells * 2**i, salt) for i in range(4))
    return np.clip(F(0.5) + F(0.75) * total, F(0), F(1))


def filled(x, low, high):
    """A range that noise fills, stretched to [0, 1]."""
    return np.clip((x - F(low)) / (F(high) - F(low)), F(0), F(1))


def shape_noise(place, seed):
    """Low frequency, four channels: Perlin-Worley, and Worley fBm at 8, 16 and 32 cells."""
    salt = SHAPE_SALT + seed * SEED_STRIDE
    w4, w8, w16, w32, w64 = (worley3(place, n, salt) for n in (4, 8, 16, 32, 64))
    billows = F(0.625) * w4 + F(0.25) * w8 + F(0.125) * w16
    perlin_worley = billows + perlin_fbm3(place, 4, salt) * (F(1) - billows)
    return (
        filled(perlin_worley, 0.66, 1.0),
        filled(F(0.625) * w8 + F(0.25) * w16 + F(0.125) * w32, 0.5, 0.9),
        filled(F(0.625) * w16 + F(0.25) * w32 + F(0.125) * w64, 0.5, 0.9),
        filled(F(0.75) * w32 + F(0.25) * w64, 0.5, 0.9),
    )


def detail_noise(place, seed):
    """High frequency, four channels: Worley fBm at 2, 4 and 8 cells, and 1."""
    salt = DETAIL_SALT + seed * SEED_STRIDE
    w2, w4, w8, w16 = (worley3(place, n, salt) for n in (2, 4, 8, 16))
    return (
        filled(F(0.625) * w2 + F(0.25) * w4 + F(0.125) * w8, 0.5, 0.9),
        filled(F(0.625) * w4 + F(0.25) * w8 + F(0.125) * w16, 0.5, 0.9),
        filled(F(0.75) * w8 + F(0.25) * w16, 0.5, 0.9),
        np.ones_like(w2),
    )


def weather_noise(place, seed):
    """Four channels: coverage, precipitation, type (0 stratus, .5 stratocumulus, 1 cumulus), and 1."""
    salt = WEATHER_SALT + seed * SEED_STRIDE
    x, y = place
    level = (x, y, np.zeros((1,) * x.ndim, F))
    w12, w24, w48 = (worley2(place, n, salt) for n in (12, 24, 48))
    cells = F(0.625) * w12 + F(0.25) * w24 + F(0.125) * w48
    wide = perlin_fbm3(level, 5, salt)
    coverage = filled(F(0.55) * wide + F(0.45) * cells, 0.4, 0.8)
    wet = filled(coverage + F(0.5) * wide, 0.8, 1.3)
    return coverage, wet, filled(perlin_fbm3(level, 3, salt + 101), 0.19, 0.81), np.ones_like(coverage)


def quantised(channels):
    """Channels of values in [0, 1] as bytes, channel last: 255 times the value, to the nearest."""
    return np.stack([np.floor(np.clip(c, 0, 1) * F(255) + F(0.5)).astype(np.uint8) for c in channels], axis=-1)


def centres(size):
    """Places of texel centres along a side, in periods."""
    return ((np.arange(size, dtype=F) + F(0.5)) / F(size)).astype(F)


def volume(noise, size, seed, slices=None):
    """size^3 texels of a volume, indexed [z, y, x, channel], or the slices of z that `slices` picks."""
    along = centres(size)
    x, y = along[None, :], along[:, None]
    made = []
    for z in along if slices is None else along[slices]:
        channels = noise((x, y, np.full((1, 1), z, F)), seed)
        made.append(quantised([np.broadcast_to(c, (size, size)) for c in channels]))
    return np.stack(made)


def image(noise, size, seed):
    """size^2 texels of a map, indexed [y, x, channel]."""
    along = centres(size)
    return quantised([np.broadcast_to(c, (size, size)) for c in noise((along[None, :], along[:, None]), seed)])
