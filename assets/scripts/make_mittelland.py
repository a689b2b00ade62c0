#!/usr/bin/env python3
"""Writes mittelland.tif: a made-up land in the place of the Swiss plateau around Bern, as a GeoTIFF in LV95.

    make_mittelland.py FOLDER

65 x 60 km in cells of 200 m, whole metres, not packed, so that the bytes do not depend on a library. Nothing in it
is measured: hills, ridges and valleys are sums of bells and waves, laid where the real ones lie roughly, so that
views between the places of places.json have something to show. Standard library alone.
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


def main():
    samples = b"".join(struct.pack("<h", height(WEST + (c + 0.5) * CELL, NORTH - (r + 0.5) * CELL))
                       for r in range(HEIGHT) for c in range(WIDTH))
    rows_per_strip = 20
    strip = rows_per_strip * WIDTH * 2
    strips = HEIGHT // rows_per_strip

    def short(*values):
        return 3, len(values), b"".join(struct.pack("<H", v) for v in values)

    def long(*values):
        return 4, len(values), b"".join(struct.pack("<I", v) for v in values)

    def double(*values):
        return 12, len(values), b"".join(struct.pack("<d", v) for v in values)

    entries = {
        256: long(WIDTH), 257: long(HEIGHT), 258: short(16), 259: short(1), 262: short(1), 277: short(1),
        273: long(*[8 + i * strip for i in range(strips)]), 278: long(rows_per_strip),
        279: long(*[strip] * strips), 339: short(2), 33550: double(CELL, CELL, 0),
        33922: double(0, 0, 0, WEST, NORTH, 0),
        34735: short(1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 2056),
    }
    after = 8 + len(samples) + 2 + 12 * len(entries) + 4
    directory, extra = b"", b""
    for tag in sorted(entries):
        kind, count, value = entries[tag]
        field = value.ljust(4, b"\0") if len(value) <= 4 else struct.pack("<I", after + len(extra))
        if len(value) > 4:
            extra += value
        directory += struct.pack("<HHI", tag, kind, count) + field
    with open(os.path.join(sys.argv[1], "mittelland.tif"), "wb") as file:
        file.write(b"II*\0" + struct.pack("<I", 8 + len(samples)) + samples + struct.pack("<H", len(entries)) +
                   directory + struct.pack("<I", 0) + extra)


main()
