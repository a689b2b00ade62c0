"""Makes a texture of gradient noise as a DDS file of floats (DX10 header, R32_FLOAT), as
`skydrop noise --generate 2d|3d --channel luminance --bits 32` does.

  make_gradient_noise.py FILE.dds --width 256 --height 256 [--slices 64] [--octaves 6] [--frequency 6] [--amplitude 0.7]
                         [--persistence 0.5] [--seed 0] [--cutoff C --density D]
"""
import argparse
import pathlib
import struct

import gradient_noise

DXGI_R32_FLOAT = 41


def dds(values):
    """[y, x] or [z, y, x] floats as a DDS file."""
    depth = values.shape[0] if values.ndim == 3 else 0
    height, width = values.shape[-2:]
    flags = 0x100F | (0x800000 if depth else 0)
    header = b"DDS " + struct.pack("<7I", 124, flags, height, width, width * 4, depth, 0) + bytes(44)
    header += struct.pack("<2I4s5I", 32, 4, b"DX10", 0, 0, 0, 0, 0)
    header += struct.pack("<5I", 0x1008 if depth else 0x1000, 0x200000 if depth else 0, 0, 0, 0)
    header += struct.pack("<5I", DXGI_R32_FLOAT, 4 if depth else 3, 0, 1, 0)
    return header + values.astype("<f4").tobytes()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=pathlib.Path)
    for name, kind, default in (("width", int, 512), ("height", int, 512), ("slices", int, 0), ("octaves", int, 6),
                                ("frequency", int, 6), ("amplitude", float, 0.7), ("persistence", float, 0.5),
                                ("seed", int, 0), ("cutoff", float, None), ("density", float, 0.96)):
        parser.add_argument("--" + name, type=kind, default=default)
    given = vars(parser.parse_args())
    file, cutoff, density = (given.pop(name) for name in ("file", "cutoff", "density"))
    if given["slices"] == 0:
        del given["slices"]
        values = gradient_noise.plane(**given)
    else:
        values = gradient_noise.volume(**given)
    if cutoff is not None:
        values = gradient_noise.cut_to_clouds(values, cutoff, density)
    file.write_bytes(dds(values))


if __name__ == "__main__":
    main()
