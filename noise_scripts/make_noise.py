"""Makes the three noise textures of the clouds as DDS files (RGBA8, DX10 header), as `skydrop noise` does.

  make_noise.py FOLDER [--seed N] [--slices FIRST LAST]   # --slices: only these slices of the shape volume
"""
import argparse
import pathlib
import struct

import cloud_noise

SHAPE_SIZE, DETAIL_SIZE, WEATHER_SIZE = 128, 32, 512
DXGI_RGBA8 = 28


def dds(texels):
    """[y, x, 4] or [z, y, x, 4] bytes as a DDS file."""
    volume = texels.ndim == 4
    depth = texels.shape[0] if volume else 0
    height, width = texels.shape[-3:-1]
    flags = 0x100F | (0x800000 if volume else 0)
    header = b"DDS " + struct.pack("<7I", 124, flags, height, width, width * 4, depth, 0) + bytes(44)
    header += struct.pack("<2I4s5I", 32, 4, b"DX10", 0, 0, 0, 0, 0)
    header += struct.pack("<5I", 0x1008 if volume else 0x1000, 0x200000 if volume else 0, 0, 0, 0)
    header += struct.pack("<5I", DXGI_RGBA8, 4 if volume else 3, 0, 1, 0)
    return header + texels.tobytes()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--slices", type=int, nargs=2, metavar=("FIRST", "LAST"))
    given = parser.parse_args()
    slices = slice(given.slices[0], given.slices[1] + 1) if given.slices else None
    given.folder.mkdir(parents=True, exist_ok=True)
    textures = {
        "shape": cloud_noise.volume(cloud_noise.shape_noise, SHAPE_SIZE, given.seed, slices),
        "detail": cloud_noise.volume(cloud_noise.detail_noise, DETAIL_SIZE, given.seed),
        "weather": cloud_noise.image(cloud_noise.weather_noise, WEATHER_SIZE, given.seed),
    }
    for name, texels in textures.items():
        (given.folder / f"{name}.dds").write_bytes(dds(texels))


if __name__ == "__main__":
    main()
