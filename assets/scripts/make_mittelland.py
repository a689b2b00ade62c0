#!/usr/bin/env python3
"""Writes mittelland.tif: a made-up land in the place of the Swiss plateau around Bern, as a GeoTIFF in LV95; and
mittelland_aerial.tif: a made-up aerial image of the middle of it.

    make_mittelland.py FOLDER

65 x 60 km in cells of 200 m, whole metres, not packed, so that the bytes do not depend on a library. Nothing in it
is measured: hills, ridges and valleys are sums of bells and waves, laid where the real ones lie roughly, so that
views between the places of places.json have something to show. The image has 19 x 18 km in pixels of 60 m: fields,
woods, a river, a town and roads. Standard library alone.
"""
import math
import os
import struct
import sys

WEST, NORTH, CELL = 2570000, 1235000, 200
WIDTH, HEIGHT = 325, 300


def bell(east, north, at_east, at_north, radius, height):
    d2 = ((east - at_east) ** 2 + (north - at_north) ** 2) / radius ** 2
    return height * math.exp(-d2)


def rise(low, high, value):
    t = min(max((value - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def height(east, north):
    x, y = (east - 2600000) / 1000, (north - 1200000) / 1000  # km from Bern
    # The plateau: rolling, higher towards the south.
    land = 540 - 1.8 * y
    land += 35 * math.sin(x / 2.3 + y / 5.1) * math.cos(y / 2.9 - x / 7.7)
    land += 22 * math.sin(x / 1.1 - y / 1.7) + 12 * math.cos(x / 0.71 + y / 0.83)
    # The Jura, a wall in the north-west with long folds.
    along, across = (x * 0.88 + y * 0.47), (-x * 0.47 + y * 0.88)
    jura = rise(23, 29, across)
    land += jura * (560 + 160 * math.cos((across - 29) / 1.9) + 60 * math.sin(along / 6.3))
    # The foothills of the Alps in the south-east.
    alps = rise(14, 34, x * 0.35 - y * 0.94)
    land += alps * (700 + 330 * math.sin(x / 2.1 + y / 3.3) * math.cos(y / 1.9) + 160 * math.sin(x / 0.9))
    # The valley of the Aare, from the south-east past Bern to the north.
    valley = 3.0 * math.sin(y / 6) + (0.28 * -y if y < 0 else -0.35 * y)
    land -= 70 * math.exp(-((x - 1.0 - valley) / 1.6) ** 2) * (1 - jura) * (1 - alps)
    # Two hills to look from.
    land += bell(east, north, 2600200, 1196500, 1300, 300)
    land += bell(east, north, 2606850, 1203000, 1700, 360)
    return round(land)


def hashed(*values):
    """A share of 2^32 for whole numbers, the same everywhere."""
    h = 0x9E3779B9
    for value in values:
        h = ((h ^ (value & 0xFFFFFFFF)) * 0x85EBCA6B) & 0xFFFFFFFF
        h ^= h >> 15
        h = (h * 0xC2B2AE35) & 0xFFFFFFFF
        h ^= h >> 13
    return h / 2 ** 32


def smooth(x, y, seed):
    """Value noise of period 1, [0, 1]."""
    i, k = math.floor(x), math.floor(y)
    u, v = rise(0, 1, x - i), rise(0, 1, y - k)
    top = hashed(i, k, seed) * (1 - u) + hashed(i + 1, k, seed) * u
    low = hashed(i, k + 1, seed) * (1 - u) + hashed(i + 1, k + 1, seed) * u
    return top * (1 - v) + low * v


FIELDS = [(118, 138, 72), (146, 152, 84), (178, 164, 102), (196, 182, 118), (134, 112, 82), (98, 124, 64)]


def colour(east, north):
    x, y = (east - 2600000) / 1000, (north - 1200000) / 1000
    grain = hashed(round(east), round(north), 5) - 0.5
    valley = 1.0 + 3.0 * math.sin(y / 6) + (0.28 * -y if y < 0 else -0.35 * y)
    river = abs(x - valley - 0.25 * math.sin(y * 2.1) - 0.1 * math.sin(y * 5.3))
    if river < 0.07:
        return 62, 92, 98
    town = 2.6 - math.hypot((x - 0.6) * 0.8, y + 0.4) + 1.6 * (smooth(x, y, 1) - 0.5)
    villages = smooth(x / 1.3, y / 1.3, 2) > 0.86
    if min(abs(x * 0.8 - y + 1.1), abs(x + y * 0.45 - 2.2)) < 0.045:
        return 150, 148, 144
    if town > 0.4 or villages:
        roof = hashed(math.floor(east / 90), math.floor(north / 90), 3)
        base = (158, 112, 92) if roof < 0.35 else (168, 160, 152) if roof < 0.7 else (104, 116, 82)
        return tuple(round(c * (1 + 0.25 * grain)) for c in base)
    wood = smooth(x / 1.9, y / 1.9, 4) + 0.4 * smooth(x / 0.6, y / 0.6, 6)
    wood += bell(east, north, 2600200, 1196500, 1300, 0.4) + bell(east, north, 2606850, 1203000, 1700, 0.5)
    if wood > 0.86:
        return tuple(round(c * (1 + 0.3 * grain)) for c in (46, 66, 42))
    # Fields: a lattice that is turned otherwise every few kilometres, each of one colour.
    turn = 1.5 * hashed(math.floor(x / 2.4 + smooth(x, y, 9)), math.floor(y / 2.4 + smooth(x, y, 7)), 7)
    u = 1000 * (x * math.cos(turn) - y * math.sin(turn)) / 480
    v = 1000 * (x * math.sin(turn) + y * math.cos(turn)) / 300
    base = FIELDS[int(hashed(math.floor(u), math.floor(v), 8) * len(FIELDS))]
    return tuple(round(c * (1 + 0.1 * grain)) for c in base)


def short(*values):
    return 3, len(values), b"".join(struct.pack("<H", v) for v in values)


def long(*values):
    return 4, len(values), b"".join(struct.pack("<I", v) for v in values)


def double(*values):
    return 12, len(values), b"".join(struct.pack("<d", v) for v in values)


def write(name, samples, west, north, cell, width, height, cell_bytes, tags):
    rows_per_strip = 20
    strip = rows_per_strip * width * cell_bytes
    strips = height // rows_per_strip
    entries = {
        256: long(width), 257: long(height), 259: short(1),
        273: long(*[8 + i * strip for i in range(strips)]), 278: long(rows_per_strip),
        279: long(*[strip] * strips), 33550: double(cell, cell, 0), 33922: double(0, 0, 0, west, north, 0),
        34735: short(1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 2056),
    }
    entries.update(tags)
    after = 8 + len(samples) + 2 + 12 * len(entries) + 4
    directory, extra = b"", b""
    for tag in sorted(entries):
        kind, count, value = entries[tag]
        field = value.ljust(4, b"\0") if len(value) <= 4 else struct.pack("<I", after + len(extra))
        if len(value) > 4:
            extra += value
        directory += struct.pack("<HHI", tag, kind, count) + field
    with open(os.path.join(sys.argv[1], name), "wb") as file:
        file.write(b"II*\0" + struct.pack("<I", 8 + len(samples)) + samples + struct.pack("<H", len(entries)) +
                   directory + struct.pack("<I", 0) + extra)


def main():
    samples = b"".join(struct.pack("<h", height(WEST + (c + 0.5) * CELL, NORTH - (r + 0.5) * CELL))
                       for r in range(HEIGHT) for c in range(WIDTH))
    write("mittelland.tif", samples, WEST, NORTH, CELL, WIDTH, HEIGHT, 2,
          {258: short(16), 262: short(1), 277: short(1), 339: short(2)})
    pixel, west, north, width, rows = 60, 2592000, 1210000, 320, 300
    pixels = b"".join(bytes(min(max(c, 0), 255) for c in colour(west + (x + 0.5) * pixel, north - (y + 0.5) * pixel))
                      for y in range(rows) for x in range(width))
    write("mittelland_aerial.tif", pixels, west, north, pixel, width, rows, 3,
          {258: short(8, 8, 8), 262: short(2), 277: short(3), 284: short(1)})


main()
