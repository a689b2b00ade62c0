"""What the tables of halos and rainbows share: the spectrum of sunlight as linear sRGB, refractive indices, the sun's
disc, and DDS files of floats.

Colours are relative to sunlight above the air: a spectrum without any colour of its own is (1, 1, 1).
"""
import struct

import numpy as np

SUN_RADIUS = 0.2666  # degrees
SUN_KELVIN = 5772.0
DXGI_RGBA32_FLOAT = 2


def cie_1931(nm):
    """Colour matching functions x, y, z: the multi-lobe fit of Wyman, Sloan, Shirley (2013)."""
    def lobe(mean, below, above):
        return np.exp(-0.5 * ((nm - mean) / np.where(nm < mean, below, above)) ** 2)

    x = 1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2)
    y = 0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1)
    z = 1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)
    return np.stack([x, y, z])


# XYZ to linear sRGB (IEC 61966-2-1).
TO_SRGB = np.array([[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]])
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def wavelengths(count):
    """Middles of equal parts of the visible spectrum, nm."""
    return 390 + (700 - 390) * (np.arange(count) + 0.5) / count


def srgb_weights(nm):
    """[3, wavelengths]: what sunlight of each wavelength adds to red, green and blue; each row sums to 1."""
    planck = 1 / (nm**5 * np.expm1(1.4387769e7 / (nm * SUN_KELVIN)))
    weights = TO_SRGB @ (cie_1931(nm) * planck)
    return weights / weights.sum(axis=1, keepdims=True)


def into_gamut(rgb):
    """Colours [..., 3] without negative parts: mixed with grey of their luminance as far as it takes."""
    grey = np.maximum(rgb @ LUMINANCE, 0)[..., None]
    least = rgb.min(axis=-1, keepdims=True)
    share = np.where(least < 0, grey / np.maximum(grey - least, 1e-30), 1.0)
    return np.maximum(grey + (rgb - grey) * share, 0)


def ice_index(nm):
    """Real refractive index of ice, Warren and Brandt (2008), 390 to 700 nm."""
    table = [1.3203, 1.3194, 1.3185, 1.3177, 1.3170, 1.3163, 1.3157, 1.3151, 1.3145, 1.3140, 1.3135, 1.3130, 1.3126,
             1.3121, 1.3117, 1.3114, 1.3110, 1.3106, 1.3103, 1.3100, 1.3097, 1.3094, 1.3091, 1.3088, 1.3085, 1.3083,
             1.3080, 1.3078, 1.3076, 1.3073, 1.3071, 1.3069]
    return np.interp(nm, np.arange(390, 701, 10), table)


def water_index(nm):
    """Refractive index of water at 20 degrees C: Daimon and Masumura (2007)."""
    square = (nm / 1000) ** 2
    terms = ((5.684027565e-1, 5.101829712e-3), (1.726177391e-1, 1.821153936e-2), (2.086189578e-2, 2.620722293e-2),
             (1.130748688e-1, 1.069792721e1))
    return np.sqrt(1 + sum(a * square / (square - b) for a, b in terms))


def through_disc(values, step, axis=0):
    """Samples `step` degrees apart, of a source of a point, as the sun's disc makes them: exact where rings about the
    source are straight over half a degree. Ends are held."""
    reach = int(np.ceil(SUN_RADIUS / step)) + 1
    fine = np.linspace(-0.5, 0.5, 101)[:-1] + 0.005
    kernel = np.array([np.sqrt(np.maximum(SUN_RADIUS**2 - ((i + fine) * step) ** 2, 0)).mean()
                       for i in range(-reach, reach + 1)])
    kernel /= kernel.sum()
    padded = np.concatenate([np.repeat(values.take([0], axis), reach, axis), values,
                             np.repeat(values.take([-1], axis), reach, axis)], axis)
    count = values.shape[axis]
    return sum(k * padded.take(range(i, i + count), axis) for i, k in enumerate(kernel))


def smooth_step(x):
    t = np.clip(x, 0, 1)
    return t * t * (3 - 2 * t)


def dds(values):
    """[y, x, 3] or [z, y, x, 3] floats as a DDS file (DX10 header, R32G32B32A32_FLOAT, alpha 1)."""
    depth = values.shape[0] if values.ndim == 4 else 0
    height, width = values.shape[-3:-1]
    texels = np.concatenate([values, np.ones(values.shape[:-1] + (1,))], axis=-1)
    flags = 0x100F | (0x800000 if depth else 0)
    header = b"DDS " + struct.pack("<7I", 124, flags, height, width, width * 16, depth, 0) + bytes(44)
    header += struct.pack("<2I4s5I", 32, 4, b"DX10", 0, 0, 0, 0, 0)
    header += struct.pack("<5I", 0x1008 if depth else 0x1000, 0x200000 if depth else 0, 0, 0, 0)
    header += struct.pack("<5I", DXGI_RGBA32_FLOAT, 4 if depth else 3, 0, 1, 0)
    return header + texels.astype("<f4").tobytes()
